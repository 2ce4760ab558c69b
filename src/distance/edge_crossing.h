#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/types.h"

/// The one step of the fast solver: how a shortest path that crosses an edge reaches the apex of
/// the triangle behind it, from what is known at the edge's ends.
///
/// All is in the frame of the edge, with its length as unit: ends a at (0, 0) and b at (1, 0), the
/// apex above, sources below. A function that is used for either end sees b in the mirror image,
/// where it lies at (0, 0) too.
namespace karcher {

/// What is known at one end of the edge: a straight line of length `distance - base` to a source,
/// which is itself at distance `base` from the field's source.
struct EdgeEnd {
  double distance = 0;
  double base = 0;
  /// Of the angle between the edge and the direction to the source, on the side away from the
  /// apex. Both are 0 at the source itself.
  double cosine = 0;
  double sine = 0;
  /// Whether that angle is at most pi. Otherwise the source cannot be seen through the edge.
  bool seen = false;

  double radius() const { return distance - base; }
  Vec2 source() const { return {radius() * cosine, -radius() * sine}; }
  /// Squared straight distance from the source to the other end.
  double squaredRadiusAtOtherEnd() const {
    const double r = radius();
    return r * (r - 2 * cosine) + 1;
  }
};

/// How a path arrives at the apex.
struct ApexArrival {
  double distance = kInfinity;
  double base = 0;
  Vec2 toSource = Vec2::Zero();  ///< unit, the direction back
};

namespace edge_crossing {

/// Sources at one place to this part of the distances are one source.
inline constexpr double kSameSource = 1e-9;
/// The line from a source may miss the edge by this part of it.
inline constexpr double kCrossingSlack = 1e-9;
/// How much later than straight from a's source an end b may be reached before it counts as hidden
/// from that source.
inline constexpr double kHidden = 0.1;
/// Least ratio of the bending of d^2 along the edge to that on the plane for which the ends belong
/// to one front. Below it two fronts meet.
inline constexpr double kOneFront = -0.5;
/// Below this ratio straight paths from either end's source are no shorter than the shortest, as on
/// convex surfaces, and the shortest of all counts.
inline constexpr double kConvex = 0.7;

/// The shortest way over the edge's line may pass this far beside the edge, as a part of it; it
/// then goes through the end. Further out another edge is its way.
inline constexpr double kBeside = 1e-3;

/// If the line to the midpoint of the sources passes this far beside, so does the shortest way.
inline constexpr double kFarBeside = 0.5;

inline ApexArrival mirrored(ApexArrival arrival) {
  arrival.toSource.x() = -arrival.toSource.x();
  return arrival;
}

/// Straight from the source of the end at (0, 0), if that line crosses the edge.
inline ApexArrival straight(const EdgeEnd& end, const Vec2& apex) {
  const Vec2 source = end.source();
  const double drop = apex.y() - source.y();
  const double crossing = source.x() * apex.y() - apex.x() * source.y();
  if (crossing < -kCrossingSlack * drop || crossing > (1 + kCrossingSlack) * drop) return {};
  const Vec2 back = source - apex;
  const double length = back.norm();
  return {end.base + length, end.base, back / length};
}

/// Whether `other` is reached later than straight from the source of `end` by more than kHidden.
inline bool hides(const EdgeEnd& end, const EdgeEnd& other) {
  const double later = other.distance - end.base - kHidden;
  return later > 0 && later * later > end.squaredRadiusAtOtherEnd();
}

/// Straight from the source of the end at (0, 0), where that may hide the other end. Paths over the
/// edge then come the later, the nearer they pass to that end. They do so no more than in
/// proportion: how much later distances are than straight ones is a convex function along the edge.
/// A source that is used beyond its shadow would give too short a path, which nothing would mend.
inline ApexArrival fromSource(const EdgeEnd& end, const EdgeEnd& other, const Vec2& apex) {
  ApexArrival result = straight(end, apex);
  if (result.distance < kInfinity && hides(end, other)) {
    const Vec2 source = end.source();
    const double part = cross(source, apex) / (apex.y() - source.y());
    const double later = other.distance - end.base - std::sqrt(end.squaredRadiusAtOtherEnd());
    result.distance += std::clamp(part, 0.0, 1.0) * later;
  }
  return result;
}

/// One source is the other's pseudo-source: decides on which side of the line through both the apex
/// lies. Returns false if that is not how the two sources are related.
inline bool aroundCorner(const EdgeEnd& a, const EdgeEnd& b, const Vec2& apex,
                         ApexArrival& result) {
  const Vec2 sourceA = a.source();
  const Vec2 sourceB(1 - b.radius() * b.cosine, -b.radius() * b.sine);
  const double apart = (sourceB - sourceA).norm();
  if (std::abs(apart - std::abs(a.base - b.base)) > kSameSource * (a.distance + b.distance)) {
    return false;
  }
  const bool turnsForB = a.base < b.base;
  const Vec2 lit = turnsForB ? sourceA : sourceB;
  const Vec2 corner = turnsForB ? sourceB : sourceA;
  const double side = cross(corner - lit, apex - lit);
  const bool isLit = turnsForB ? side >= 0 : side <= 0;
  if (isLit == turnsForB) {
    result = straight(a, apex);
  } else {
    result = mirrored(straight(b, {1 - apex.x(), apex.y()}));
  }
  return true;
}

/// The shortest way over the edge where the squared distance along it is the cubic through the
/// values and slopes at its ends: one Newton step from the crossing of the line to the midpoint of
/// both sources. Exact where both sources are one.
inline ApexArrival throughFront(const EdgeEnd& a, const EdgeEnd& b, const Vec2& apex) {
  const double base = std::min(a.base, b.base);
  const double ra = a.distance - base;
  const double rb = b.distance - base;
  const double value0 = ra * ra;
  const double value1 = rb * rb;
  const double slope0 = -2 * ra * a.cosine;
  const double slope1 = 2 * rb * b.cosine;
  const double c2 = 3 * (value1 - value0) - 2 * slope0 - slope1;
  const double c3 = 2 * (value0 - value1) + slope0 + slope1;

  const Vec2 source(0.5 * (1 + ra * a.cosine - rb * b.cosine), -0.5 * (ra * a.sine + rb * b.sine));
  const double drop = apex.y() - source.y();
  const double crossing = source.x() * apex.y() - apex.x() * source.y();
  if (crossing < -kFarBeside * drop || crossing > (1 + kFarBeside) * drop) return {};
  double s = std::clamp(crossing / drop, 0.0, 1.0);
  const double squared = value0 + s * (slope0 + s * (c2 + s * c3));
  if (squared > 0) {
    const double first = slope0 + s * (2 * c2 + 3 * s * c3);
    const double second = 2 * c2 + 6 * s * c3;
    const double inverseRadius = 1 / std::sqrt(squared);
    const double away = s - apex.x();
    const double inverseLength = 1 / std::sqrt(away * away + apex.y() * apex.y());
    const double slope = 0.5 * first * inverseRadius + away * inverseLength;
    const double bend =
        0.5 * inverseRadius * (second - 0.5 * first * first * inverseRadius * inverseRadius) +
        apex.y() * apex.y() * inverseLength * inverseLength * inverseLength;
    if (bend > 0) {
      const double next = s - slope / bend;
      if (next < -kBeside || next > 1 + kBeside) return {};
      s = std::clamp(next, 0.0, 1.0);
    }
  }
  const double square = value0 + s * (slope0 + s * (c2 + s * c3));
  // Distances differ by no more than the way between: the cubic may not fall below that.
  const double radius = std::max(std::sqrt(std::max(square, 0.0)), std::max(ra - s, rb - (1 - s)));
  const Vec2 back(s - apex.x(), -apex.y());
  const double length = back.norm();
  return {base + radius + length, s < 0.5 ? a.base : b.base, back / length};
}

}  // namespace edge_crossing

/// The best path over an edge both of whose ends are settled.
inline ApexArrival crossSettledEdge(const EdgeEnd& a, const EdgeEnd& b, const Vec2& apex) {
  using namespace edge_crossing;
  ApexArrival result;
  if (a.seen && b.seen) {
    const bool sameBase = std::abs(a.base - b.base) <= kSameSource * (a.distance + b.distance);
    if (!sameBase && aroundCorner(a, b, apex, result)) return result;
    const double base = std::min(a.base, b.base);
    const double bending = (b.distance - base) * b.cosine + (a.distance - base) * a.cosine;
    if (bending > kConvex) return throughFront(a, b, apex);
    if (bending > kOneFront) result = throughFront(a, b, apex);
  }
  if (a.seen) {
    const ApexArrival fromA = fromSource(a, b, apex);
    if (fromA.distance < result.distance) result = fromA;
  }
  if (b.seen) {
    const ApexArrival fromB = mirrored(fromSource(b, a, {1 - apex.x(), apex.y()}));
    if (fromB.distance < result.distance) result = fromB;
  }
  return result;
}

}  // namespace karcher

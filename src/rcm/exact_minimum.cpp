#include "rcm/exact_minimum.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "distance/exact_lengths.h"
#include "intrinsic/straightest.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// A circle around a center: its radius in mean edges, and the number of compared places on it.
struct Circle {
  double radius;
  int count;
};
/// The circles around a center of few points. The check uses the first circle.
constexpr Circle kCircles[] = {{kCheckedRadius, 64}, {0.1, 16}, {0.03, 16}};
/// The circle around a center of many points.
constexpr Circle kCircleOfMany{kCheckedRadius, 12};

/// The least decrease of K, in square mean edges, for which a center moves. It is less than the
/// promised bound kLowerBy, since lower points may lie between the compared places.
constexpr double kMovedFor = kLowerBy / 4;

/// The bound on moves. Most moves halve the distance to the minimum, and more than a dozen moves
/// occur only on surfaces of pure noise.
constexpr int kMostMoves = 24;

/// The direction, in a face's frame, from a point of the face to the farthest corner.
double farthestCorner(const Geometry& geometry, const SurfacePoint& point) {
  const Vec2 from = pointInFace(geometry, point);
  Vec2 farthest = Vec2::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec2 way = cornerInFace(geometry, point.face, k) - from;
    if (way.norm() > farthest.norm()) farthest = way;
  }
  return std::atan2(farthest.y(), farthest.x());
}

/// The direction of a vertex's longest edge, in the vertex's frame. It is 0 for a vertex on the
/// boundary, where the frame begins at the boundary itself.
double longestEdge(const Geometry& geometry, int vertex) {
  if (geometry.mesh->onBoundary[vertex]) return 0;
  int longest = geometry.mesh->outgoing[vertex];
  for (const int h : outgoingHalfedges(*geometry.mesh, vertex)) {
    if (geometry.edgeLength[h] > geometry.edgeLength[longest]) longest = h;
  }
  return geometry.cumulatedAngle[longest];
}

}  // namespace

ExactEnergy::ExactEnergy(const Geometry& geometry, const Array<SurfacePoint>& points,
                         Weights weights)
    : geometry_(geometry), points_(points), weights_(weights) {
  const auto count = static_cast<size_t>(points.count());
  guesses.assign(count, 0);
}

Array<double> ExactEnergy::at(const SurfacePoint& center, double radius,
                              const Array<SurfacePoint>& places) {
  const TriangleMesh& mesh = *geometry_.mesh;
  Array<int> faces;
  for (const SurfacePoint& place : places) faces.push_back(place.face);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const Vec3 middle = position(mesh, center);

  WindowDistance distance(geometry_);
  distance.keepImagesIn(faces);
  Array<double> sums;
  sums.assign(places.size(), 0);
  Array<double> lengths;
  lengths.assign(places.size(), 0);
  for (int i = 0; i < points_.count(); ++i) {
    const double weight = weights_.data()[i];
    if (weight == 0) continue;
    const double straight = (position(mesh, points_[i]) - middle).norm();
    // The fast solver's distances are seldom too short by more than this factor.
    constexpr double kTooShort = 1.002;
    double most = kTooShort * std::max(guesses[i], straight) + 2 * radius;
    // If a path to a place is longer than the aim, the loop raises the aim to the longest path. If
    // a place has no path yet, the loop doubles the aim. The loop ends: a farther search makes no
    // path longer, and a doubled aim finally covers the mesh.
    for (;;) {
      distance.aimAt(PathAim{middle, radius, most});
      distance.setSource(points_[i]);
      distance.grow(most);
      writeLengths(geometry_, distance, places, lengths);
      const double longest = *std::max_element(lengths.begin(), lengths.end());
      if (longest <= most || most == kInfinity) break;
      most = longest < kInfinity            ? (1 + kChainRounding) * longest
             : most < 10 * geometry_.extent ? 2 * std::max(most, geometry_.meanEdge)
                                            : kInfinity;
    }
    guesses[i] = lengths[0];
    for (int k = 0; k < places.count(); ++k) sums[k] += weight * square(lengths[k]);
  }
  return sums;
}

StraightestPath circleRadius(const Geometry& geometry, const SurfacePoint& center, double radius,
                             double part) {
  const PointLocation location = locate(*geometry.mesh, center);
  const StraightestOptions options{.maxCrossings = mostCrossingsOfSearch(*geometry.mesh)};
  const bool isVertex = location.simplex == Simplex::kVertex;
  const double start =
      isVertex ? longestEdge(geometry, location.vertex) : farthestCorner(geometry, center);
  const double all = isVertex ? geometry.totalAngle[location.vertex] : 2 * kPi;
  double direction = start + all * part;
  if (direction >= all) direction -= all;
  return isVertex ? traceFromVertex(geometry, location.vertex, direction, radius, options)
                  : traceStraightest(geometry, center, radius * unitVector(direction), options);
}

Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count) {
  Array<SurfacePoint> points;
  for (int k = 0; k < count; ++k) {
    points.push_back(circleRadius(geometry, center, radius, (k + 0.5) / count).path.end());
  }
  return points;
}

namespace {

/// The compared places: the center first, then the places of its checked circle, then others.
struct Compared {
  Array<SurfacePoint> places;
  Array<double> values;
  int checked = 0;  ///< the number of checked places, with the center
  /// Whether the lowest place counts as a minimum without another comparison. It does not count if
  /// a checked place is lower than the center by more than kLowerBy.
  bool isSettled = false;

  void take(const SurfacePoint& place, double value) {
    places.push_back(place);
    values.push_back(value);
  }
  /// The index of the lowest of the first `count` places.
  int lowestOf(int count) const {
    return static_cast<int>(std::min_element(values.begin(), values.begin() + count) -
                            values.begin());
  }
};

/// Moves from a point to the lowest compared place until none is lower by more than kMovedFor, at
/// most kMostMoves times. `compare` returns the places around its argument, with K at each.
template <class Compare>
ExactMinimum descend(const Geometry& geometry, ExactMinimum result, const Compare& compare) {
  const double squareEdge = square(geometry.meanEdge);
  bool isSettled = false;
  while (!isSettled) {
    const Compared compared = compare(result);
    const double here = compared.values[0];
    const int lowest = compared.lowestOf(compared.values.count());
    result.energy = here;
    result.isLowest =
        here - compared.values[compared.lowestOf(compared.checked)] <= kLowerBy * squareEdge;
    if (here - compared.values[lowest] <= kMovedFor * squareEdge) break;
    if (result.moves == kMostMoves) break;
    result.point = compared.places[lowest];
    result.energy = compared.values[lowest];
    ++result.moves;
    isSettled = compared.isSettled && result.isLowest;
  }
  return result;
}

/// The quadratic here + first . x + bowl |x|^2 + second . (x^2 - y^2, 2 x y) that best fits the
/// values on a circle, by Fourier coefficients. `here` is the value at the center. The unit of x is
/// the circle's radius.
struct Quadratic {
  Vec2 first = Vec2::Zero();
  Vec2 second = Vec2::Zero();
  double bowl = 0;

  Quadratic(double here, std::span<const double> onCircle) : bowl(-here) {
    const double count = static_cast<double>(onCircle.size());
    for (size_t k = 0; k < onCircle.size(); ++k) {
      const Vec2 direction = unitVector(2 * kPi * (static_cast<double>(k) + 0.5) / count);
      bowl += onCircle[k] / count;
      first += 2 * onCircle[k] / count * direction;
      second += 2 * onCircle[k] / count * rotate(direction, direction);
    }
  }

  /// The minimum of this quadratic. If its least curvature is below `leastBowl`, the function first
  /// raises the bowl until both are equal.
  Vec2 minimum(double leastBowl) const {
    const double rise = std::max(bowl, second.norm() + leastBowl);
    return Vec2(second.y() * first.y() - (rise - second.x()) * first.x(),
                second.y() * first.x() - (rise + second.x()) * first.y()) /
           (2 * (square(rise) - second.squaredNorm()));
  }

  /// The amount by which the quadratic is lower at x than at the center.
  double gainAt(const Vec2& x) const {
    return -(first.dot(x) + bowl * x.squaredNorm() + second.dot(rotate(x, x)));
  }
};

/// The minimum of the parabola through the lowest value on a circle and its two neighbors. `part`
/// is its place on the circle, as a fraction of the full angle.
struct Dip {
  double part = 0;
  double value = 0;
};
Dip dipOf(std::span<const double> onCircle) {
  const auto count = static_cast<int>(onCircle.size());
  const auto k =
      static_cast<int>(std::min_element(onCircle.begin(), onCircle.end()) - onCircle.begin());
  const auto at = [&](int i) { return onCircle[static_cast<size_t>((i + count) % count)]; };
  const double slope = (at(k + 1) - at(k - 1)) / 2;
  const double curvature = at(k + 1) - 2 * at(k) + at(k - 1);
  const double beside = curvature > 0 ? -slope / curvature : 0;
  return {(k + 0.5 + beside) / count, at(k) + slope * beside / 2};
}

/// Whether the boundary shortens no radius of a circle. The test allows places in space as near as
/// half the radius, since on steep cones distances in space are shorter than along the surface.
bool isWhole(const TriangleMesh& mesh, const Array<SurfacePoint>& places, double radius) {
  constexpr double kNearest = 0.5;
  const Vec3 center = position(mesh, places[0]);
  return std::all_of(places.begin(), places.end(), [&](const SurfacePoint& place) {
    return &place == &places[0] || (position(mesh, place) - center).norm() >= kNearest * radius;
  });
}

}  // namespace

ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start) {
  const double edge = geometry.meanEdge;
  return descend(geometry, {start}, [&](const ExactMinimum& at) {
    Compared compared;
    compared.places.push_back(at.point);
    for (const Circle& circle : kCircles) {
      for (const SurfacePoint& point :
           circleAround(geometry, at.point, circle.radius * edge, circle.count)) {
        compared.places.push_back(point);
      }
      // The search compares the smaller circles only if the center has moved.
      if (at.moves == 0) break;
    }
    compared.checked = 1 + kCircles[0].count;
    compared.values = energy.at(at.point, kCheckedRadius * edge, compared.places);
    return compared;
  });
}

ExactMinimum exactMinimumNear(const Geometry& geometry, ExactOneSourceEnergy& energy,
                              const SurfacePoint& start) {
  const double radius = kCircleOfMany.radius * geometry.meanEdge;
  // A step along the exact gradient comes first, so that the circle lies about the right place.
  const EnergyAt here = energy.at(start);
  const Vec2 way = here.step * std::min(1.0, geometry.meanEdge / here.step.norm());
  const SurfacePoint there =
      traceStraightest(geometry, start, way,
                       {.maxCrossings = mostCrossingsOfSearch(*geometry.mesh)})
          .path.end();
  const double energyThere = energy.energyAt(there);
  const bool isLower = energyThere < here.energy;
  const ExactMinimum first =
      isLower ? ExactMinimum{there, energyThere} : ExactMinimum{start, here.energy};
  return descend(geometry, first, [&](const ExactMinimum& at) {
    Compared compared;
    const auto take = [&](const SurfacePoint& place) {
      compared.take(place, energy.energyAt(place));
    };
    compared.take(at.point, at.energy);
    Array<double> onCircle;
    for (const SurfacePoint& place :
         circleAround(geometry, at.point, radius, kCircleOfMany.count)) {
      take(place);
      onCircle.push_back(compared.values.back());
    }
    const Dip dip = dipOf(onCircle);
    if (dip.value < at.energy) take(circleRadius(geometry, at.point, radius, dip.part).path.end());
    compared.checked = compared.values.count();
    if (!isWhole(*geometry.mesh, compared.places, radius)) return compared;
    // The least bowl in square mean edges. On a plane, the bowl is 0.09 for a circle of this
    // radius.
    constexpr double kLeastBowl = 0.04;
    constexpr double kFarthest = 3;
    const double squareEdge = square(geometry.meanEdge);
    const Quadratic quadratic(at.energy, onCircle);
    Vec2 lowest = quadratic.minimum(kLeastBowl * squareEdge);
    lowest *= std::min(1.0, kFarthest / lowest.norm());
    compared.isSettled = lowest.norm() <= 1;
    if (!compared.isSettled || quadratic.gainAt(lowest) > kMovedFor * squareEdge) {
      const double part = std::atan2(lowest.y(), lowest.x()) / (2 * kPi);
      const double length = lowest.norm() * radius;
      take(circleRadius(geometry, at.point, length, part < 0 ? part + 1 : part).path.end());
    }
    return compared;
  });
}

}  // namespace karcher

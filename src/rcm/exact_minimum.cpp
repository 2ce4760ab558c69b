#include "rcm/exact_minimum.h"

#include <algorithm>
#include <cmath>

#include "distance/exact_distance.h"
#include "intrinsic/straightest.h"

namespace karcher {
namespace {

/// The circles round a center, in mean edges, the checked one first.
struct Circle {
  double radius;
  int count;
};
constexpr Circle kCircles[] = {{kCheckedRadius, 64}, {0.1, 16}, {0.03, 16}};

/// A center is moved where a point is lower by this part of a square mean edge: less than what is
/// promised, since points lie between those that are tried.
constexpr double kMovedFor = kLowerBy / 4;

/// Most moves shorten the way by half; more than a dozen only where the surface is all noise.
constexpr int kMostMoves = 24;

/// Straightest paths of part of a mean edge cross more edges than this only among needles.
constexpr int kMostCrossings = 1000;

/// The least length among a face's images, and over its corners.
double lengthTo(const Geometry& geometry, const ExactDistance& distance, const SurfacePoint& to) {
  const Vec2 point = pointInFace(geometry, to);
  double length = kInfinity;
  for (const SourceImage& image : distance.images()) {
    if (image.face == to.face) length = std::min(length, lengthFrom(image, point));
  }
  for (int k = 0; k < 3; ++k) {
    const int vertex = geometry.mesh->corner(to.face, k);
    length = std::min(
        length, distance.distance(vertex) + (point - cornerInFace(geometry, to.face, k)).norm());
  }
  return length;
}

/// The direction, in the frame of a face, from a point of it to the farthest corner.
double farthestCorner(const Geometry& geometry, const SurfacePoint& point) {
  const Vec2 from = pointInFace(geometry, point);
  Vec2 farthest = Vec2::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec2 way = cornerInFace(geometry, point.face, k) - from;
    if (way.norm() > farthest.norm()) farthest = way;
  }
  return std::atan2(farthest.y(), farthest.x());
}

/// The direction, in the frame of a vertex, of its longest edge; 0 at the boundary, where frames
/// begin.
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

  ExactDistance distance(geometry_);
  distance.keepImagesIn(faces);
  Array<double> sums;
  sums.assign(places.size(), 0);
  Array<double> lengths;
  lengths.assign(places.size(), 0);
  for (int i = 0; i < points_.count(); ++i) {
    const double weight = weights_.data()[i];
    if (weight == 0) continue;
    const double straight = (position(mesh, points_[i]) - middle).norm();
    // What the fast solver finds is seldom shorter than the truth by more than this.
    constexpr double kTooShort = 1.002;
    double most = kTooShort * std::max(guesses[i], straight) + 2 * radius;
    // A search that is aimed too short ends with a path that is long enough, or goes further.
    for (;;) {
      distance.aimAt(ExactDistance::Aim{middle, radius, most});
      distance.setSource(points_[i]);
      distance.grow(most);
      double longest = 0;
      for (int k = 0; k < places.count(); ++k) {
        lengths[k] = lengthTo(geometry_, distance, places[k]);
        longest = std::max(longest, lengths[k]);
      }
      if (longest <= most || most == kInfinity) break;
      constexpr double kFurther = 1.5;
      constexpr double kRounding = 1 + 1e-9;
      most = longest < kInfinity            ? kRounding * longest
             : most < 10 * geometry_.extent ? kFurther * most
                                            : kInfinity;
    }
    guesses[i] = lengths[0];
    for (int k = 0; k < places.count(); ++k) sums[k] += weight * square(lengths[k]);
  }
  return sums;
}

double circleStart(const Geometry& geometry, const SurfacePoint& center) {
  const PointLocation location = locate(*geometry.mesh, center);
  return location.simplex == Simplex::kVertex ? longestEdge(geometry, location.vertex)
                                              : farthestCorner(geometry, center);
}

Array<StraightestPath> circleRadii(const Geometry& geometry, const SurfacePoint& center,
                                   double radius, int count) {
  const PointLocation location = locate(*geometry.mesh, center);
  const StraightestOptions options{.maxCrossings = kMostCrossings};
  const bool isVertex = location.simplex == Simplex::kVertex;
  const double all = isVertex ? geometry.totalAngle[location.vertex] : 2 * kPi;
  const double first = circleStart(geometry, center);
  Array<StraightestPath> radii;
  for (int k = 0; k < count; ++k) {
    const double direction = std::fmod(first + all * (k + 0.5) / count, all);
    radii.push_back(
        isVertex ? traceFromVertex(geometry, location.vertex, direction, radius, options)
                 : traceStraightest(geometry, center, radius * unitVector(direction), options));
  }
  return radii;
}

Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count) {
  Array<SurfacePoint> points;
  for (const StraightestPath& path : circleRadii(geometry, center, radius, count)) {
    points.push_back(path.path.end());
  }
  return points;
}

ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start) {
  const double edge = geometry.meanEdge;
  ExactMinimum result{start, true, 0};
  for (;; ++result.moves) {
    Array<SurfacePoint> places{result.point};
    for (const Circle& circle : kCircles) {
      for (const SurfacePoint& point :
           circleAround(geometry, result.point, circle.radius * edge, circle.count)) {
        places.push_back(point);
      }
      // The smaller circles only where the center is moved.
      if (result.moves == 0) break;
    }
    const Array<double> values = energy.at(result.point, kCheckedRadius * edge, places);
    const auto lowestOf = [&](int count) {
      return static_cast<int>(std::min_element(values.begin(), values.begin() + count) -
                              values.begin());
    };
    const int onCircle = lowestOf(1 + kCircles[0].count);
    const int lowest = lowestOf(places.count());
    const double mostLower = kMovedFor * square(edge);
    result.isLowest = values[0] - values[onCircle] <= kLowerBy * square(edge);
    if (values[0] - values[lowest] <= mostLower || result.moves == kMostMoves) return result;
    result.point = places[lowest];
  }
}

}  // namespace karcher

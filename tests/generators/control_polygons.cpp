#include "generators/control_polygons.h"

#include <stdexcept>

#include "generators/random_points.h"

namespace karcher {
namespace {

constexpr int kMostAttempts = 1000;

/// One attempt; empty if a leg meets the boundary.
Array<SurfacePoint> attempt(const Geometry& geometry, Random& random,
                            const ControlPolygonOptions& options) {
  Array<SurfacePoint> polygon = {randomPoint(*geometry.mesh, random)};
  Vec2 direction = unitVector(random.uniform(-kPi, kPi));
  while (polygon.count() < options.points) {
    const double length = options.spacing * geometry.diagonal *
                          random.uniform(1 - options.variation, 1 + options.variation);
    const StraightestPath leg = traceStraightest(geometry, polygon.back(), length * direction);
    if (leg.stop != TraceStop::kComplete) return {};
    polygon.push_back(leg.path.end());
    direction =
        rotate(unitVector(random.uniform(-options.turning, options.turning)), leg.direction);
  }
  return polygon;
}

}  // namespace

Array<SurfacePoint> randomControlPolygon(const Geometry& geometry, Random& random,
                                         const ControlPolygonOptions& options) {
  for (int i = 0; i < kMostAttempts; ++i) {
    Array<SurfacePoint> polygon = attempt(geometry, random, options);
    if (!polygon.empty()) return polygon;
  }
  throw std::runtime_error("control polygons of this spacing do not fit on the mesh: each of " +
                           std::to_string(kMostAttempts) + " met its boundary");
}

Array<SurfacePoint> dragPath(const Geometry& geometry, const SurfacePoint& start,
                             const Vec2& direction, double step, int steps) {
  Array<SurfacePoint> path = {start};
  Vec2 ahead = direction.normalized();
  while (path.count() <= steps) {
    const StraightestPath piece = traceStraightest(geometry, path.back(), step * ahead);
    if (piece.stop != TraceStop::kComplete) return {};
    path.push_back(piece.path.end());
    ahead = piece.direction;
  }
  return path;
}

}  // namespace karcher

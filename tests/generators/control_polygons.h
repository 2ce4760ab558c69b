#pragma once

#include "generators/random.h"
#include "intrinsic/straightest.h"

/// Random control polygons that resemble those of users: nearly even points, with gentle turns.
namespace karcher {

struct ControlPolygonOptions {
  int points = 4;
  /// The mean length of a leg, in parts of the bounding box's diagonal.
  double spacing = 0.1;
  /// The largest deviation of a leg's length from the mean, as a part of it.
  double variation = 0.2;
  /// The largest angle between the continuation of a leg and the next leg, in radians.
  double turning = 0.9;
};

/// A random polygon. Its first point lies in a uniformly chosen face. Each leg is a straightest
/// geodesic that leaves at a random angle from the last one's direction. Polygons that meet the
/// boundary are drawn again. Throws std::runtime_error after a thousand such attempts.
Array<SurfacePoint> randomControlPolygon(const Geometry& geometry, Random& random,
                                         const ControlPolygonOptions& options);

/// The places of a point in a drag of `steps` steps along a straightest geodesic, in a direction of
/// the frame of its face, including the start. Empty if the path would meet the boundary.
Array<SurfacePoint> dragPath(const Geometry& geometry, const SurfacePoint& start,
                             const Vec2& direction, double step, int steps);

}  // namespace karcher

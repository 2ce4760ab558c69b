#pragma once

#include "generators/random.h"
#include "intrinsic/straightest.h"

/// Random control polygons as people click them: points about evenly spaced, turning gently.
namespace karcher {

struct ControlPolygonOptions {
  int points = 4;
  /// The mean length of a leg, in parts of the bounding box's diagonal.
  double spacing = 0.1;
  /// Legs are so much shorter or longer at most, as a part of the mean.
  double variation = 0.2;
  /// The largest angle between a leg's way on and the next leg, radians.
  double turning = 0.9;
};

/// The first point lies in a face chosen evenly; each leg is a straightest geodesic, which sets off
/// at a random angle from where the last one was going. Polygons that meet the boundary are drawn
/// again. Throws std::runtime_error where a thousand of them did.
Array<SurfacePoint> randomControlPolygon(const Geometry& geometry, Random& random,
                                         const ControlPolygonOptions& options);

/// The places of a point that is dragged `steps` steps along a straightest geodesic, in a direction
/// of the frame of its face: the first one is the start itself. None where the path would meet the
/// boundary.
Array<SurfacePoint> dragPath(const Geometry& geometry, const SurfacePoint& start,
                             const Vec2& direction, double step, int steps);

}  // namespace karcher

#pragma once

#include "bindings/mesh_handle.h"
#include "curves/curve.h"
#include "distance/find_path.h"

namespace karcher::bindings {

/// Legs of a control polygon as they travel: a list with the points that each goes through, empty
/// for the shortest path; an empty list where all are shortest.
class Legs {
 public:
  /// The legs of a curve's value with these points; those that are drawn, an Int32Array of 0 and 1,
  /// are told by all their points, with their own ends. Those that it was asked for the last time
  /// are not searched for again. Throws Error kUnreachable for waypoints on another component than
  /// the leg's ends, and the errors of points.
  Array<SurfacePath> fromJs(const MeshHandle& mesh, const Array<SurfacePoint>& points,
                            const val& legs, const val& areDrawn);

 private:
  struct Leg {
    SurfacePoint from;
    SurfacePoint to;
    Array<SurfacePoint> waypoints;
    SurfacePath path;
  };

  Array<Leg> known_;
};

/// The legs of a curve's value, whose shortest ones are found with these options.
val legsToJs(const MeshHandle& mesh, const Array<SurfacePath>& legs,
             const FindPathOptions& shortest);

/// A list with {path, shorter} for each of a curve's legs: a path (path.h), and the path between
/// its ends that is shorter, if it is known to be another one.
val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve);

}  // namespace karcher::bindings

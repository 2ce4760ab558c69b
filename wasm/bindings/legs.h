#pragma once

#include "bindings/mesh_handle.h"
#include "curves/curve.h"
#include "distance/find_path.h"

namespace karcher::bindings {

/// Conversion of a control polygon's legs: a list with the points that each leg passes through,
/// empty for the shortest path; an empty list if all are shortest.
class Legs {
 public:
  /// The legs of a curve's value with these points; those marked in `areDrawn`, an Int32Array of 0
  /// and 1, are given by all their points, with their own ends. Legs of the last call are not
  /// searched for again. Throws Error kUnreachable for waypoints on another component than the
  /// leg's ends, and what `pointsFromJs` throws.
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

/// The legs of a curve's value; the shortest ones are found with these options.
val legsToJs(const MeshHandle& mesh, const Array<SurfacePath>& legs,
             const FindPathOptions& shortest);

/// A list with {path, shorter} for each of a curve's legs: its path (path.h), and the path between
/// its ends that is shorter, if one is known.
val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve);

}  // namespace karcher::bindings

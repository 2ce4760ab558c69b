#pragma once

#include "bindings/mesh_handle.h"
#include "curves/curve.h"
#include "distance/find_path.h"

namespace karcher::bindings {

/// Conversion of a control polygon's legs. The list has, for each leg, the points that it passes;
/// the shortest path has none. It is empty if all legs are shortest.
class Legs {
 public:
  /// The legs of a curve's value with these points. `areDrawn`, an Int32Array of 0 and 1, marks
  /// legs for which the list has all points, with their own ends. Legs of the last call need no new
  /// search. Throws Error kUnreachable for waypoints on another component than the leg's ends, and
  /// what `pointsFromJs` throws.
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

/// The legs of a curve's value. A search with these options recognises the shortest ones.
val legsToJs(const MeshHandle& mesh, const Array<SurfacePath>& legs,
             const FindPathOptions& shortest);

/// A list with {path, shorter} for each of a curve's legs: its path (path.h), and the path between
/// its ends that is shorter, if one is known.
val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve);

}  // namespace karcher::bindings

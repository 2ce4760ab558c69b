#pragma once

#include "bindings/mesh_handle.h"
#include "curves/curve.h"
#include "distance/find_path.h"

namespace karcher::bindings {

/// Conversion of a control polygon's legs. The list has, for each leg, the points that it passes,
/// which are none for the shortest path. It is empty if all legs are shortest.
class Legs {
 public:
  /// The legs of a curve's value with these points. `areDrawn`, an Int32Array of 0 and 1, marks
  /// legs given by all their points, with their own ends. Legs of the last call are not searched
  /// again. Throws Error kUnreachable for waypoints on another component than the leg's ends, and
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

/// The legs of a curve's value. The shortest ones are recognised by a search with these options.
val legsToJs(const MeshHandle& mesh, const Array<SurfacePath>& legs,
             const FindPathOptions& shortest);

/// A list with {path, shorter} for each of a curve's legs: its path (path.h), and the path between
/// its ends that is shorter, if one is known.
val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve);

}  // namespace karcher::bindings

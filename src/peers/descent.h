#pragma once

#include "rcm/field_blend.h"
#include "rcm/search_end.h"

/// Paths by piecewise-linear descent of a distance field: R. Kimmel, J. Sethian, "Computing
/// geodesic paths on manifolds", Proceedings of the National Academy of Sciences 95 (1998); the
/// magenta path of Mancinelli and Puppo's Fig. 3. Distances at the vertices determine a linear
/// function in each face, with a constant gradient. From the start the path descends against the
/// gradient from face to face. If the descent in both faces of an edge leads to the edge, the path
/// follows the edge. At a vertex it takes the steepest descent.
namespace karcher {

enum class DescentStop {
  kArrived,  ///< the path reached a face that contains the source, and ends there
  kStuck,    ///< no direction leads down: a local minimum of the distances, or the boundary
  kLimit,    ///< the path took as many steps as the mesh has half-edges
};

struct DescentPath {
  /// The path's points from the start on. Consecutive points share a face.
  Array<SurfacePoint> points;
  double length = 0;
  DescentStop stop = DescentStop::kStuck;
};

/// The gradient, in the frame of face f, of the linear interpolation of `values` (one for each
/// vertex).
Vec2 faceGradient(const Geometry& geometry, const Array<double>& values, int f);

/// Descends from `start` to `source`. `distances` are the distances of the vertices from `source`.
/// They must be finite along the path; elsewhere, as on other components, they may be infinite.
/// Throws Error: kBadArgument (not one distance for each vertex), kNotFinite.
DescentPath descendDistance(const Geometry& geometry, const Array<double>& distances,
                            const SurfacePoint& source, const SurfacePoint& start);

/// The center of mass of the two ends of a path: the source with weights[0] and the start with
/// weights[1]. Its distance from the source along the path is weights[1] times the path's length.
/// The status is kNoProgress if the path did not arrive. Throws Error kBadWeights unless there are
/// two weights, neither negative, with the sum 1.
SearchEnd descentCenterOfMass(const Geometry& geometry, const DescentPath& path, Weights weights);

}  // namespace karcher

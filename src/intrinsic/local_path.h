#pragma once

#include "intrinsic/strip_path.h"

/// A locally shortest geodesic between two points that lie near each other, such as consecutive
/// samples of a curve: points in one face or in two that share an edge are joined at once, others
/// through a strip of faces found by an A* search and pulled tight (strip_path.h). The work depends
/// on the faces between the points, not on the mesh.
namespace karcher {

struct LocalPathOptions {
  int maxFaces = 4096;  ///< the search gives up after this many
};

/// Appends the path's points after `from` to `out` (edge crossings, vertices, and `to`; consecutive
/// points share a face). No vertex of the path has less than pi of surface on one of its sides.
/// Returns false and changes nothing if the search ends before it reaches `to`, because the points
/// are far apart or on different components.
bool appendLocalPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     StripWorkspace& workspace, Array<SurfacePoint>& out,
                     const LocalPathOptions& options = {});

}  // namespace karcher

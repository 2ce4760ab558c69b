#pragma once

#include "intrinsic/strip_path.h"

/// A locally shortest geodesic between two points that lie near each other, such as consecutive
/// samples of a curve. A straight line joins points in one face, and points in two adjacent faces
/// if it crosses their common edge. For other points an A* search finds a strip of faces, in which
/// the path is pulled tight (strip_path.h). The work depends on the faces between the points, not
/// on the mesh.
namespace karcher {

struct LocalPathOptions {
  int maxFaces = 4096;  ///< the number of faces after which the search gives up
};

/// Appends the path's points after `from` to `out`: edge crossings, vertices, and `to`. Consecutive
/// points share a face. At each interior vertex of the mesh on the path, the surface's angle is at
/// least pi on both sides of the path. Returns false and changes nothing if the search ends before
/// it reaches `to`, because the points are far apart or on different components.
bool appendLocalPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     StripWorkspace& workspace, Array<SurfacePoint>& out,
                     const LocalPathOptions& options = {});

}  // namespace karcher

#pragma once

#include "distance/find_path.h"

/// Paths that are not the shortest between their ends, determined by a few of their points.
namespace karcher {

/// Writes to `path` the locally shortest path from `from` to `to` along the waypoints. It consists
/// of the fast paths (find_path.h) between consecutive points, pulled tight as a whole. Without
/// waypoints it is the fast path itself. If all waypoints lie on edges or vertices, and consecutive
/// points from `from` to `to` share a face, the path consists of exactly these points. Returns
/// false and changes nothing if the points lie on several components.
bool findPathBy(const Geometry& geometry, const SurfacePoint& from,
                const Array<SurfacePoint>& waypoints, const SurfacePoint& to,
                FindPathWorkspace& workspace, SurfacePath& path);

/// A few points of a locally shortest path. With them, `findPathBy` finds the path again, to a
/// ten-thousandth of its length. The result is empty if `findPath` finds the path between its ends,
/// both without options and with these options. If a few points are not enough, the result has all
/// points of the path except the ends.
Array<SurfacePoint> waypointsOf(const Geometry& geometry, const SurfacePath& path,
                                FindPathWorkspace& workspace, const FindPathOptions& options = {});

}  // namespace karcher

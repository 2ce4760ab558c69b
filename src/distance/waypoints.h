#pragma once

#include "distance/find_path.h"

/// Paths between two points that are not the shortest, told by a few points that they go through.
namespace karcher {

/// Writes the locally shortest path from `from` to `to` that goes the way of the waypoints to
/// `path`: the fast paths (find_path.h) from each to the next, pulled tight as a whole. Without
/// waypoints it is the fast path itself. Returns false, and changes nothing, where the points lie
/// on several components.
bool findPathBy(const Geometry& geometry, const SurfacePoint& from,
                const Array<SurfacePoint>& waypoints, const SurfacePoint& to,
                FindPathWorkspace& workspace, SurfacePath& path);

/// A few points of a locally shortest path by which `findPathBy` finds it again, to a
/// ten-thousandth of its length; none where it is the fast path between its ends. Of a path that
/// cannot be found again by 31 points, those 31.
Array<SurfacePoint> waypointsOf(const Geometry& geometry, const SurfacePath& path,
                                FindPathWorkspace& workspace);

}  // namespace karcher

#pragma once

#include "distance/find_path.h"

/// Paths between two points that are not the shortest, told by a few points that they go through.
namespace karcher {

/// Writes the locally shortest path from `from` to `to` that goes the way of the waypoints to
/// `path`: the fast paths (find_path.h) from each to the next, pulled tight as a whole. Without
/// waypoints it is the fast path itself. Waypoints that all lie on edges, each in one face with the
/// next, also with the ends, are the path itself, which is taken as it is told. Returns false, and
/// changes nothing, where the points lie on several components.
bool findPathBy(const Geometry& geometry, const SurfacePoint& from,
                const Array<SurfacePoint>& waypoints, const SurfacePoint& to,
                FindPathWorkspace& workspace, SurfacePath& path);

/// A few points of a locally shortest path by which `findPathBy` finds it again, to a
/// ten-thousandth of its length; none where it is the one that `findPath` finds between its ends
/// with these options. Of a path that is not found by few points it is all its points.
Array<SurfacePoint> waypointsOf(const Geometry& geometry, const SurfacePath& path,
                                FindPathWorkspace& workspace, const FindPathOptions& options = {});

}  // namespace karcher

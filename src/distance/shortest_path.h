#pragma once

#include "distance/window_distance.h"
#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

namespace karcher {

/// An exact shortest path between two surface points: windows are propagated from one until the
/// other is final, then straightest geodesics lead back from turn to turn and from saddle to
/// saddle. Its points are the ends, crossings of edges, and the vertices that it turns at or meets.
/// If several paths are shortest, it is one of them. Throws Error kUnreachable if the points lie on
/// different components.
SurfacePath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to);

/// The same to a vertex, with a solver that already has `from` as its source and may have grown.
SurfacePath shortestPathToVertex(const Geometry& geometry, WindowDistance& distance, int vertex);

}  // namespace karcher

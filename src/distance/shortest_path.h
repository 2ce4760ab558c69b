#pragma once

#include "distance/window_distance.h"
#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

namespace karcher {

/// A shortest path between two surface points, exact: windows from the one until the other is
/// final, then straightest geodesics back from turn to turn and from saddle to saddle. Its points
/// are the ends, crossings of edges and the vertices that it turns round or meets; its length is
/// theirs. Where several are shortest, one of them. Throws Error kUnreachable where the points lie
/// on different components.
SurfacePath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to);

/// The same with a solver that already has `from` as its source and may have grown, for targets at
/// vertices.
SurfacePath shortestPathToVertex(const Geometry& geometry, WindowDistance& distance, int vertex);

}  // namespace karcher

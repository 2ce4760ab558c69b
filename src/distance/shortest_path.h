#pragma once

#include "distance/window_distance.h"
#include "intrinsic/geometry.h"
#include "intrinsic/surface_path.h"

namespace karcher {

/// An exact shortest path between two surface points. Windows spread from one point until the other
/// is final; then straightest geodesics lead back from turn to turn and from saddle to saddle. The
/// path's points are the ends, crossings of edges, and the vertices at which it turns or that it
/// meets. If several paths are shortest, it is one of them. Throws Error kUnreachable if the points
/// lie on different components, and what WindowDistance throws.
SurfacePath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to);

/// The shortest path from the source of a solver to a vertex. The solver may have grown before.
/// Throws as `shortestPath` does.
SurfacePath shortestPathToVertex(const Geometry& geometry, WindowDistance& distance, int vertex);

}  // namespace karcher

#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The lengths of the shortest paths along edges from a vertex to all vertices; kInfinity for
/// unreachable ones. In benchmarks, the time of this function per vertex is the unit of other
/// times.
Array<double> edgeDijkstra(const Geometry& geometry, int source);

}  // namespace karcher

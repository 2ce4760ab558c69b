#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// Lengths of the shortest paths along edges from a vertex to all vertices; kInfinity for
/// unreachable ones. Its time for each vertex is the unit of other times in the benchmarks.
Array<double> edgeDijkstra(const Geometry& geometry, int source);

}  // namespace karcher

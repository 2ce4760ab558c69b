#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The lengths of the shortest paths along edges from a vertex to all vertices; kInfinity for
/// unreachable ones. Benchmarks give other times in units of this function's time per vertex.
Array<double> edgeDijkstra(const Geometry& geometry, int source);

}  // namespace karcher

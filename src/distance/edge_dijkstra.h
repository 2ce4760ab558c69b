#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// Lengths of the shortest paths along edges from a vertex to all vertices; kInfinity where there
/// is none. The yardstick of the benchmarks: other times are read against its time a vertex.
Array<double> edgeDijkstra(const Geometry& geometry, int source);

}  // namespace karcher

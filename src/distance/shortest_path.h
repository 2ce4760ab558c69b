#pragma once

#include "distance/exact_distance.h"
#include "intrinsic/geometry.h"

namespace karcher {

struct ShortestPath {
  /// From the source to the target: crossings of edges and the vertices that the path turns round.
  /// Consecutive points share a face.
  Array<SurfacePoint> points;
  double length = 0;
};

/// A shortest path between two surface points, exact: windows from the one until the other is
/// final, then straightest geodesics back from turn to turn. Where several are shortest, one of
/// them. Throws Error kUnreachable where the points lie on different components.
ShortestPath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                          const SurfacePoint& to);

/// The same with a solver that already has `from` as its source and may have grown, for targets at
/// vertices.
ShortestPath shortestPathToVertex(const Geometry& geometry, ExactDistance& distance, int vertex);

}  // namespace karcher

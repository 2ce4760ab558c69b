#include "distance/distance_solver.h"

namespace karcher {

Array<double> distancesFrom(DistanceSolver& solver, const SurfacePoint& source, int vertexCount) {
  solver.setSource(source);
  solver.grow(kInfinity);
  Array<double> distances;
  distances.reserve(static_cast<size_t>(vertexCount));
  for (int v = 0; v < vertexCount; ++v) distances.push_back(solver.distance(v));
  return distances;
}

}  // namespace karcher

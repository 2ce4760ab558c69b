#include "rcm/distance_solver.h"

namespace karcher {

AnyDistanceSolver makeDistanceSolver(Surface& surface, const FieldOptions& options) {
  const Geometry& geometry = surface.geometry();
  switch (options.solver) {
    case Solver::kExact:
      return std::make_unique<ExactDistance>(geometry);
    case Solver::kGraph:
      return std::make_unique<GraphDistance>(geometry, surface.ringGraph(options.rings));
    case Solver::kFast:
      break;
  }
  return std::make_unique<FastDistance>(geometry, surface.vertexFans());
}

}  // namespace karcher

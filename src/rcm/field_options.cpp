#include "rcm/field_options.h"

#include <string>

#include "distance/graph_distance.h"
#include "distance/window_distance.h"
#include "mesh/error.h"

namespace karcher {

void checkFieldOptions(const FieldOptions& options) {
  checkRings(options.rings);
  if (options.method == Method::kPaper && options.solver == Solver::kFast) {
    throw Error(ErrorCode::kBadArgument,
                "the paper's method takes the solver 'exact' or 'graph', not 'fast'");
  }
  if (options.method != Method::kPaper && options.star != Star::kWide) {
    throw Error(ErrorCode::kBadArgument, "only the paper's method averages gradients over a star");
  }
}

void prepareFields(Surface& surface, const FieldOptions& options) {
  if (options.method == Method::kPaper) surface.gradientOperator(options.star);
  if (options.solver == Solver::kGraph) surface.ringGraph(options.rings);
}

std::unique_ptr<DistanceSolver> makeDistanceSolver(Surface& surface, const FieldOptions& options) {
  const Geometry& geometry = surface.geometry();
  switch (options.solver) {
    case Solver::kExact:
      return std::make_unique<WindowDistance>(geometry, 0, surface.pages());
    case Solver::kGraph:
      return std::make_unique<GraphDistance>(geometry, surface.ringGraph(options.rings));
    case Solver::kFast:
      break;
  }
  return std::make_unique<WindowDistance>(geometry, kFastTolerance, surface.pages());
}

Estimator estimatorOf(Solver solver) {
  return solver == Solver::kExact ? Estimator::kQuadratic2 : Estimator::kLinear1;
}

}  // namespace karcher

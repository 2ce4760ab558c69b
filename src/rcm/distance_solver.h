#pragma once

#include <memory>
#include <variant>

#include "rcm/point_field.h"

/// The solver that belongs to field options, and what all solvers give.
namespace karcher {

/// The surface must outlive the solver.
AnyDistanceSolver makeDistanceSolver(Surface& surface, const FieldOptions& options);

/// The estimator that belongs to a solver.
inline Estimator estimatorOf(Solver solver) {
  return solver == Solver::kExact ? Estimator::kQuadratic2 : Estimator::kLinear1;
}

/// -2 log_v(source), by the distance and the direction back to the source.
template <class DistanceSolver>
Vec2 logVector(const Geometry& geometry, const DistanceSolver& solver, int v) {
  return -2 * solver.distance(v) * unitVector(geometry.angleScale[v] * solver.direction(v));
}

inline Vec2 logVector(const Geometry&, const FastDistance& solver, int v) {
  return solver.logVector(v);
}

}  // namespace karcher

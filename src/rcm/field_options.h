#pragma once

#include <memory>

#include "distance/distance_solver.h"
#include "rcm/surface.h"

/// Options of points' fields. The choice of a solver determines the object that computes distances,
/// the estimator and the shared data.
namespace karcher {

/// The method that computes a control point's field.
enum class Method {
  kKarcher,  ///< log vectors: the directions in which shortest paths arrive
  kPaper,    ///< gradients of squared distances (Mancinelli, Puppo, Eq. 3)
};

/// The solver that finds distances, and the estimator (estimators.h) that smooths log vectors.
enum class Solver {
  kFast,   ///< joined windows within kFastTolerance; kLinear1
  kExact,  ///< exact windows; kQuadratic2, and also log vectors at the midpoints of edges
  kGraph,  ///< arcs of the k-ring graph; kLinear1
};

struct FieldOptions {
  Method method = Method::kKarcher;
  Solver solver = Solver::kFast;
  int rings = 6;            ///< the k of the k-ring graph, 1 to 10
  Star star = Star::kWide;  ///< the star of kPaper (gradient_operator.h)

  bool operator==(const FieldOptions&) const = default;
};

/// Whether exact distances can check centers of mass in fields with these options
/// (exact_minimum.h). Centers in other fields are minima of another energy.
inline bool areCheckable(const FieldOptions& options) {
  return options.method == Method::kKarcher && options.solver != Solver::kGraph;
}

/// Whether curves by the method may have levels. The paper's curves have none.
inline bool takesLevels(Method method) { return method != Method::kPaper; }

/// Throws Error kBadArgument for a combination that does not exist.
void checkFieldOptions(const FieldOptions& options);

/// Computes the data that fields with these options share. Without this call, the first field
/// computes them.
void prepareFields(Surface& surface, const FieldOptions& options);

/// The tolerance of kFast (window_distance.h). On all tested meshes, including ring tubes of any
/// proportion and CAD parts, distances have a mean error of at most 0.1 %, and errors of at most
/// 1 % (docs/gallery.md).
inline constexpr double kFastTolerance = 0.006;

/// The solver of these options. The surface must outlive it.
std::unique_ptr<DistanceSolver> makeDistanceSolver(Surface& surface, const FieldOptions& options);

/// The estimator that smooths a solver's log vectors.
Estimator estimatorOf(Solver solver);

}  // namespace karcher

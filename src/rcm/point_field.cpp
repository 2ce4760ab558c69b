#include "rcm/point_field.h"

#include <string>
#include <utility>

#include "mesh/error.h"

namespace karcher {
namespace {

constexpr int kMostRings = 10;

/// Squares of a solver's distances at all vertices; 0 where the source does not reach.
template <class DistanceSolver>
Array<double> squaredDistances(const DistanceSolver& solver, int vertexCount) {
  Array<double> squares(static_cast<size_t>(vertexCount));
  for (int v = 0; v < vertexCount; ++v) {
    const double d = solver.distance(v);
    squares[v] = d == kInfinity ? 0 : d * d;
  }
  return squares;
}

}  // namespace

void checkFieldOptions(const FieldOptions& options) {
  if (options.rings < 1 || options.rings > kMostRings) {
    throw Error(ErrorCode::kBadArgument, "the graph takes 1 to " + std::to_string(kMostRings) +
                                             " rings, not " + std::to_string(options.rings));
  }
  if (options.method == Method::kPaper && options.solver == Solver::kFast) {
    throw Error(ErrorCode::kBadArgument,
                "the paper's method takes the solver 'exact' or 'graph', not 'fast'");
  }
}

PointField::PointField(Surface& surface, const FieldOptions& options)
    : surface_(surface), options_(options), field_(surface.mesh().vertexCount()) {
  checkFieldOptions(options);
}

void PointField::setPoint(const SurfacePoint& point) {
  point_ = point;
  makePaperField();
}

void PointField::makePaperField() {
  const int vertexCount = surface_.mesh().vertexCount();
  if (options_.solver == Solver::kExact) {
    ExactDistance solver(surface_.geometry());
    solver.setSource(point_);
    solver.grow(kInfinity);
    squaredDistances_ = squaredDistances(solver, vertexCount);
  } else {
    GraphDistance solver(surface_.geometry(), surface_.ringGraph(options_.rings));
    solver.setSource(point_);
    solver.grow(kInfinity);
    squaredDistances_ = squaredDistances(solver, vertexCount);
  }
  gradients_ = applyGradient(surface_.gradientOperator(), squaredDistances_);
  field_.reset([this](int v) { return FieldValue{gradients_[v], squaredDistances_[v]}; });
}

ControlField fieldFromDistances(Surface& surface, const Array<double>& distances) {
  const int vertexCount = surface.mesh().vertexCount();
  if (distances.count() != vertexCount) {
    throw Error(ErrorCode::kBadArgument,
                "a field takes one distance a vertex: " + std::to_string(vertexCount) + ", not " +
                    std::to_string(distances.size()));
  }
  auto squares = std::make_shared<Array<double>>(distances);
  for (int v = 0; v < vertexCount; ++v) {
    if (!std::isfinite(distances[v]) || distances[v] < 0) {
      throw Error(ErrorCode::kNotFinite, "the distance at vertex " + std::to_string(v) +
                                             " must be a finite number of at least 0");
    }
    (*squares)[v] *= distances[v];
  }
  auto gradients =
      std::make_shared<Array<Vec2>>(applyGradient(surface.gradientOperator(), *squares));
  ControlField field(vertexCount);
  field.reset([squares, gradients](int v) { return FieldValue{(*gradients)[v], (*squares)[v]}; });
  return field;
}

}  // namespace karcher

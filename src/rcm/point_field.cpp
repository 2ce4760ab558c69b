#include "rcm/point_field.h"

#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>

#include "mesh/error.h"
#include "rcm/distance_solver.h"

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
    : surface_(surface),
      options_(options),
      field_(surface.mesh().vertexCount()),
      logVectors_(surface.mesh().vertexCount()) {
  checkFieldOptions(options);
}

void PointField::setPoint(const SurfacePoint& point) {
  point_ = point;
  position_ = position(surface_.mesh(), point);
  if (options_.method == Method::kPaper) {
    makePaperField();
  } else {
    makeLogField();
  }
}

void PointField::makePaperField() {
  AnyDistanceSolver anySolver = makeDistanceSolver(surface_, options_);
  std::visit(
      [&](auto& solver) {
        solver->setSource(point_);
        solver->grow(kInfinity);
        squaredDistances_ = squaredDistances(*solver, surface_.mesh().vertexCount());
      },
      anySolver);
  gradients_ = applyGradient(surface_.gradientOperator(), squaredDistances_);
  field_.reset([this](int v) { return FieldValue{gradients_[v], squaredDistances_[v]}; });
}

void PointField::makeLogField() {
  if (!solver_) solver_ = makeDistanceSolver(surface_, options_);
  logVectors_.clear();
  std::visit(
      [&](auto& solver) {
        const auto growing = solver.get();
        ControlField::EvaluateMiddle middle;
        if constexpr (std::is_same_v<decltype(growing), ExactDistance* const>) {
          solver->keepMiddles();
          middle = [this, growing](int h) { return estimateMiddle(*growing, h); };
        }
        solver->setSource(point_);
        StencilTable& stencils = surface_.stencils(estimatorOf(options_.solver));
        field_.reset(
            [this, &stencils, growing](int v) { return estimate(*growing, stencils.at(v), v); },
            std::move(middle));
      },
      *solver_);
}

template <class DistanceSolver>
void PointField::growTo(DistanceSolver& solver, int vertex) const {
  const auto known = [&] { return solver.isFinal(vertex) && solver.distance(vertex) != kInfinity; };
  if (known()) return;
  if constexpr (std::is_same_v<DistanceSolver, FastDistance>) {
    if (solver.growTo(vertex)) return;
  } else {
    // Far enough for the vertex by the straight line, then in steps so small that little is done in
    // excess.
    constexpr double kStep = 1.01;
    double radius = (surface_.mesh().positions[vertex] - position_).norm();
    while (!known() && solver.reached() < kInfinity) {
      solver.grow(radius);
      radius = std::max(kStep * radius, radius + surface_.geometry().meanEdge / 4);
    }
    if (known()) return;
  }
  throw Error(ErrorCode::kUnreachable,
              "a field was read on another component than its control point's");
}

template <class DistanceSolver>
const Vec2& PointField::logVectorAt(DistanceSolver& solver, int vertex) {
  Vec2& vector = logVectors_.touch(vertex).vector;
  if (std::isnan(vector.x())) {
    growTo(solver, vertex);
    vector = logVector(surface_.geometry(), solver, vertex);
  }
  return vector;
}

template <class DistanceSolver>
FieldValue PointField::estimate(DistanceSolver& solver, const Stencil& stencil, int vertex) {
  const auto squaredDistanceAt = [&](int v) {
    growTo(solver, v);
    return solver.distance(v) * solver.distance(v);
  };
  const double own = squaredDistanceAt(vertex);
  const Vec2 gradient = stencil.apply(
      own, [&](int v) -> const Vec2& { return logVectorAt(solver, v); }, squaredDistanceAt);
  if constexpr (std::is_same_v<DistanceSolver, ExactDistance>) {
    const Vec2& log = logVectorAt(solver, vertex);
    // The fit is what the stencil makes of the rest.
    const Vec2 difference = (log - gradient) / (1 - stencil.own);
    const double share = shareOfLogVector(stencil.own, difference, std::sqrt(own));
    return {log - (1 - share) * difference, own};
  }
  return {gradient, own};
}

Vec2 PointField::estimateMiddle(ExactDistance& solver, int h) {
  const Geometry& geometry = surface_.geometry();
  const int tail = surface_.mesh().tail(h);
  const int head = surface_.mesh().head(h);
  const EdgeDirection direction = directionOfEdge(geometry, h);
  const Vec2 mean = (rotateBack(direction.tail, logVectorAt(solver, tail)) +
                     rotateBack(direction.head, logVectorAt(solver, head))) /
                    2;
  // No farther from the source than the ends are, and half the edge.
  const double farthest =
      std::min(solver.distance(tail), solver.distance(head)) + geometry.edgeLength[h];
  if (solver.reached() < farthest) solver.grow(farthest);
  const ExactDistance::MiddleArrival arrival = solver.middleOf(h);
  const Vec2 difference = -2 * arrival.distance * arrival.toSource - mean;
  StencilTable& stencils = surface_.stencils(estimatorOf(options_.solver));
  const double own = (stencils.at(tail).own + stencils.at(head).own) / 2;
  return shareOfLogVector(own, difference, arrival.distance) * difference;
}

Array<ControlField*> controlFields(const Array<PointField*>& points) {
  Array<ControlField*> fields;
  for (PointField* point : points) fields.push_back(&point->field());
  return fields;
}

Array<int> verticesWithin(Surface& surface, PointField& field, double radius) {
  const TriangleMesh& mesh = surface.mesh();
  // From vertex to vertex, so that only the neighbourhood is looked at.
  Array<int> stack;
  std::unordered_set<int> seen;
  const auto visit = [&](int v) {
    if (seen.insert(v).second) stack.push_back(v);
  };
  for (int k = 0; k < 3; ++k) visit(mesh.corner(field.point().face, k));
  Array<int> within;
  while (!stack.empty()) {
    const int v = stack.back();
    stack.pop_back();
    if (std::sqrt(field.field().at(v).squaredDistance) > radius) continue;
    within.push_back(v);
    const int first = mesh.outgoing[v];
    int h = first;
    do {
      visit(mesh.head(h));
      visit(mesh.opposite(h));
      h = rotateLeft(mesh, h);
    } while (h >= 0 && h != first);
  }
  return within;
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

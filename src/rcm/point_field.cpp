#include "rcm/point_field.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/error.h"

namespace karcher {

namespace {

/// Wider on all sides by half the lesser of its length and width, which is about an edge or two.
OrientedBox widened(const OrientedBox& box) {
  OrientedBox wide = box;
  wide.halfSize += Vec3::Constant(std::min(box.halfSize[0], box.halfSize[1]));
  return wide;
}

double reachable(double distance) {
  if (distance != kInfinity) return distance;
  throw Error(ErrorCode::kUnreachable,
              "a field was read on another component than its control point's");
}

}  // namespace

PointField::PointField(Surface& surface, const FieldOptions& options,
                       std::shared_ptr<SpareSolvers> spare)
    : surface_(surface),
      options_(options),
      estimator_(estimatorOf(solverOn(surface, options.solver))),
      field_(surface.mesh().vertexCount(), surface.pages()),
      spare_(std::move(spare)),
      logVectors_(surface.mesh().vertexCount(), surface.pages()) {
  checkFieldOptions(options);
}

void PointField::setPoint(const SurfacePoint& point, const std::optional<OrientedBox>& box) {
  point_ = point;
  box_ = box;
  if (options_.method == Method::kPaper) {
    makePaperField();
  } else {
    makeLogField();
  }
}

void PointField::makePaperField() {
  squaredDistances_ =
      distancesFrom(*makeDistanceSolver(surface_, options_), point_, surface_.mesh().vertexCount());
  for (double& d : squaredDistances_) d = d == kInfinity ? 0 : d * d;
  gradients_ = applyGradient(surface_.gradientOperator(), squaredDistances_);
  field_.reset([this](int v) { return FieldValue{gradients_[v], squaredDistances_[v]}; });
}

void PointField::makeLogField() {
  if (!solver_) solver_ = makeDistanceSolver(surface_, options_);
  stencils_ = &surface_.stencils(estimator_);
  logVectors_.clear();
  ControlField::EvaluateMidpoint midpoint;
  if (solver_->keepMidpoints()) midpoint = [this](int h) { return estimateMidpoint(h); };
  isKept_ = solver_->keepTo(box_) && box_;
  for (auto* solver : {&wide_, &whole_}) {
    if (*solver) spare_->push_back(std::move(*solver));
  }
  isGrowing_ = !isKept_;
  if (isKept_) {
    sights_ = sightSource(surface_.geometry(), point_);
  } else {
    solver_->setSource(point_);
  }
  field_.reset([this](int v) { return estimate(v); }, std::move(midpoint));
}

/// The solver that knows a vertex, grown to it.
DistanceSolver& PointField::solverFor(int vertex) {
  if (!isKept_) {
    solver_->growTo(vertex);
    return *solver_;
  }
  if (!isGrowing_) solver_->setSource(point_);
  isGrowing_ = true;
  if (knows(*solver_, *box_, vertex)) return *solver_;
  const OrientedBox wider = widened(*box_);
  DistanceSolver& wide = made(wide_, wider);
  if (knows(wide, wider, vertex)) return wide;
  DistanceSolver& whole = made(whole_, std::nullopt);
  whole.growTo(vertex);
  return whole;
}

/// Whether a solver that is kept to a box knows a vertex as one that goes everywhere; grows it
/// there.
bool PointField::knows(DistanceSolver& solver, const OrientedBox& box, int vertex) const {
  if (!box.contains(surface_.mesh().positions[vertex])) return false;
  solver.growTo(vertex);
  return solver.isSure(vertex);
}

/// The solver, which is made and kept to the box where it is not there yet.
DistanceSolver& PointField::made(std::unique_ptr<DistanceSolver>& solver,
                                 const std::optional<OrientedBox>& box) {
  if (!solver) {
    if (spare_->empty()) spare_->push_back(makeDistanceSolver(surface_, options_));
    spare_->back()->keepTo(box);
    spare_->back()->setSource(point_);
    solver = std::move(spare_->back());
    spare_->pop_back();
  }
  return *solver;
}

double PointField::distanceAt(int vertex) { return reachable(solverFor(vertex).distance(vertex)); }

const Vec2& PointField::logVectorAt(int vertex) {
  Vec2& vector = logVectors_.touch(vertex).vector;
  if (std::isnan(vector.x())) {
    distanceAt(vertex);
    vector = solverFor(vertex).logVector(vertex);
  }
  return vector;
}

FieldValue PointField::estimate(int vertex) {
  if (isKept_) {
    if (const auto sight = sightFrom(surface_.geometry(), sights_, vertex)) {
      return {sight->logVector, sight->distance * sight->distance};
    }
    const DistanceSolver& solver = solverFor(vertex);
    const double distance = reachable(solver.distance(vertex));
    return {solver.logVector(vertex), distance * distance};
  }
  const Stencil stencil = stencils_->at(vertex);
  const auto squaredDistanceAt = [&](int v) {
    const double distance = distanceAt(v);
    return distance * distance;
  };
  const double own = squaredDistanceAt(vertex);
  const Vec2 gradient = stencil.apply(
      own, [&](int v) -> const Vec2& { return logVectorAt(v); }, squaredDistanceAt);
  if (isLinear(estimator_)) return {gradient, own};
  const Vec2& log = logVectorAt(vertex);
  // The fit is what the stencil makes of the rest.
  const Vec2 difference = (log - gradient) / (1 - stencil.logVectorShare);
  const double share = shareOfLogVector(stencil.logVectorShare, difference, std::sqrt(own));
  return {log - (1 - share) * difference, own};
}

Vec2 PointField::estimateMidpoint(int halfedge) {
  const Geometry& geometry = surface_.geometry();
  const int tail = surface_.mesh().tail(halfedge);
  const int head = surface_.mesh().head(halfedge);
  const EdgeDirection direction = directionOfEdge(geometry, halfedge);
  const Vec2 mean = (rotateBack(direction.tail, logVectorAt(tail)) +
                     rotateBack(direction.head, logVectorAt(head))) /
                    2;
  // No farther from the source than the ends are, and half the edge.
  const double farthest =
      std::min(solver_->distance(tail), solver_->distance(head)) + geometry.edgeLength[halfedge];
  if (solver_->reached() < farthest) solver_->grow(farthest);
  const MidpointArrival arrival = solver_->midpointOf(halfedge);
  const Vec2 difference = -2 * arrival.distance * arrival.toSource - mean;
  const double own = (stencils_->at(tail).logVectorShare + stencils_->at(head).logVectorShare) / 2;
  return shareOfLogVector(own, difference, arrival.distance) * difference;
}

Array<ControlField*> controlFields(const Array<PointField*>& points) {
  Array<ControlField*> fields;
  for (PointField* point : points) fields.push_back(&point->field());
  return fields;
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
                                             " must be a finite number of at least 0, not " +
                                             inSentence(distances[v]));
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

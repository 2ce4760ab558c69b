#include "rcm/point_field.h"

#include <algorithm>
#include <utility>

#include "distance/window_distance.h"
#include "intrinsic/tangent.h"
#include "mesh/error.h"
#include "rcm/paper_method.h"

namespace karcher {

namespace {

[[noreturn]] void throwUnreachable() {
  throw Error(ErrorCode::kUnreachable,
              "a field was read on another component than its control point's");
}

}  // namespace

PointField::PointField(Surface& surface, const FieldOptions& options,
                       std::shared_ptr<FindPathWorkspace> paths)
    : surface_(surface), options_(options), paths_(std::move(paths)) {
  checkFieldOptions(options);
}

void PointField::setPoint(const SurfacePoint& point, bool isNear) {
  point_ = point;
  isNear_ = isNear;
  if (options_.method == Method::kPaper) {
    makePaperField();
  } else if (isNear && options_.solver != Solver::kGraph) {
    makeNearField();
  } else {
    makeLogField();
  }
}

void PointField::setPointFor(const SurfacePoint& point, const SurfacePoint& place, double most) {
  if (options_.method == Method::kPaper) return setPoint(point);
  point_ = point;
  isNear_ = false;
  makeLogField(aimAt(place, most));
}

/// An aim at a ball about a place. The ball holds all vertices that are at most two edges from a
/// corner of the place's face, since the estimates at the corners depend on these vertices.
PathAim PointField::aimAt(const SurfacePoint& place, double most) const {
  const TriangleMesh& mesh = surface_.mesh();
  const Vec3 center = position(mesh, place);
  const auto forCornersAround = [&](int vertex, const auto& visit) {
    for (const int h : outgoingHalfedges(mesh, vertex)) {
      for (int k = 0; k < 3; ++k) visit(mesh.corner(faceOf(h), k));
    }
  };
  double radius = 0;
  for (int k = 0; k < 3; ++k) {
    forCornersAround(mesh.corner(place.face, k), [&](int neighbour) {
      forCornersAround(neighbour, [&](int vertex) {
        radius = std::max(radius, (mesh.positions[vertex] - center).norm());
      });
    });
  }
  return {center, radius, most + radius};
}

void PointField::makePaperField() {
  Array<double> squares =
      distancesFrom(*makeDistanceSolver(surface_, options_), point_, surface_.mesh().vertexCount());
  for (double& d : squares) d = d == kInfinity ? 0 : d * d;
  field_ = fieldOfSquares(surface_, options_.star, std::move(squares));
}

void PointField::makeNearField() {
  findSightSources(surface_.geometry(), point_, sights_);
  isAroundHubs_ = false;
  field_.reset([this](int v) { return nearValue(v); }, {}, true);
}

FieldValue PointField::valueBesideHub(int vertex) {
  if (!aroundHubs_) {
    aroundHubs_ = std::make_unique<WindowDistance>(surface_.geometry(), 0, surface_.pages());
  }
  if (!isAroundHubs_) aroundHubs_->setSource(point_);
  // If the search throws half-way, the next one starts anew.
  isAroundHubs_ = false;
  const double distance = aroundHubs_->growTo(vertex);
  isAroundHubs_ = true;
  if (distance == kInfinity) throwUnreachable();
  return {aroundHubs_->logVector(vertex), distance * distance};
}

FieldValue PointField::nearValue(int vertex) {
  const Geometry& geometry = surface_.geometry();
  const bool isExact = options_.solver == Solver::kExact;
  if (!isExact) {
    if (const auto sight = sightFrom(geometry, sights_, vertex)) {
      return {sight->logVector, sight->distance * sight->distance};
    }
  }
  if (surface_.isBesideHub(vertex)) return valueBesideHub(vertex);
  const SurfacePoint from = vertexPoint(surface_.mesh(), vertex);
  if (!findPath(geometry, from, point_, *paths_, path_, {.certified = isExact})) {
    throwUnreachable();
  }
  const double distance = path_.length();
  if (!(distance > 0)) return {};
  return {-2 * logAlong(geometry, path_), distance * distance};
}

void PointField::startSolver(const std::optional<PathAim>& aim) {
  if (!solver_) {
    estimator_ = estimatorOf(options_.solver);
    stencils_ = &surface_.stencils(estimator_);
    logVectors_.emplace(surface_.mesh().vertexCount(), surface_.pages());
    solver_ = makeDistanceSolver(surface_, options_);
  }
  logVectors_->clear();
  hasMidpoints_ = options_.solver == Solver::kExact && solver_->keepMidpoints();
  solver_->aimAt(aim);
  isAimed_ = aim.has_value();
  solver_->setSource(point_);
}

/// Does work of the solver. A solver that throws half-way would later give wrong distances, so it
/// rests.
template <class Work>
auto PointField::restIfThrown(const Work& work) {
  try {
    return work();
  } catch (...) {
    rest();
    throw;
  }
}

void PointField::makeLogField(const std::optional<PathAim>& aim) {
  restIfThrown([&] { startSolver(aim); });
  ControlField::EvaluateMidpoint midpoint;
  if (hasMidpoints_) {
    midpoint = [this](int h) { return restIfThrown([&] { return estimateMidpoint(h); }); };
  }
  field_.reset([this](int v) { return restIfThrown([&] { return estimate(v); }); },
               std::move(midpoint));
}

void PointField::rest() {
  logVectors_.reset();
  solver_.reset();
}

int64_t PointField::bytesOfSolver() const {
  return !solver_ ? 0 : solver_->bytesHeld() + logVectors_->bytesHeld();
}

double PointField::distanceAt(int vertex) {
  double distance = solver_->growTo(vertex);
  if (distance == kInfinity && isAimed_) {
    // No path is as short as the aim allows, so the solver starts again without an aim.
    isAimed_ = false;
    solver_->aimAt(std::nullopt);
    solver_->setSource(point_);
    distance = solver_->growTo(vertex);
  }
  if (distance == kInfinity) throwUnreachable();
  return distance;
}

const Vec2& PointField::logVectorAt(int vertex) {
  Vec2& vector = logVectors_->touch(vertex).vector;
  if (std::isnan(vector.x())) {
    distanceAt(vertex);
    vector = solver_->logVector(vertex);
  }
  return vector;
}

FieldValue PointField::estimate(int vertex) {
  if (!solver_) startSolver();
  const Stencil stencil = stencils_->at(vertex);
  const auto squaredDistanceAt = [&](int v) {
    const double distance = distanceAt(v);
    return distance * distance;
  };
  const double own = squaredDistanceAt(vertex);
  const Vec2 gradient = stencil.apply(
      own, [&](int v) -> const Vec2& { return logVectorAt(v); }, squaredDistanceAt);
  if (isLinear(estimator_) || stencil.logVectorShare == 1) return {gradient, own};
  const Vec2& log = logVectorAt(vertex);
  // The gradient mixes the fit with the stencil's share of the log vector. `difference` is the log
  // vector minus the fit alone.
  const Vec2 difference = (log - gradient) / (1 - stencil.logVectorShare);
  const double share = shareOfLogVector(stencil.logVectorShare, difference, std::sqrt(own));
  return {log - (1 - share) * difference, own};
}

Vec2 PointField::estimateMidpoint(int halfedge) {
  if (!solver_) startSolver();
  const Geometry& geometry = surface_.geometry();
  const int tail = surface_.mesh().tail(halfedge);
  const int head = surface_.mesh().head(halfedge);
  const EdgeDirection direction = directionOfEdge(geometry, halfedge);
  const Vec2 mean = (rotateBack(direction.tail, logVectorAt(tail)) +
                     rotateBack(direction.head, logVectorAt(head))) /
                    2;
  // The midpoint is less than an edge farther from the source than the nearer end.
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

}  // namespace karcher

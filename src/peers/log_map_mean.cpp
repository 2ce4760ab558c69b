#include "peers/log_map_mean.h"

#include <cmath>

#include "intrinsic/straightest.h"

namespace karcher {
namespace {

/// The authors' library halves a step this often before it gives up, and tests each part.
constexpr int kLibraryHalvings = 7;

}  // namespace

LogMapMean::LogMapMean(const Geometry& geometry, LogMapFromVertex logMapFromVertex,
                       Array<SurfacePoint> points, const LogMapMeanOptions& options)
    : geometry_(geometry),
      logMapFromVertex_(std::move(logMapFromVertex)),
      options_(options),
      points_(std::move(points)) {}

void LogMapMean::setPoints(Array<SurfacePoint> points) {
  points_ = std::move(points);
  known_.clear();
  keptBytes_ = 0;
  logMapCount_ = 0;
  logMapsAsked_ = 0;
  logMapMilliseconds_ = 0;
}

void LogMapMean::movePoint(int i, const SurfacePoint& point) {
  points_[i] = point;
  for (auto at = known_.begin(); at != known_.end();) {
    KnownMap& known = at->second;
    if (!known.whole.empty()) known.ofPoints[i] = logarithmOf(known.whole, i);
    if (!known.whole.empty() && known.ofPoints[i].allFinite()) {
      ++at;
    } else {
      // If a logarithm is missing, the next search that needs it throws and names the point.
      keptBytes_ -= known.whole.size() * sizeof(Vec2);
      at = known_.erase(at);
    }
  }
}

SearchEnd LogMapMean::centerOfMass(Weights weights, const SurfacePoint& start) {
  if (weights.size() != points_.size()) {
    throw Error(ErrorCode::kBadWeights, "there are " + std::to_string(weights.size()) +
                                            " weights for " + std::to_string(points_.size()) +
                                            " points");
  }
  SearchEnd center;
  State state = stateAt(start, weights);
  const double tolerance = options_.tolerance * geometry_.meanEdge;
  double libraryStep = 1;  // the part of the last step that the library tests
  center.status = Status::kLimit;
  for (; center.iterations < options_.maxIterations; ++center.iterations) {
    if (state.step.norm() <= tolerance) {
      center.status = Status::kConverged;
      break;
    }
    if (!descend(state, weights)) {
      const PointLocation location = locate(*geometry_.mesh, state.point);
      const bool atBoundary =
          location.simplex == Simplex::kEdge && geometry_.mesh->twin[location.halfedge] < 0;
      center.status = atBoundary ? Status::kBoundary : Status::kNoProgress;
      libraryStep = 1.0 / (1 << kLibraryHalvings);
      break;
    }
  }
  center.point = state.point;
  const double faceSize = std::sqrt(doubleArea(geometry_, state.point.face) / 2);
  metLibraryRule_ = libraryStep * state.step.norm() < faceSize / 3;
  return center;
}

bool LogMapMean::descend(State& state, Weights weights) {
  constexpr int kMostHalvings = 10;
  double part = 1;
  for (int i = 0; i <= kMostHalvings; ++i, part /= 2) {
    const StraightestPath path = traceStraightest(geometry_, state.point, part * state.step);
    const State candidate = stateAt(path.path.end(), weights);
    if (candidate.energy < state.energy || candidate.step.norm() < state.step.norm()) {
      state = candidate;
      return true;
    }
  }
  return false;
}

LogMapMean::State LogMapMean::stateAt(const SurfacePoint& point, Weights weights) {
  State state{point};
  Array<Vec2> logs(points_.size(), Vec2::Zero());
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) continue;
    const Vec2 rotation = point.bary[k] * cornerRotation(geometry_, point, k);
    const Array<Vec2>& atCorner = logarithmsAt(geometry_.mesh->corner(point.face, k));
    for (int i = 0; i < logs.count(); ++i) logs[i] += rotate(rotation, atCorner[i]);
  }
  for (int i = 0; i < logs.count(); ++i) {
    const double weight = weights[static_cast<size_t>(i)];
    state.step += weight * logs[i];
    state.energy += weight * logs[i].squaredNorm();
  }
  return state;
}

const Array<Vec2>& LogMapMean::logarithmsAt(int vertex) {
  ++logMapsAsked_;
  const auto known = known_.find(vertex);
  if (known != known_.end()) return known->second.ofPoints;
  const double begin = options_.clock ? options_.clock() : 0;
  KnownMap made{logMapFromVertex_(vertex), {}};
  ++logMapCount_;
  if (options_.clock) logMapMilliseconds_ += options_.clock() - begin;
  for (int i = 0; i < points_.count(); ++i) {
    made.ofPoints.push_back(logarithmOf(made.whole, i));
    if (!made.ofPoints[i].allFinite()) {
      throw Error(ErrorCode::kUnreachable,
                  "no heat from vertex " + std::to_string(vertex) + " reaches control point " +
                      std::to_string(i) +
                      ": it lies on another component, or more than 600 mean edges away");
    }
  }
  const size_t bytes = made.whole.size() * sizeof(Vec2);
  if (bytes <= options_.mostBytes - keptBytes_) {
    keptBytes_ += bytes;
  } else {
    made.whole = {};
  }
  return known_.emplace(vertex, std::move(made)).first->second.ofPoints;
}

/// The logarithm of control point i in a log map, interpolated between the corners of its face.
Vec2 LogMapMean::logarithmOf(const LogMap& logs, int i) const {
  Vec2 log = Vec2::Zero();
  for (int k = 0; k < 3; ++k) {
    const double weight = points_[i].bary[k];
    if (weight != 0) log += weight * logs[geometry_.mesh->corner(points_[i].face, k)];
  }
  return log;
}

}  // namespace karcher

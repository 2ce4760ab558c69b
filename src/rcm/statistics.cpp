#include "rcm/statistics.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "distance/exact_lengths.h"
#include "distance/shortest_path.h"
#include "distance/tangent_maps.h"
#include "intrinsic/angles.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "rcm/mean.h"

namespace karcher {
namespace {

/// The step of finite differences, relative to an edge. It is so small that paths seldom change
/// their course within it.
constexpr double kStep = 1e-3;

/// The influence of a point, as functions of its distance.
struct Rule {
  std::function<double(double)> pull;  ///< the factor of the point's weight in a center of mass
  std::function<double(double)> cost;
  /// whether the cost has a kink at the point, so that the minimum may lie there
  bool isSharp = false;
};

Array<Vec2> logVectors(const Geometry& geometry, const Array<SurfacePoint>& points,
                       const SurfacePoint& place) {
  FindPathWorkspace workspace;
  Array<Vec2> vectors;
  for (const SurfacePoint& point : points) {
    vectors.push_back(logMap(geometry, place, point, Vec2::Zero(), workspace).vector);
  }
  return vectors;
}

/// The weight of a point beside a vertex, and the direction in which the point is seen from there,
/// as an angle on the surface.
struct Pull {
  double weight;
  double direction;
};

/// The largest pull of points in a direction at a vertex, or a pull of 0 if no pull is positive. A
/// point at the angle a from the direction pulls with its weight times cos(min(a, pi)). `total` is
/// the sum of the angles around the vertex. At the boundary, where `isOpen`, directions are from 0
/// to the total, and angles are measured inside this range.
Pull largestPull(const Array<Pull>& pulls, double total, bool isOpen) {
  struct Change {
    double direction;
    Vec2 sum;
    double rest;
  };
  const double reach = isOpen ? kPi : std::min(kPi, total / 2);
  // From one of the following directions to the next, the pull is sum.dot(unitVector(direction)) +
  // rest.
  Array<Change> changes;
  double rest = 0;
  for (const Pull& pull : pulls) {
    rest -= pull.weight;
    for (const int turn : {0, 1}) {
      if (isOpen && turn > 0) continue;
      const double direction = pull.direction + turn * total;
      const Vec2 sum = pull.weight * unitVector(direction);
      changes.push_back({std::max(0.0, direction - reach), sum, pull.weight});
      changes.push_back({std::max(0.0, direction + reach), -sum, -pull.weight});
    }
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.direction < b.direction; });
  Vec2 sum = Vec2::Zero();
  Pull most{0, 0};
  for (int i = 0; i < changes.count() && changes[i].direction < total; ++i) {
    sum += changes[i].sum;
    rest += changes[i].rest;
    const double from = changes[i].direction;
    const double to = i + 1 < changes.count() ? std::min(total, changes[i + 1].direction) : total;
    if (to - from <= kLocalRounding) continue;
    double turn = std::fmod(angleOf(sum) - from, 2 * kPi);
    if (turn < 0) turn += 2 * kPi;
    for (const double direction : {from, std::min(from + turn, to)}) {
      const double pull = sum.dot(unitVector(direction)) + rest;
      if (pull > most.weight) most = {pull, direction};
    }
  }
  return most;
}

/// The largest pull of points in a direction at a place, as a vector in this direction. `pulls` are
/// vectors as long as the weights, in the tangent plane of the place.
Vec2 largestPull(const Geometry& geometry, const SurfacePoint& place, const Array<Vec2>& pulls) {
  const PointLocation at = locate(*geometry.mesh, place);
  const bool isVertex = at.simplex == Simplex::kVertex;
  const bool isOpen = isVertex && geometry.mesh->onBoundary[at.vertex];
  const double scale = isVertex ? geometry.angleScale[at.vertex] : 1;
  if (!isOpen && scale == 1) return std::accumulate(pulls.begin(), pulls.end(), Vec2(0, 0));
  Array<Pull> seen;
  for (const Vec2& pull : pulls) {
    seen.push_back({pull.norm(), directionAt(geometry, at.vertex, pull)});
  }
  const Pull most = largestPull(seen, geometry.totalAngle[at.vertex], isOpen);
  return most.weight * unitVector(scale * most.direction);
}

/// The step of Vardi and Zhang from one of the points: 0 if the point is a local median, or else a
/// step to a lower sum of distances. Points within `least` of the point count as points at its
/// place.
Vec2 stepFrom(const Geometry& geometry, const Array<SurfacePoint>& points,
              const Array<double>& weights, int at, double least) {
  const Array<Vec2> vectors = logVectors(geometry, points, points[at]);
  Array<Vec2> pulls;
  double held = 0;
  double inverse = 0;
  for (int i = 0; i < points.count(); ++i) {
    const double length = vectors[i].norm();
    if (length <= least) {
      held += weights[i];
    } else {
      pulls.push_back(weights[i] / length * vectors[i]);
      inverse += weights[i] / length;
    }
  }
  const Vec2 pull = largestPull(geometry, points[at], pulls);
  const double most = pull.norm();
  if (most <= held) return Vec2::Zero();
  return (1 - held / most) / inverse * pull;
}

void checkWeights(const Array<SurfacePoint>& points, const Array<double>& weights) {
  if (weights.size() != points.size()) {
    throw Error(ErrorCode::kBadArgument, "there are " + std::to_string(points.count()) +
                                             " points but " + std::to_string(weights.count()) +
                                             " weights");
  }
  const auto isPositive = [](double weight) { return weight > 0 && std::isfinite(weight); };
  if (!std::all_of(weights.begin(), weights.end(), isPositive)) {
    throw Error(ErrorCode::kBadArgument,
                "the weights of a median or a Huber mean must be positive");
  }
}

RobustMean search(FieldSets& sets, const Array<SurfacePoint>& points, const Array<double>& weights,
                  const RobustOptions& options, const Rule& rule) {
  checkWeights(points, weights);
  if (points.empty()) {
    throw Error(ErrorCode::kTooFewPoints, "a median or a Huber mean needs at least one point");
  }
  Array<SurfacePoint> connected = points;
  if (options.start) connected.push_back(*options.start);
  checkOneComponent(sets.surface(), connected);
  const Geometry& geometry = sets.surface().geometry();
  const double least = options.tolerance * geometry.diagonal;
  MeanOptions ofMeans;
  ofMeans.normalize = true;
  std::shared_ptr<FieldSet> fields;
  const auto centerOf = [&](const Array<double>& factors, std::optional<SurfacePoint> start) {
    ofMeans.start = std::move(start);
    return centerOfMass(sets, points, factors, ofMeans, fields).point;
  };
  Array<double> distances;
  const auto measureFrom = [&](const SurfacePoint& point) {
    const double likely = distances.empty() ? geometry.diagonal
                                            : *std::max_element(distances.begin(), distances.end());
    distances = exactLengths(geometry, point, points, likely);
  };
  const auto valueHere = [&] {
    double value = 0;
    for (int i = 0; i < points.count(); ++i) value += weights[i] * rule.cost(distances[i]);
    return value;
  };
  RobustMean mean;
  mean.point = options.start ? *options.start : centerOf(weights, std::nullopt);
  measureFrom(mean.point);
  Array<char> isTried(points.size(), 0);
  while (mean.steps < options.mostSteps && !mean.converged) {
    const auto nearest = std::min_element(distances.begin(), distances.end());
    const int at = static_cast<int>(nearest - distances.begin());
    if (rule.isSharp && !isTried[at]) {
      // Near a point that is no median, the usual steps are as short as near a median. So the
      // search goes to a place where the value is lower than at the point, and never comes back.
      isTried[at] = 1;
      const SurfacePoint before = mean.point;
      Array<double> distancesBefore = distances;
      const double value = valueHere();
      const Vec2 step = stepFrom(geometry, points, weights, at, least);
      mean.converged = step == Vec2::Zero();
      mean.point = mean.converged ? points[at] : expAlong(geometry, points[at], step).end();
      measureFrom(mean.point);
      if (valueHere() <= value) {
        mean.steps += mean.converged ? 0 : 1;
        continue;
      }
      mean.point = before;
      mean.converged = false;
      distances.swap(distancesBefore);
    }
    Array<double> factors = weights;
    for (int i = 0; i < factors.count(); ++i)
      factors[i] *= rule.pull(std::max(distances[i], least));
    const SurfacePoint before = mean.point;
    mean.point = centerOf(factors, before);
    measureFrom(mean.point);
    mean.converged = shortestPath(geometry, before, mean.point).length() <= least;
    ++mean.steps;
  }
  mean.value = valueHere();
  return mean;
}

/// The step of finite differences around a place inside a face. It is at most half of the distance
/// from the place to the nearest side.
double stepInside(const Geometry& geometry, const SurfacePoint& place) {
  if (place.bary.minCoeff() <= kChainRounding) {
    throw Error(ErrorCode::kBadArgument, "the energy has derivatives inside faces only");
  }
  double step = kStep * geometry.edgeLength[3 * place.face];
  for (int k = 0; k < 3; ++k) {
    const double side = geometry.edgeLength[3 * place.face + (k + 1) % 3];
    step = std::min(step, place.bary[k] * doubleArea(geometry, place.face) / side / 2);
  }
  return step;
}

SurfacePoint moved(const Geometry& geometry, const SurfacePoint& place, const Vec2& way) {
  return {place.face, barycentric(geometry, place.face, pointInFace(geometry, place) + way)};
}

/// The inverse of the Hessian at a center of mass. Throws Error unless the Hessian is positive
/// definite.
Eigen::Matrix2d inverseHessian(const Geometry& geometry, const Array<SurfacePoint>& points,
                               Weights weights, const SurfacePoint& center) {
  const Eigen::Matrix2d hessian = hessianAt(geometry, points, weights, center);
  if (hessian.determinant() > 0 && hessian(0, 0) > 0) return hessian.inverse();
  throw Error(ErrorCode::kBadArgument, "the point is no minimum: the Hessian is indefinite there");
}

}  // namespace

RobustMean median(FieldSets& sets, const Array<SurfacePoint>& points, const Array<double>& weights,
                  const RobustOptions& options) {
  return search(sets, points, weights, options,
                {[](double distance) { return 1 / distance; },
                 [](double distance) { return distance; }, true});
}

RobustMean huberMean(FieldSets& sets, const Array<SurfacePoint>& points,
                     const Array<double>& weights, double threshold, const RobustOptions& options) {
  if (!(threshold > 0)) {
    throw Error(ErrorCode::kBadArgument, "the threshold must be positive");
  }
  return search(sets, points, weights, options,
                {[=](double distance) { return std::min(1.0, threshold / distance); },
                 [=](double distance) {
                   return distance < threshold ? square(distance) / 2
                                               : threshold * (distance - threshold / 2);
                 },
                 false});
}

EnergyGradient energyAt(const Geometry& geometry, const Array<SurfacePoint>& points,
                        Weights weights, const SurfacePoint& place) {
  const Array<Vec2> vectors = logVectors(geometry, points, place);
  EnergyGradient result;
  auto weight = weights.begin();
  for (const Vec2& vector : vectors) {
    result.energy += *weight * vector.squaredNorm();
    result.gradient -= 2 * *weight++ * vector;
  }
  return result;
}

Eigen::Matrix2d hessianAt(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Weights weights, const SurfacePoint& place) {
  const double step = stepInside(geometry, place);
  const auto gradientAt = [&](const Vec2& away) {
    return energyAt(geometry, points, weights, moved(geometry, place, away)).gradient;
  };
  Eigen::Matrix2d hessian;
  for (int axis = 0; axis < 2; ++axis) {
    const Vec2 away = step * Vec2::Unit(axis);
    hessian.col(axis) = (gradientAt(away) - gradientAt(-away)) / (2 * step);
  }
  return (hessian + hessian.transpose()) / 2;
}

Array<Vec2> weightDerivatives(const Geometry& geometry, const Array<SurfacePoint>& points,
                              Weights weights, const SurfacePoint& center) {
  // The gradient at the center stays 0 when a weight changes. So the Hessian times the derivative
  // is twice the point's log vector.
  const Eigen::Matrix2d inverse = inverseHessian(geometry, points, weights, center);
  Array<Vec2> derivatives = logVectors(geometry, points, center);
  for (Vec2& vector : derivatives) vector = 2 * inverse * vector;
  return derivatives;
}

Array<Eigen::Matrix2d> pointDerivatives(const Geometry& geometry, const Array<SurfacePoint>& points,
                                        Weights weights, const SurfacePoint& center) {
  const Eigen::Matrix2d inverse = inverseHessian(geometry, points, weights, center);
  Array<Eigen::Matrix2d> derivatives;
  auto weight = weights.begin();
  for (const SurfacePoint& point : points) {
    const double step = stepInside(geometry, point);
    Eigen::Matrix2d change;
    for (int axis = 0; axis < 2; ++axis) {
      const Vec2 way = step * Vec2::Unit(axis);
      const Array<Vec2> vectors =
          logVectors(geometry, {moved(geometry, point, way), moved(geometry, point, -way)}, center);
      change.col(axis) = (vectors[0] - vectors[1]) / (2 * step);
    }
    derivatives.push_back(2 * *weight++ * inverse * change);
  }
  return derivatives;
}

}  // namespace karcher

#include "rcm/statistics.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <string>

#include "distance/exact_lengths.h"
#include "distance/shortest_path.h"
#include "distance/tangent_maps.h"
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

/// Whether a point is the median: the joint pull of the points elsewhere is at most the weight of
/// all points at its place.
bool isMedian(const Geometry& geometry, const Array<SurfacePoint>& points,
              const Array<double>& weights, int at) {
  const Array<Vec2> vectors = logVectors(geometry, points, points[at]);
  Vec2 pull = Vec2::Zero();
  double held = 0;
  for (int i = 0; i < points.count(); ++i) {
    const double length = vectors[i].norm();
    if (length == 0) {
      held += weights[i];
    } else {
      pull += weights[i] / length * vectors[i];
    }
  }
  return pull.norm() <= held;
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
  RobustMean mean;
  mean.point = options.start ? *options.start : centerOf(weights, std::nullopt);
  measureFrom(mean.point);
  Array<char> isTried(points.size(), 0);
  while (mean.steps < options.mostSteps && !mean.converged) {
    const auto nearest = std::min_element(distances.begin(), distances.end());
    const int at = static_cast<int>(nearest - distances.begin());
    if (rule.isSharp && !isTried[at]) {
      isTried[at] = 1;
      if (isMedian(geometry, points, weights, at)) {
        mean.point = points[at];
        mean.converged = true;
        measureFrom(mean.point);
        break;
      }
    }
    // If the search is at a point that is not the minimum, the pull of the other points leads the
    // search away.
    Array<double> factors = weights;
    for (int i = 0; i < factors.count(); ++i)
      factors[i] *= rule.pull(std::max(distances[i], least));
    const SurfacePoint before = mean.point;
    mean.point = centerOf(factors, before);
    measureFrom(mean.point);
    mean.converged = shortestPath(geometry, before, mean.point).length() <= least;
    ++mean.steps;
  }
  for (int i = 0; i < points.count(); ++i) mean.value += weights[i] * rule.cost(distances[i]);
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

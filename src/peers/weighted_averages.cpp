#include "peers/weighted_averages.h"

#include <Eigen/Cholesky>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// In the inverse problem, the weight of squared offsets normal to the tangent plane, relative to
/// squared offsets in the plane.
constexpr double kAcrossFactor = 10;

}  // namespace

WeightedAverages::WeightedAverages(const TriangleMesh& mesh, Embedding embedding)
    : surface_(mesh, std::move(embedding.positions), std::move(embedding.planes)) {}

SearchEnd WeightedAverages::centerOfMass(const Array<SurfacePoint>& points, Weights weights,
                                         const SurfacePoint& start) const {
  if (weights.size() != points.size()) {
    throw Error(ErrorCode::kBadWeights, "there are " + std::to_string(weights.size()) +
                                            " weights for " + std::to_string(points.size()) +
                                            " points");
  }
  EmbeddedPoint average = EmbeddedPoint::Zero();
  for (size_t i = 0; i < weights.size(); ++i) average += weights[i] * surface_.position(points[i]);
  const std::optional<SurfacePoint> point = surface_.project(average, start);
  SearchEnd center;
  center.point = point.value_or(start);
  center.status = point ? Status::kConverged : Status::kNoProgress;
  return center;
}

Array<double> WeightedAverages::weightsOf(const Array<SurfacePoint>& points,
                                          const SurfacePoint& target) const {
  if (points.count() < 3) {
    throw Error(ErrorCode::kTooFewPoints,
                "weights of a point need at least 3 others, not " + std::to_string(points.count()));
  }
  const EmbeddedPoint origin = surface_.position(target);
  const TangentPlane plane = surface_.planeAt(target);
  // The first two rows state that the average projects to the target. The third row is the sum of
  // the weights.
  Eigen::Matrix3Xd conditions(3, points.count());
  Eigen::VectorXd costs(points.count());
  for (int i = 0; i < points.count(); ++i) {
    const EmbeddedPoint offset = surface_.position(points[i]) - origin;
    const Vec2 along = plane * offset;
    const double across = std::max(offset.squaredNorm() - along.squaredNorm(), 0.0);
    conditions.col(i) = Vec3(along.x(), along.y(), 1);
    costs[i] = along.squaredNorm() + kAcrossFactor * across;
    if (costs[i] == 0) {
      Array<double> weights(points.size(), 0);
      weights[i] = 1;
      return weights;
    }
  }
  // Lengths are in units of the nearest point's distance, so that the system does not depend on
  // scale.
  const double unit = std::sqrt(costs.minCoeff());
  conditions.topRows(2) /= unit;
  costs /= unit * unit;
  const Eigen::Matrix3Xd weighted = conditions * costs.cwiseAbs2().cwiseInverse().asDiagonal();
  const Eigen::Matrix3d system = weighted * conditions.transpose();
  const Vec3 multipliers = system.ldlt().solve(Vec3(0, 0, 1));
  const Eigen::VectorXd solution = weighted.transpose() * multipliers;
  if (!((conditions * solution - Vec3(0, 0, 1)).norm() < 1e-8)) {
    throw Error(ErrorCode::kBadArgument,
                "no weights average to the target: seen from it, the points lie in one line");
  }
  return {solution.begin(), solution.end()};
}

}  // namespace karcher

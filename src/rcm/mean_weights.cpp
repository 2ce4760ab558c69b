#include "rcm/mean_weights.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"
#include "mesh/rounding.h"
#include "rcm/exact_minimum.h"
#include "rcm/field_blend.h"
#include "rcm/walk_to_center.h"

namespace karcher {
namespace {

using Column = Eigen::Vector3d;

/// The projection of given weights onto the weights that sum to 1 and balance the vectors (x, y).
/// With the columns (1, x, y), these conditions are sum_i w_i column_i = (1, 0, 0).
class Balance {
 public:
  Balance(Array<Column> columns, Array<double> given)
      : columns_(std::move(columns)), given_(std::move(given)) {}

  /// The weights, of any sign.
  Array<double> solve() const {
    Array<double> weights = given_;
    Array<char> free(given_.size(), 1);
    project(free, weights);
    if (!(missedBy(weights) <= kChainRounding)) {
      throw Error(ErrorCode::kBadArgument,
                  "no weights make this point the center: seen from it, the others lie on one line "
                  "that misses it");
    }
    return weights;
  }

  /// The non-negative weights, by the primal active set method from a feasible start. A step frees
  /// one held weight that the objective pulls above 0, or holds one free weight that reaches 0. The
  /// objective never grows.
  Array<double> solveNonNegative() const {
    Array<double> weights = feasible();
    const int count = weights.count();
    Array<char> free(weights.size(), 0);
    for (int i = 0; i < count; ++i) free[i] = weights[i] > 0;
    // The loop would end without this bound, since no set of held weights occurs twice. The number
    // of sets is seldom more than a few times the number of weights.
    const int bound = 100 + 50 * count;
    for (int step = 0; step < bound; ++step) {
      Array<double> next = given_;
      for (int i = 0; i < count; ++i) {
        if (!free[i]) next[i] = 0;
      }
      const Column multiplier = project(free, next);
      double part = 1;
      int blocking = -1;
      for (int i = 0; i < count; ++i) {
        if (!free[i] || next[i] >= 0) continue;
        const double reach = weights[i] / (weights[i] - next[i]);
        if (reach < part) {
          part = reach;
          blocking = i;
        }
      }
      for (int i = 0; i < count; ++i) weights[i] += part * (next[i] - weights[i]);
      if (blocking >= 0) {
        weights[blocking] = 0;
        free[blocking] = 0;
        continue;
      }
      const int release = mostPulled(free, multiplier);
      if (release < 0) break;
      free[release] = 1;
    }
    return weights;
  }

 private:
  /// Changes the free weights so that all weights meet the constraints, by the least sum of squared
  /// changes. Returns the constraints' multipliers.
  Column project(const Array<char>& free, Array<double>& weights) const {
    Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
    for (int i = 0; i < columns_.count(); ++i) {
      if (free[i]) gram += columns_[i] * columns_[i].transpose();
    }
    // The Gram-Schmidt process combines the constraints into rows that are orthonormal on the free
    // weights. The row of a dependent constraint stays 0.
    Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) {
      Column row = Column::Unit(k);
      for (int j = 0; j < k; ++j) row -= rows.row(j).dot(gram * row) * rows.row(j).transpose();
      const double norm = row.dot(gram * row);
      if (norm > kLocalRounding * gram(k, k)) rows.row(k) = row.transpose() / std::sqrt(norm);
    }
    Column sum = Column::Zero();
    // The second pass removes the rounding of the first.
    for (int time = 0; time < 2; ++time) {
      const Column multiplier = rows.transpose() * (rows * (Column(1, 0, 0) - met(weights)));
      for (int i = 0; i < columns_.count(); ++i) {
        if (free[i]) weights[i] += columns_[i].dot(multiplier);
      }
      sum += multiplier;
    }
    return sum;
  }

  Column met(const Array<double>& weights) const {
    Column sum = Column::Zero();
    for (int i = 0; i < columns_.count(); ++i) sum += weights[i] * columns_[i];
    return sum;
  }

  double missedBy(const Array<double>& weights) const {
    return (met(weights) - Column(1, 0, 0)).norm();
  }

  /// The held weight that the objective pulls most strongly above 0; -1 if it pulls none.
  int mostPulled(const Array<char>& free, const Column& multiplier) const {
    int most = -1;
    double pull = kLocalRounding;
    for (int i = 0; i < columns_.count(); ++i) {
      if (free[i]) continue;
      const double wanted = given_[i] + columns_[i].dot(multiplier);
      if (wanted > pull) {
        pull = wanted;
        most = i;
      }
    }
    return most;
  }

  /// Non-negative weights that meet the constraints. They are the projected given weights if none
  /// of these is negative. Else at most three vectors, whose convex hull contains 0, have all the
  /// weight.
  Array<double> feasible() const {
    const int count = columns_.count();
    // The first attempt uses the given weights.
    Array<double> weights = given_;
    Array<char> free(weights.size(), 1);
    project(free, weights);
    if (missedBy(weights) <= kChainRounding &&
        *std::min_element(weights.begin(), weights.end()) >= 0) {
      return weights;
    }
    // If a vector is 0, it has all the weight. Else the longest vector shares the weight with two
    // vectors: on each side, the vector nearest to its opposite direction. The two may be the same
    // vector.
    weights.assign(weights.size(), 0);
    const auto vector = [&](int i) { return Vec2(columns_[i][1], columns_[i][2]); };
    int longest = 0;
    for (int i = 0; i < count; ++i) {
      if (vector(i).norm() <= kChainRounding) {
        weights[i] = 1;
        return weights;
      }
      if (vector(i).norm() > vector(longest).norm()) longest = i;
    }
    const Vec2 first = vector(longest);
    const Vec2 across(-first[1], first[0]);
    int left = -1;   // the nearest vector on the left side of `first`
    int right = -1;  // the nearest vector on the right side of `first`
    const auto angle = [&](int i) {
      return std::atan2(vector(i).dot(across), -vector(i).dot(first));
    };
    for (int i = 0; i < count; ++i) {
      const double a = angle(i);
      if (a >= 0 && (left < 0 || a < angle(left))) left = i;
      if (a <= 0 && (right < 0 || a > angle(right))) right = i;
    }
    free.assign(weights.size(), 0);
    free[longest] = 1;
    if (left >= 0) free[left] = 1;
    if (right >= 0) free[right] = 1;
    project(free, weights);
    const double least = *std::min_element(weights.begin(), weights.end());
    if (!(missedBy(weights) <= kChainRounding) || !(least >= -kChainRounding)) {
      throw Error(ErrorCode::kBadArgument,
                  "no weights of at least 0 make this point the center: it lies outside of the "
                  "convex hull of the others as they are seen from it");
    }
    for (double& weight : weights) weight = std::max(weight, 0.0);
    return weights;
  }

  Array<Column> columns_;
  Array<double> given_;
};

Array<double> checkedGiven(const Array<double>& given, int points) {
  if (points == 0) {
    throw Error(ErrorCode::kTooFewPoints, "weights of a point need at least one other point");
  }
  if (given.empty()) return Array<double>(static_cast<size_t>(points), 1.0 / points);
  if (given.count() != points) {
    throw Error(ErrorCode::kBadWeights, "there are " + std::to_string(points) + " points but " +
                                            std::to_string(given.count()) + " given weights");
  }
  double sum = 0;
  for (const double weight : given) sum += weight;
  if (!(sum > 0) || !std::isfinite(sum)) {
    throw Error(ErrorCode::kBadWeights,
                "the given weights must be finite, and their sum positive, not " + inSentence(sum));
  }
  Array<double> weights = given;
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

Array<double> balancedWeights(const Array<Vec2>& vectors, const Array<double>& given,
                              bool nonNegative) {
  Array<double> start = checkedGiven(given, vectors.count());
  double longest = 0;
  for (const Vec2& vector : vectors) longest = std::max(longest, vector.norm());
  const double scale = longest > 0 ? 1 / longest : 1;
  Array<Column> columns;
  for (const Vec2& vector : vectors) columns.push_back({1, scale * vector[0], scale * vector[1]});
  const Balance balance(std::move(columns), std::move(start));
  return nonNegative ? balance.solveNonNegative() : balance.solve();
}

MeanWeights weightsOf(FieldSet& set, const SurfacePoint& x, const Array<SurfacePoint>& points,
                      const MeanWeightsOptions& options) {
  const Array<double> given = checkedGiven(options.given, points.count());
  Array<SurfacePoint> connected = points;
  connected.push_back(x);
  checkOneComponent(set.surface(), connected);
  Array<std::shared_ptr<PointField>> fields;
  Array<ControlField*> pointers;
  for (const SurfacePoint& point : points) {
    fields.push_back(set.at(point));
    pointers.push_back(&fields.back()->field());
  }
  FieldBlend blend(set.surface().geometry(), std::move(pointers));
  const CellPoint place = blend.cells().at(x);
  Array<double> unit(points.size(), 0);
  Array<Vec2> vectors;
  for (int i = 0; i < points.count(); ++i) {
    unit[i] = 1;
    vectors.push_back(blend.blend(place.cell, unit).at(place.bary));
    unit[i] = 0;
  }
  MeanWeights result{balancedWeights(vectors, given, options.nonNegative), false};
  // For balanced weights the gradient vanishes, so that only the Hessian matters here.
  result.isMinimum = isZero(blend, result.weights, x);
  if (result.isMinimum && areCheckable(set.options())) {
    ExactEnergy energy(set.surface().geometry(), points, result.weights);
    result.isMinimum = exactMinimumNear(set.surface().geometry(), energy, x).moves == 0;
  }
  return result;
}

}  // namespace karcher

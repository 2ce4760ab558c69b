#include "peers/multidimensional_scaling.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace karcher {
namespace {

using Eigen::MatrixXd;

/// Classical scaling: the leading eigenvectors of the doubly centered squared distances.
MatrixXd classicalScaling(const MatrixXd& distances, int dimensions) {
  const Eigen::Index count = distances.rows();
  const MatrixXd centering = MatrixXd::Identity(count, count) -
                             MatrixXd::Constant(count, count, 1 / static_cast<double>(count));
  const MatrixXd products = -0.5 * centering * distances.cwiseAbs2() * centering;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(products);
  MatrixXd positions = MatrixXd::Zero(count, dimensions);
  for (int d = 0; d < std::min<Eigen::Index>(dimensions, count); ++d) {
    const Eigen::Index i = count - 1 - d;
    const double value = std::max(eigen.eigenvalues()[i], 0.0);
    positions.col(d) = std::sqrt(value) * eigen.eigenvectors().col(i);
  }
  return positions;
}

MatrixXd distancesBetween(const MatrixXd& positions) {
  const Eigen::VectorXd squares = positions.rowwise().squaredNorm();
  MatrixXd distances = -2 * positions * positions.transpose();
  distances.colwise() += squares;
  distances.rowwise() += squares.transpose();
  return distances.cwiseMax(0).cwiseSqrt();
}

double stressOf(const MatrixXd& distances, const MatrixXd& wanted) {
  double sum = 0;
  for (Eigen::Index j = 0; j < wanted.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i) {
      sum += std::pow(distances(i, j) / wanted(i, j) - 1, 2);
    }
  }
  const auto count = static_cast<double>(wanted.rows());
  return std::sqrt(sum / (count * (count - 1) / 2));
}

}  // namespace

Scaling scaleDistances(const MatrixXd& distances, const ScalingOptions& options) {
  const Eigen::Index count = distances.rows();
  Scaling scaling;
  scaling.positions = classicalScaling(distances, options.dimensions);
  if (count < 2) return scaling;
  // Weights 1 / distance^2 make errors relative. The Laplacian of the weights is regular on
  // centered positions; a constant added to all entries makes it regular on all positions.
  const auto offDiagonal = [&](const auto& entry) {
    MatrixXd matrix(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      for (Eigen::Index i = 0; i < count; ++i) matrix(i, j) = i == j ? 0 : entry(i, j);
    }
    return matrix;
  };
  const MatrixXd weights =
      offDiagonal([&](Eigen::Index i, Eigen::Index j) { return std::pow(distances(i, j), -2); });
  MatrixXd laplacian = -weights;
  laplacian.diagonal() = weights.rowwise().sum();
  const Eigen::LLT<MatrixXd> factor((laplacian.array() + weights.mean()).matrix());

  MatrixXd current = distancesBetween(scaling.positions);
  scaling.stress = stressOf(current, distances);
  const double least = 1e-12 * distances.maxCoeff();
  while (scaling.iterations < options.maxIterations && scaling.stress > 1e-12) {
    MatrixXd pull = offDiagonal([&](Eigen::Index i, Eigen::Index j) {
      return current(i, j) > least ? -1 / (distances(i, j) * current(i, j)) : 0.0;
    });
    pull.diagonal() = -pull.rowwise().sum();
    scaling.positions = factor.solve(pull * scaling.positions);
    current = distancesBetween(scaling.positions);
    const double before = scaling.stress;
    scaling.stress = stressOf(current, distances);
    ++scaling.iterations;
    if (before - scaling.stress <= options.tolerance * before) break;
  }
  return scaling;
}

}  // namespace karcher

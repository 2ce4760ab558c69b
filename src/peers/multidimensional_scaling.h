#pragma once

#include <Eigen/Core>

/// Metric multidimensional scaling: points in a Euclidean space whose distances approximate given
/// ones. Majorization lowers the sum of the squared relative errors, from a start by classical
/// scaling (J. de Leeuw, "Applications of convex analysis to multidimensional scaling", 1977; T.
/// Cox, M. Cox, "Multidimensional Scaling", 2000).
namespace karcher {

struct ScalingOptions {
  int dimensions = 8;
  int maxIterations = 500;
  double tolerance = 1e-5;  ///< iterations stop if the stress decreases by a smaller ratio
};

struct Scaling {
  Eigen::MatrixXd positions;  ///< a row for each point, centered
  double stress = 0;          ///< the root mean square of the distances' relative errors
  int iterations = 0;
};

/// `distances` is symmetric, 0 on the diagonal and positive and finite elsewhere.
Scaling scaleDistances(const Eigen::MatrixXd& distances, const ScalingOptions& options = {});

}  // namespace karcher

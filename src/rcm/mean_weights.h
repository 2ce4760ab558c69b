#pragma once

#include "rcm/field_set.h"

/// The inverse of the center of mass: weights of given points for which a point is their center.
namespace karcher {

struct MeanWeightsOptions {
  /// Weights that the answer changes as little as it can, by the sum of squares; equal ones where
  /// there are none. They are divided by their sum.
  Array<double> given;
  bool nonNegative = false;  ///< no weight is below 0
};

struct MeanWeights {
  Array<double> weights;  ///< one a point; their sum is 1
  /// Whether `centerOfMass` of these weights that starts at the point stays there. It does not
  /// where the energy's Hessian is not positive definite, as may be where weights are negative or
  /// points lie far apart; nor where the energy by exact distances is lower near by
  /// (exact_minimum.h).
  bool isMinimum = false;
};

/// Weights w of sum 1 with sum_i w_i v_i = 0 for v_i = log_x p_i (Mancinelli, Puppo, Eq. 2): where
/// the gradient of the energy of the points p_i vanishes at x. The log vectors are those of the
/// points' fields, which the set gives, as `centerOfMass` has them. For three points there is one
/// answer, for more the one nearest to the given weights. Time: as many fields as points, and
/// O(points) a step of the active set. Throws Error: kTooFewPoints (none), kUnreachable (several
/// components), kBadWeights (given ones that are not one a point, not finite, or of a sum that is
/// not positive), kBadArgument where there are no such weights: seen from x, the points lie on one
/// line that misses x; or, for weights of at least 0, x is outside the log vectors' convex hull.
MeanWeights weightsOf(FieldSet& set, const SurfacePoint& x, const Array<SurfacePoint>& points,
                      const MeanWeightsOptions& options);

/// The part without a surface: weights for vectors in the plane, of which the weighted sum is to
/// vanish. Throws Error as above.
Array<double> balancedWeights(const Array<Vec2>& vectors, const Array<double>& given,
                              bool nonNegative);

}  // namespace karcher

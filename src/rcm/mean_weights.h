#pragma once

#include "rcm/field_set.h"

/// The inverse of the center of mass: weights of given points for which a point is their center.
namespace karcher {

struct MeanWeightsOptions {
  /// The target weights; equal weights if empty. They are divided by their sum. The result has the
  /// least sum of squared differences from the target weights.
  Array<double> given;
  bool nonNegative = false;  ///< whether no weight may be below 0
};

struct MeanWeights {
  Array<double> weights;  ///< the weights, one for each point, of sum 1
  /// Whether a search by `centerOfMass` that starts at the point stays there. The search leaves the
  /// point if the energy's Hessian is not positive definite (for example with negative weights or
  /// distant points), or if the energy by exact distances is lower near by (exact_minimum.h).
  bool isMinimum = false;
};

/// Weights w of sum 1 with sum_i w_i v_i = 0 for v_i = log_x p_i (Mancinelli, Puppo, Eq. 2): with
/// them the gradient of the energy of the points p_i vanishes at x. The log vectors are those of
/// the points' fields in the set, as in `centerOfMass`. For three points the weights are
/// determined; for more points they are the nearest to the given weights. Time: one field for each
/// point, and O(points) for each step of the active set. Throws Error: kTooFewPoints if there are
/// no points; kUnreachable if the points and x lie on several components; kBadWeights if there is
/// not one given weight for each point, if a given weight is not finite, or if their sum is not
/// positive; kBadArgument if no such weights exist. No weights exist if the ends of the log vectors
/// lie on one line that misses 0. No non-negative weights exist if 0 lies outside the convex hull
/// of the log vectors.
MeanWeights weightsOf(FieldSet& set, const SurfacePoint& x, const Array<SurfacePoint>& points,
                      const MeanWeightsOptions& options);

/// The same for given vectors v_i in the plane: weights w of sum 1 with sum_i w_i v_i = 0. Throws
/// Error as above, except kUnreachable.
Array<double> balancedWeights(const Array<Vec2>& vectors, const Array<double>& given,
                              bool nonNegative);

}  // namespace karcher

#pragma once

#include "mesh/types.h"

/// Bases of curves: from a parameter t in [0, 1] to weights that sum to 1, one a control point of
/// the segment (Mancinelli, Puppo, Eq. 4).
namespace karcher {

/// Bernstein polynomials of degree `degree` >= 0 at t, by de Casteljau's recurrence: degree + 1
/// weights.
Array<double> bernsteinBasis(int degree, double t);

/// The uniform cubic B-spline on one segment: 4 weights.
Array<double> uniformCubicBasis(double t);

/// A rational basis: w_i N_i / sum_j w_j N_j for the weights N of another. All w_i positive.
Array<double> rationalBasis(const Array<double>& basis, const Array<double>& pointWeights);

}  // namespace karcher

#pragma once

#include <array>

#include "mesh/types.h"

/// Bases of curves: functions from a parameter to weights that sum to 1, one per control point of a
/// segment (Mancinelli, Puppo, Eq. 4). They do not depend on the surface.
namespace karcher {

/// Bernstein polynomials of degree `degree` >= 0 at t in [0, 1], by de Casteljau's recurrence:
/// degree + 1 weights.
Array<double> bernsteinBasis(int degree, double t);
/// The same weights, written to `weights`.
void bernsteinBasis(int degree, double t, Array<double>& weights);

/// The uniform cubic B-spline on one segment, t in [0, 1]: 4 weights.
Array<double> uniformCubicBasis(double t);
std::array<double, 4> uniformCubicWeights(double t);

/// The values at u of the `degree` + 1 B-splines that do not vanish on the knot span [knots[span],
/// knots[span + 1]], by Cox and de Boor's recurrence. u must lie in the span. The knots must not
/// decrease, the span must not be empty, and degree <= span < knots.count() - degree - 1. The
/// weights belong to the control points span - degree to span.
Array<double> bsplineBasis(const Array<double>& knots, int degree, int span, double u);
/// The same weights, written to `weights`.
void bsplineBasis(const Array<double>& knots, int degree, int span, double u,
                  Array<double>& weights);

/// A rational basis: w_i N_i / sum_j w_j N_j, where N is another basis. All w_i are positive.
Array<double> rationalBasis(Array<double> basis, const Array<double>& pointWeights);
/// The same weights, written over the given basis.
void makeRational(const Array<double>& pointWeights, Array<double>& basis);

/// Rational interpolation in barycentric form: weights proportional to (-1)^i beta_i / (t - i / n)
/// for n + 1 positive betas. At t = i / n, point i has exactly the weight 1 (K. Ramanantoanina, K.
/// Hormann, "New shape control tools for rational Bezier curve design", 2021). Equal betas give
/// Berrut's interpolant, binomial coefficients the interpolating polynomial.
Array<double> barycentricBasis(const Array<double>& betas, double t);
/// The same weights, written to `weights`.
void barycentricBasis(const Array<double>& betas, double t, Array<double>& weights);

/// The Catmull-Rom basis, by Barry and Goldman's pyramid of affine averages. The curve passes
/// through four points at the ascending `knots`; u lies between the middle two knots. Writes the 4
/// weights of the points to `weights`; the outer ones may be negative.
void catmullRomBasis(const Array<double>& knots, double u, Array<double>& weights);

}  // namespace karcher

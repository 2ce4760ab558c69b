#include "curves/spec/bases.h"

namespace karcher {

Array<double> bernsteinBasis(int degree, double t) {
  Array<double> weights;
  bernsteinBasis(degree, t, weights);
  return weights;
}

void bernsteinBasis(int degree, double t, Array<double>& weights) {
  weights.assign(static_cast<size_t>(degree) + 1, 0.0);
  weights[0] = 1;
  for (int n = 1; n <= degree; ++n) {
    double carry = 0;
    for (int i = 0; i < n; ++i) {
      const double value = weights[i];
      weights[i] = carry + (1 - t) * value;
      carry = t * value;
    }
    weights[n] = carry;
  }
}

std::array<double, 4> uniformCubicWeights(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
          (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
}

Array<double> uniformCubicBasis(double t) {
  const std::array<double, 4> weights = uniformCubicWeights(t);
  return Array<double>(weights.begin(), weights.end());
}

Array<double> bsplineBasis(const Array<double>& knots, int degree, int span, double u) {
  Array<double> weights;
  bsplineBasis(knots, degree, span, u, weights);
  return weights;
}

void bsplineBasis(const Array<double>& knots, int degree, int span, double u,
                  Array<double>& weights) {
  weights.assign(static_cast<size_t>(degree) + 1, 0.0);
  weights[0] = 1;
  for (int n = 1; n <= degree; ++n) {
    double carry = 0;
    for (int i = 0; i < n; ++i) {
      const double right = knots[span + i + 1];
      const double left = knots[span + i + 1 - n];
      const double part = weights[i] / (right - left);
      weights[i] = carry + (right - u) * part;
      carry = (u - left) * part;
    }
    weights[n] = carry;
  }
}

Array<double> rationalBasis(Array<double> basis, const Array<double>& pointWeights) {
  makeRational(pointWeights, basis);
  return basis;
}

void makeRational(const Array<double>& pointWeights, Array<double>& basis) {
  double sum = 0;
  for (int i = 0; i < basis.count(); ++i) sum += basis[i] *= pointWeights[i];
  for (double& weight : basis) weight /= sum;
}

Array<double> barycentricBasis(const Array<double>& betas, double t) {
  Array<double> weights;
  barycentricBasis(betas, t, weights);
  return weights;
}

void barycentricBasis(const Array<double>& betas, double t, Array<double>& weights) {
  const int n = betas.count() - 1;
  weights.assign(betas.size(), 0.0);
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double gap = n == 0 ? 0 : t - static_cast<double>(i) / n;
    // At a node, and where 1 / gap would overflow, the curve is the point itself.
    if (std::abs(gap) < 1e-300) {
      weights.assign(betas.size(), 0.0);
      weights[i] = 1;
      return;
    }
    weights[i] = (i % 2 == 0 ? betas[i] : -betas[i]) / gap;
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
}

void catmullRomBasis(const Array<double>& knots, double u, Array<double>& weights) {
  // Row i holds the weights of the pyramid's i-th point; each level averages neighbours, over the
  // knots that the two together span.
  double rows[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const auto average = [&](int i, double from, double to) {
    const double s = (u - from) / (to - from);
    for (int k = 0; k < 4; ++k) rows[i][k] = (1 - s) * rows[i][k] + s * rows[i + 1][k];
  };
  for (int i = 0; i < 3; ++i) average(i, knots[i], knots[i + 1]);
  for (int i = 0; i < 2; ++i) average(i, knots[i], knots[i + 2]);
  average(0, knots[1], knots[2]);
  weights.assign(rows[0], rows[0] + 4);
}

}  // namespace karcher

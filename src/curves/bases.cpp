#include "curves/bases.h"

namespace karcher {

Array<double> bernsteinBasis(int degree, double t) {
  Array<double> weights(static_cast<size_t>(degree) + 1, 0.0);
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
  return weights;
}

Array<double> uniformCubicBasis(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
          (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
}

Array<double> rationalBasis(const Array<double>& basis, const Array<double>& pointWeights) {
  Array<double> weights(basis);
  double sum = 0;
  for (int i = 0; i < weights.count(); ++i) sum += weights[i] *= pointWeights[i];
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace karcher

#include "curves/spec/bases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "curve_support.h"

namespace karcher {
namespace {

double sum(const Array<double>& weights) {
  double total = 0;
  for (const double w : weights) total += w;
  return total;
}

Array<double> parameters() {
  Array<double> result;
  for (int i = 0; i <= 100; ++i) result.push_back(i / 100.0);
  return result;
}

Array<double> catmullRomWeights(const Array<double>& knots, double u) {
  Array<double> weights;
  catmullRomBasis(knots, u, weights);
  return weights;
}

TEST(Bases, ArePartitionsOfUnity) {
  const Array<double> knots{0, 0, 0, 0.3, 1.1, 1.1, 2, 2, 2};
  for (const double t : parameters()) {
    for (int degree = 0; degree <= 12; ++degree) {
      EXPECT_NEAR(sum(bernsteinBasis(degree, t)), 1, 1e-14);
    }
    EXPECT_NEAR(sum(uniformCubicBasis(t)), 1, 1e-14);
    EXPECT_NEAR(sum(bsplineBasis(knots, 2, 3, 0.3 + 0.8 * t)), 1, 1e-14);
    EXPECT_NEAR(sum(rationalBasis(bernsteinBasis(3, t), {1, 0.05, 5, 2})), 1, 1e-14);
    EXPECT_NEAR(sum(barycentricBasis({1, 0.5, 3, 1}, t)), 1, 1e-13);
    EXPECT_NEAR(sum(catmullRomWeights({0, 0.5, 2, 2.2}, 0.5 + 1.5 * t)), 1, 1e-14);
  }
}

TEST(Bases, BernsteinIsTheBinomialFormula) {
  for (const double t : parameters()) {
    const Array<double> weights = bernsteinBasis(4, t);
    const double s = 1 - t;
    const double expected[] = {s * s * s * s, 4 * t * s * s * s, 6 * t * t * s * s,
                               4 * t * t * t * s, t * t * t * t};
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(weights[i], expected[i], 1e-15);
  }
}

TEST(Bases, UniformKnotsGiveTheUniformCubic) {
  const Array<double> knots{-3, -2, -1, 0, 1, 2, 3, 4};
  for (const double t : parameters()) {
    const Array<double> general = bsplineBasis(knots, 3, 3, t);
    const Array<double> uniform = uniformCubicBasis(t);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(general[i], uniform[i], 1e-15);
  }
}

TEST(Bases, ClampedKnotsGiveBernstein) {
  const Array<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  for (const double t : parameters()) {
    const Array<double> general = bsplineBasis(knots, 3, 3, t);
    const Array<double> bernstein = bernsteinBasis(3, t);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(general[i], bernstein[i], 1e-15);
  }
}

TEST(Bases, BSplinesReproduceTheParameterFromItsGrevilleAbscissae) {
  const Array<double> knots{0, 0.2, 0.7, 1, 1.5, 2.5, 2.6, 4, 5, 5.5, 7, 8};
  for (int degree = 1; degree <= 5; ++degree) {
    const int span = 5;
    for (const double t : parameters()) {
      const double u = knots[span] + t * (knots[span + 1] - knots[span]);
      Array<double> greville;
      for (int i = span - degree; i <= span; ++i) {
        double mean = 0;
        for (int k = 1; k <= degree; ++k) mean += knots[i + k] / degree;
        greville.push_back(mean);
      }
      EXPECT_NEAR(weightedSum(bsplineBasis(knots, degree, span, u), greville), u, 1e-13);
    }
  }
}

TEST(Bases, ARationalQuadraticTracesTheCircle) {
  const double a = 0.7;  // half of the arc's angle
  const Array<double> x{std::cos(a), 1 / std::cos(a), std::cos(a)};
  const Array<double> y{-std::sin(a), 0, std::sin(a)};
  for (const double t : parameters()) {
    const Array<double> weights = rationalBasis(bernsteinBasis(2, t), {1, std::cos(a), 1});
    EXPECT_NEAR(std::hypot(weightedSum(weights, x), weightedSum(weights, y)), 1, 1e-15);
  }
}

TEST(Bases, BarycentricInterpolatesAndBinomialBetasGiveThePolynomial) {
  const Array<double> betas{1, 2, 1};
  for (int i = 0; i <= 2; ++i) {
    const Array<double> weights = barycentricBasis(betas, i / 2.0);
    for (int k = 0; k <= 2; ++k) EXPECT_EQ(weights[k], k == i ? 1 : 0);
  }
  for (const double t : parameters()) {
    const Array<double> weights = barycentricBasis(betas, t);
    const double lagrange[] = {(2 * t - 1) * (t - 1), 4 * t * (1 - t), t * (2 * t - 1)};
    for (int k = 0; k <= 2; ++k) EXPECT_NEAR(weights[k], lagrange[k], 1e-14);
  }
  // Next to a node the weights stay finite and near the node's.
  EXPECT_NEAR(barycentricBasis({1, 4, 1}, 0.5 + 1e-15)[1], 1, 1e-12);
}

TEST(Bases, CatmullRomPassesThroughTheMiddlePointsWithTheSameTangent) {
  const Array<double> knots{0, 1, 1.5, 3};
  EXPECT_NEAR(catmullRomWeights(knots, 1)[1], 1, 1e-15);
  EXPECT_NEAR(catmullRomWeights(knots, 1.5)[2], 1, 1e-15);
  // The basis reproduces quadratics in the knots' parameter.
  Array<double> squares;
  for (const double k : knots) squares.push_back(k * k);
  for (const double t : parameters()) {
    const double u = 1 + 0.5 * t;
    EXPECT_NEAR(weightedSum(catmullRomWeights(knots, u), squares), u * u, 1e-14);
  }
}

}  // namespace
}  // namespace karcher

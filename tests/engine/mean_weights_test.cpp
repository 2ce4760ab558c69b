#include "rcm/mean_weights.h"

#include <gtest/gtest.h>

#include "generators/plane.h"
#include "generators/random_points.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"
#include "support.h"

namespace karcher {
namespace {

Array<Vec2> randomVectors(Random& random, int count) {
  Array<Vec2> vectors;
  for (int i = 0; i < count; ++i) {
    vectors.push_back(random.uniform(0.2, 2) * unitVector(random.uniform(0, 2 * kPi)));
  }
  return vectors;
}

/// The imbalance of weights: the difference of their sum from 1, and the norm of the weighted sum.
double imbalance(const Array<Vec2>& vectors, const Array<double>& weights) {
  double sum = -1;
  Vec2 balance = Vec2::Zero();
  for (int i = 0; i < vectors.count(); ++i) {
    sum += weights[i];
    balance += weights[i] * vectors[i];
  }
  return std::max(std::abs(sum), balance.norm());
}

double squaredDistance(const Array<double>& a, const Array<double>& b) {
  double sum = 0;
  for (int i = 0; i < a.count(); ++i) sum += square(a[i] - b[i]);
  return sum;
}

bool canBalance(const Array<Vec2>& vectors, const Array<double>& given) {
  try {
    balancedWeights(vectors, given, true);
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadArgument);
    return false;
  }
}

/// Whether the convex hull contains 0: whether a triangle of three of the vectors does.
bool isAround(const Array<Vec2>& v) {
  for (int i = 0; i < v.count(); ++i) {
    for (int j = 0; j < i; ++j) {
      for (int k = 0; k < j; ++k) {
        const double a = cross(v[i], v[j]), b = cross(v[j], v[k]), c = cross(v[k], v[i]);
        if ((a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0)) return true;
      }
    }
  }
  return false;
}

TEST(MeanWeights, OfThreeVectorsAreProportionalToTheAreasOfTheirTriangles) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Array<Vec2> v = randomVectors(random, 3);
    const double a = cross(v[1], v[2]), b = cross(v[2], v[0]), c = cross(v[0], v[1]);
    const double whole = a + b + c;
    if (std::abs(whole) < 0.05) continue;
    const Array<double> weights = balancedWeights(v, {}, false);
    const double expected[] = {a / whole, b / whole, c / whole};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(weights[k], expected[k], 1e-10);
  }
}

TEST(MeanWeights, ChangeTheGivenWeightsLeast) {
  Random random(5);
  int withHeld = 0;
  for (int i = 0; i < 300; ++i) {
    const int count = 4 + random.index(9);
    const Array<Vec2> vectors = randomVectors(random, count);
    Array<double> given;
    for (int k = 0; k < count; ++k) given.push_back(random.uniform(0.01, 1));
    double sum = 0;
    for (const double weight : given) sum += weight;
    for (double& weight : given) weight /= sum;
    const Array<double> weights = balancedWeights(vectors, given, false);
    EXPECT_LT(imbalance(vectors, weights), 1e-12);
    // Multiplied by the caller they give the same result.
    Array<double> doubled = given;
    for (double& weight : doubled) weight *= 2;
    EXPECT_LT(squaredDistance(balancedWeights(vectors, doubled, false), weights), 1e-24);
    const bool isInside = isAround(vectors);
    EXPECT_EQ(canBalance(vectors, given), isInside);
    if (!isInside) continue;
    const Array<double> sound = balancedWeights(vectors, given, true);
    EXPECT_LT(imbalance(vectors, sound), 1e-12);
    const double least = *std::min_element(sound.begin(), sound.end());
    EXPECT_GE(least, 0);
    withHeld += least == 0;
    EXPECT_GE(squaredDistance(sound, given), squaredDistance(weights, given) - 1e-12);
    // No other feasible weights are nearer: the test moves towards balanced triangles.
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < a; ++b) {
        for (int c = 0; c < b; ++c) {
          const Array<Vec2> corners{vectors[a], vectors[b], vectors[c]};
          if (!isAround(corners)) continue;
          const Array<double> of = balancedWeights(corners, {}, false);
          Array<double> towards = sound;
          for (double& weight : towards) weight *= 1 - 1e-3;
          towards[a] += 1e-3 * of[0];
          towards[b] += 1e-3 * of[1];
          towards[c] += 1e-3 * of[2];
          EXPECT_GE(squaredDistance(towards, given), squaredDistance(sound, given) - 1e-12);
        }
      }
    }
  }
  EXPECT_GT(withHeld, 20);
}

TEST(MeanWeights, OfCollinearVectorsExistIfTheirLineContainsThePoint) {
  const Array<double> weights = balancedWeights({{1, 1}, {-3, -3}}, {}, false);
  EXPECT_NEAR(weights[0], 0.75, 1e-12);
  EXPECT_NEAR(weights[1], 0.25, 1e-12);
  EXPECT_EQ(balancedWeights({{0, 0}}, {}, true), Array<double>{1});
  for (const bool nonNegative : {false, true}) {
    EXPECT_EQ(codeOf([&] {
                balancedWeights({{1, 1}, {1, -3}}, {}, nonNegative);
              }),
              ErrorCode::kBadArgument);
    EXPECT_EQ(codeOf([&] { balancedWeights({{1, 2}}, {}, nonNegative); }), ErrorCode::kBadArgument);
  }
  EXPECT_EQ(codeOf([] { balancedWeights({}, {}, false); }), ErrorCode::kTooFewPoints);
  EXPECT_EQ(codeOf([] { balancedWeights({{1, 0}, {-1, 0}}, {1}, false); }), ErrorCode::kBadWeights);
  EXPECT_EQ(codeOf([] {
              balancedWeights({{1, 0}, {-1, 0}}, {1, -1}, false);
            }),
            ErrorCode::kBadWeights);
  EXPECT_EQ(codeOf([] {
              balancedWeights({{1, 0}, {-1, 0}}, {1, kInfinity}, false);
            }),
            ErrorCode::kBadWeights);
}

TEST(MeanWeights, OnThePlaneSumToOneAndReproduceThePoint) {
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 1500, 3));
  Surface surface(meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 1500, 3)));
  Random random(9);
  for (const Solver solver : {Solver::kFast, Solver::kExact}) {
    FieldSet set(surface, {Method::kKarcher, solver});
    for (int i = 0; i < 60; ++i) {
      Array<SurfacePoint> points;
      for (int k = 0; k < 3 + i % 5; ++k) points.push_back(randomPlace(mesh, random));
      const SurfacePoint x = randomPlace(mesh, random);
      const MeanWeights result = weightsOf(set, x, points, {});
      Vec3 sum = Vec3::Zero();
      double whole = 0;
      double absolute = 0;
      for (int k = 0; k < points.count(); ++k) {
        sum += result.weights[k] * position(mesh, points[k]);
        whole += result.weights[k];
        absolute += std::abs(result.weights[k]);
      }
      // Each log vector's error counts with its weight; positive weights have sum 1.
      EXPECT_NEAR(whole, 1, 1e-12 * absolute);
      EXPECT_LT((sum - position(mesh, x)).norm(), 1e-12 * absolute * surface.geometry().diagonal);
      // For weights of sum 1 the energy is the squared distance from the center plus a constant.
      EXPECT_TRUE(result.isMinimum);
    }
  }
}

/// Points around a place, within some mean edges of it in space.
Array<SurfacePoint> pointsRound(const Geometry& geometry, const SurfacePoint& x, double edges,
                                int count, Random& random) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<SurfacePoint> points;
  for (int k = 0; k < count; ++k) {
    const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    points.push_back(nearestPoint(mesh, position(mesh, x) + edges * geometry.meanEdge * way));
  }
  return points;
}

/// Whether the Hessian of K at a point is positive definite.
bool isDefiniteAt(FieldSet& set, const Array<SurfacePoint>& points, const Array<double>& weights,
                  const SurfacePoint& x) {
  Array<std::shared_ptr<PointField>> fields;
  Array<ControlField*> pointers;
  for (const SurfacePoint& point : points) {
    fields.push_back(set.at(point));
    pointers.push_back(&fields.back()->field());
  }
  FieldBlend blend(set.surface().geometry(), pointers);
  return hessian(set.surface().geometry(), x.face, blend.blend(x.face, weights)).positiveDefinite();
}

TEST(MeanWeights, MakeThePointTheCenterOfMassWhereTheHessianIsPositiveDefinite) {
  SKIP_WHERE_SANITIZED();
  const int cases = longRun() ? 400 : 100;
  Random random(17);
  int stay = 0;
  int lower = 0;
  int indefinite = 0;
  for (const Shape shape : {Shape::kSphere, Shape::kTorus, Shape::kKnot}) {
    Surface surface(meshOf(makeShape(shape, 3000)));
    const TriangleMesh& mesh = surface.mesh();
    FieldSet set(surface, {});
    const double h = surface.geometry().meanEdge;
    for (int i = 0; i < cases; ++i) {
      const SurfacePoint x = randomPlace(mesh, random);
      const double edges = random.uniform(2, 12);
      const Array<SurfacePoint> points =
          pointsRound(surface.geometry(), x, edges, 3 + random.index(4), random);
      MeanWeights result;
      try {
        result = weightsOf(set, x, points, {{}, i % 2 == 1});
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kBadArgument);
        continue;
      }
      const bool isDefinite = isDefiniteAt(set, points, result.weights, x);
      if (!isDefinite) {
        ++indefinite;
        EXPECT_FALSE(result.isMinimum);
        continue;
      }
      MeanOptions options;
      options.start = x;
      options.isChecked = false;
      const Mean zero = centerOfMass(surface, points, result.weights, options);
      EXPECT_EQ(zero.status, Status::kConverged);
      EXPECT_LT((position(mesh, zero.point) - position(mesh, x)).norm(), 1e-9 * h);
      if (!result.isMinimum) {
        // By exact distances, with which the check compares, a place nearby is lower.
        ++lower;
        continue;
      }
      ++stay;
      options.isChecked = true;
      const Mean mean = centerOfMass(surface, points, result.weights, options);
      EXPECT_EQ(mean.status, Status::kConverged);
      EXPECT_LT((position(mesh, mean.point) - position(mesh, x)).norm(), 1e-9 * h);
    }
  }
  std::printf(
      "Hessian positive definite: %d centers that stay, %d where exact distances are lower near "
      "by; %d not\n",
      stay, lower, indefinite);
  EXPECT_GT(stay, cases);
  EXPECT_GT(indefinite, 0);
  EXPECT_LT(lower, stay / 5);
}

}  // namespace
}  // namespace karcher

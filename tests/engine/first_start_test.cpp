#include "rcm/first_start.h"

#include <gtest/gtest.h>

#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"
#include "support.h"

namespace karcher {
namespace {

constexpr uint64_t kSeed = 41;

Array<double> randomWeights(int count, Random& random) {
  Array<double> weights;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    weights.push_back(random.uniform(0.1, 1));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

TEST(FirstStart, OnThePlaneIsTheMeanAndNothingIsLower) {
  const TriangleMesh mesh = planeGrid(20, 20);
  Surface surface(mesh);
  Random random(kSeed);
  for (int run = 0; run < 20; ++run) {
    Array<SurfacePoint> points;
    Vec3 mean = Vec3::Zero();
    double energy = 0;
    const Array<double> weights = randomWeights(5, random);
    for (int i = 0; i < 5; ++i) {
      points.push_back(randomPoint(mesh, random));
      mean += weights[i] * position(mesh, points[i]);
    }
    for (int i = 0; i < 5; ++i) {
      energy += weights[i] * (position(mesh, points[i]) - mean).squaredNorm();
    }
    const std::optional<SurfacePoint> start =
        averageOfAverages(surface.geometry(), points, weights);
    ASSERT_TRUE(start) << "run " << run << ", seed " << kSeed;
    // Each path's end has the rounding of coordinates up to 20, divided by the length of its first
    // piece, which may be short.
    EXPECT_LT((position(mesh, *start) - mean).norm(), 1e-9) << "run " << run;
    const LowerPlaces lower = lowerPlaces(mesh, points, weights, energy);
    EXPECT_LT((lower.middle - mean).norm(), 1e-13 * 20);
    EXPECT_LT(lower.radius, 1e-6) << "the root of the energy's rounding";
  }
}

TEST(FirstStart, IsAbsentForNegativeWeightsAndSeveralComponents) {
  const TriangleMesh grids = twoGrids();
  const Surface surface(grids);
  const Array<SurfacePoint> points{vertexPoint(grids, 0), vertexPoint(grids, 5)};
  const Array<double> negative{1.5, -0.5};
  EXPECT_FALSE(averageOfAverages(surface.geometry(), points, negative));
  const Array<double> half{0.5, 0.5};
  const Array<SurfacePoint> apart{vertexPoint(grids, 0), vertexPoint(grids, 20)};
  EXPECT_FALSE(averageOfAverages(surface.geometry(), apart, half));
}

/// Every lower place lies in the ball that follows from a place's energy.
TEST(FirstStart, ItsBallHoldsEveryLowerPoint) {
  Surface surface(importMesh(makeShape(Shape::kTorus, 2000)).mesh);
  const TriangleMesh& mesh = surface.mesh();
  Random random(kSeed);
  for (int run = 0; run < 20; ++run) {
    Array<SurfacePoint> points;
    for (int i = 0; i < 4; ++i) points.push_back(randomPoint(mesh, random));
    const Array<double> weights = randomWeights(4, random);
    MeanOptions options;
    options.looksForOthers = true;
    const Mean mean = centerOfMass(surface, points, weights, options);
    for (const Minimum& other : mean.otherMinima) {
      const LowerPlaces lower = lowerPlaces(mesh, points, weights, other.energy);
      const double apart = (position(mesh, mean.point) - lower.middle).norm();
      // Energies come from fields, whose distances have an error below a hundredth.
      EXPECT_LE(apart, 1.02 * lower.radius) << "run " << run << ", seed " << kSeed;
    }
  }
}

}  // namespace
}  // namespace karcher

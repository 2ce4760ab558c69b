#include "rcm/mean_of_many.h"

#include <gtest/gtest.h>

#include "cases.h"
#include "curve_support.h"
#include "distance/source_vectors.h"
#include "distance_meshes.h"
#include "generators/gallery.h"
#include "generators/random_points.h"
#include "intrinsic/straightest.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/exact_minimum.h"
#include "rcm/one_source_energy.h"
#include "support.h"

namespace karcher {
namespace {

struct Cloud {
  Array<SurfacePoint> points;
  Array<double> weights;
};

Cloud randomCloud(const TriangleMesh& mesh, Random& random, int count) {
  Cloud cloud;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    cloud.points.push_back(randomPlace(mesh, random));
    cloud.weights.push_back(random.uniform(0.1, 1));
    sum += cloud.weights.back();
  }
  for (double& weight : cloud.weights) weight /= sum;
  return cloud;
}

double exactEnergy(const Geometry& geometry, const Cloud& cloud, const SurfacePoint& place) {
  return ExactEnergy(geometry, cloud.points, cloud.weights).at(place, 0, {place})[0];
}

void expectSame(const Mean& a, const Mean& b) {
  EXPECT_EQ(a.point.face, b.point.face);
  EXPECT_EQ(a.point.bary, b.point.bary);
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.status, b.status);
}

TEST(SourceVectors, AreTheStraightVectorsOnAPlane) {
  const TriangleMesh mesh = planeGrid(14, 9);
  Surface surface(mesh);
  Random random(3);
  SCOPED_TRACE("seed 3");
  for (const Solver solver : {Solver::kFast, Solver::kExact}) {
    const auto distance = makeDistanceSolver(surface, {Method::kKarcher, solver, 6});
    SourceVectors vectors(surface.geometry());
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint source = randomPoint(mesh, random);
      distance->setSource(source);
      distance->grow(kInfinity);
      vectors.setSource(source);
      for (int v = 0; v < mesh.vertexCount(); v += 7) {
        const Vec2 way =
            toFace(surface.geometry(), source.face, mesh.positions[v] - position(mesh, source));
        EXPECT_LT((vectors.at(*distance, v) - way).norm(), 1e-9 * surface.geometry().diagonal);
      }
    }
  }
}

TEST(OneSourceEnergy, IsThatOfShortestPaths) {
  Surface surface(bunnyMesh());
  Random random(4);
  SCOPED_TRACE("seed 4");
  const Cloud cloud = randomCloud(surface.mesh(), random, 20);
  const WeightedPoints points = mergedPoints(cloud.points, cloud.weights);
  ExactOneSourceEnergy energy(surface.geometry(), points);
  for (int i = 0; i < 5; ++i) {
    const SurfacePoint place = randomPlace(surface.mesh(), random);
    const double truth = exactEnergy(surface.geometry(), cloud, place);
    EXPECT_NEAR(energy.at(place).energy, truth, 1e-9 * truth);
  }
}

TEST(OneSourceEnergy, FallsAlongTheNaturalStep) {
  Surface surface(bunnyMesh());
  const Geometry& geometry = surface.geometry();
  Random random(10);
  SCOPED_TRACE("seed 10");
  const Cloud cloud = randomCloud(surface.mesh(), random, 20);
  const WeightedPoints points = mergedPoints(cloud.points, cloud.weights);
  ExactOneSourceEnergy energy(geometry, points);
  for (int i = 0; i < 8; ++i) {
    const SurfacePoint place = randomPoint(surface.mesh(), random);
    const Vec2 step = energy.at(place).step;
    const double length = 1e-5 * geometry.meanEdge;
    for (const Vec2& way : {Vec2(length, 0), Vec2(0, length)}) {
      const double ahead = energy.at(traceStraightest(geometry, place, way).path.end()).energy;
      const double behind = energy.at(traceStraightest(geometry, place, -way).path.end()).energy;
      // The difference comes from the curvature of K, and rounding.
      EXPECT_NEAR((ahead - behind) / (2 * length), -2 * step.dot(way) / length,
                  1e-4 * geometry.meanEdge);
    }
  }
}

TEST(MeanOfMany, IsTheAverageOnAPlane) {
  Surface surface(planeGrid(30, 20));
  Random random(5);
  SCOPED_TRACE("seed 5");
  for (const int count : {kMany, 1000}) {
    const Cloud cloud = randomCloud(surface.mesh(), random, count);
    Vec3 average = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
      average += cloud.weights[i] * position(surface.mesh(), cloud.points[i]);
    }
    double energy = 0;
    for (int i = 0; i < count; ++i) {
      energy +=
          cloud.weights[i] * (position(surface.mesh(), cloud.points[i]) - average).squaredNorm();
    }
    for (const Solver solver : {Solver::kFast, Solver::kExact}) {
      MeanOptions options;
      options.field.solver = solver;
      ASSERT_TRUE(isOfMany(cloud.points, cloud.weights, options));
      const Mean mean = centerOfMass(surface, cloud.points, cloud.weights, options);
      EXPECT_EQ(mean.status, Status::kConverged);
      EXPECT_LT((position(surface.mesh(), mean.point) - average).norm(), 1e-9);
      EXPECT_NEAR(mean.energy, energy, 1e-9 * energy);
    }
  }
}

TEST(MeanOfMany, OfASymmetricSetOnTheSphereIsItsPole) {
  Surface surface(importMesh(icosphere(24)).mesh);
  const Vec3 pole(0.3, -0.5, 0.8);
  const Eigen::Quaterniond up = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), pole);
  Random random(6);
  SCOPED_TRACE("seed 6");
  Cloud cloud;
  // Opposite points on circles of latitude, up to 60 degrees from the pole.
  constexpr int kPairs = 200;
  for (int i = 0; i < kPairs; ++i) {
    const double latitude = random.uniform(0, kPi / 3);
    const double longitude = random.uniform(0, 2 * kPi);
    for (const double turn : {0.0, kPi}) {
      const Vec2 around = std::sin(latitude) * unitVector(longitude + turn);
      cloud.points.push_back(
          nearestPoint(surface.mesh(), up * Vec3(around.x(), around.y(), std::cos(latitude))));
      cloud.weights.push_back(0.5 / kPairs);
    }
  }
  const Mean mean = centerOfMass(surface, cloud.points, cloud.weights, {});
  EXPECT_EQ(mean.status, Status::kConverged);
  // The error is that of the polyhedron against the sphere, and of exact distances.
  EXPECT_LT((position(surface.mesh(), mean.point).normalized() - pole.normalized()).norm(),
            0.05 * surface.geometry().meanEdge);
}

TEST(MeanOfMany, DoesNotDependOnTheOrderOfPoints) {
  Surface surface(bunnyMesh());
  Random random(7);
  SCOPED_TRACE("seed 7");
  const Cloud cloud = randomCloud(surface.mesh(), random, 150);
  const Mean mean = centerOfMass(surface, cloud.points, cloud.weights, {});
  expectSame(centerOfMass(surface, cloud.points, cloud.weights, {}), mean);
  Array<int> order;
  for (int i = 0; i < cloud.points.count(); ++i) order.push_back(i);
  random.shuffle(order);
  Cloud shuffled;
  for (const int i : order) {
    shuffled.points.push_back(cloud.points[i]);
    shuffled.weights.push_back(cloud.weights[i]);
  }
  expectSame(centerOfMass(surface, shuffled.points, shuffled.weights, {}), mean);
}

TEST(MeanOfMany, IsAsLowAsThatOfFields) {
  Surface surface(bunnyMesh());
  const Geometry& geometry = surface.geometry();
  for (int seed = 1; seed <= (longRun() ? 20 : casesOf(3, 1)); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<uint64_t>(seed));
    const Cloud cloud = randomCloud(surface.mesh(), random, 80);
    const Mean mean = centerOfMass(surface, cloud.points, cloud.weights, {});
    EXPECT_EQ(mean.status, Status::kConverged);
    const double energy = exactEnergy(geometry, cloud, mean.point);
    EXPECT_NEAR(mean.energy, energy, 1e-3 * square(geometry.meanEdge));
    // The searches start at every point, and all over the surface.
    MeanOptions options;
    options.looksForOthers = true;
    const Mean ofFields = centerOfMass(surface, cloud.points, cloud.weights, options);
    // Neighbouring minima differ by less.
    EXPECT_LT(energy, 1.01 * exactEnergy(geometry, cloud, ofFields.point));
  }
}

TEST(MeanOfMany, AConvergedMeanMinimizesTheEnergyOfShortestPaths) {
  SKIP_WHERE_SANITIZED();
  for (const char* name : {"ring tube, r = 0.1, quads 7:1", "very rough sheet", "knot"}) {
    SCOPED_TRACE(name);
    Surface surface(galleryMesh(name));
    const double edge = surface.geometry().meanEdge;
    int converged = 0;
    for (int seed = 1; seed <= (longRun() ? 20 : 4); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(static_cast<uint64_t>(seed));
      const Cloud cloud = randomCloud(surface.mesh(), random, seed % 4 == 0 ? 600 : 100);
      const Mean mean = centerOfMass(surface, cloud.points, cloud.weights, {});
      if (mean.status != Status::kConverged) continue;
      ++converged;
      const double radius = kCheckedRadius * edge;
      Array<SurfacePoint> places{mean.point};
      for (const SurfacePoint& place : circleAround(surface.geometry(), mean.point, radius, 13)) {
        places.push_back(place);
      }
      ExactEnergy energy(surface.geometry(), cloud.points, cloud.weights);
      const Array<double> values = energy.at(mean.point, radius, places);
      for (const double value : values) EXPECT_GT(value, values[0] - kLowerBy * square(edge));
    }
    EXPECT_GT(converged, 0);
  }
}

TEST(MeanOfMany, IsUsedForManyDistinctPointsOfPositiveWeight) {
  const TriangleMesh mesh = planeGrid(12, 12);
  Random random(8);
  SCOPED_TRACE("seed 8");
  Cloud cloud = randomCloud(mesh, random, kMany);
  EXPECT_TRUE(isOfMany(cloud.points, cloud.weights, {}));
  MeanOptions options;
  options.looksForOthers = true;
  EXPECT_FALSE(isOfMany(cloud.points, cloud.weights, options));
  options = {};
  options.field = kPaperExact;
  EXPECT_FALSE(isOfMany(cloud.points, cloud.weights, options));
  cloud.weights[3] *= -1;
  EXPECT_FALSE(isOfMany(cloud.points, cloud.weights, {}));
  cloud.weights[3] = 0;
  EXPECT_FALSE(isOfMany(cloud.points, cloud.weights, {}));
  cloud.weights[3] = 0.1;
  cloud.points[3] = cloud.points[4];
  EXPECT_FALSE(isOfMany(cloud.points, cloud.weights, {}));
}

TEST(MeanOfMany, StartedAtItselfIsItself) {
  Surface surface(importMesh(makeShape(Shape::kTorus, 2000)).mesh);
  Random random(9);
  SCOPED_TRACE("seed 9");
  const Cloud cloud = randomCloud(surface.mesh(), random, 100);
  const Mean lowest = centerOfMass(surface, cloud.points, cloud.weights, {});
  MeanOptions options;
  options.start = lowest.point;
  const Mean again = centerOfMass(surface, cloud.points, cloud.weights, options);
  EXPECT_EQ(again.status, Status::kConverged);
  EXPECT_LT((position(surface.mesh(), again.point) - position(surface.mesh(), lowest.point)).norm(),
            0.5 * surface.geometry().meanEdge);
}

}  // namespace
}  // namespace karcher

#include "rcm/mean.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <utility>

#include "curve_support.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "generators/smooth_surface.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

const MeanOptions kPaperMean{kPaperExact, std::nullopt, false};

TEST(Mean, OnARegularGridIsTheAverageWithItsEnergy) {
  Surface surface(planeGrid(12, 12));
  const Array<SurfacePoint> points{nearestPoint(surface.mesh(), Vec3(3, 3.5, 0)),
                                   nearestPoint(surface.mesh(), Vec3(9, 4, 0)),
                                   nearestPoint(surface.mesh(), Vec3(5, 8.25, 0))};
  const Mean mean = centerOfMass(surface, points, {0.25, 0.25, 0.5}, kPaperMean);
  EXPECT_EQ(mean.status, Status::kConverged);
  const Vec3 expected(5.5, 6, 0);
  EXPECT_LT((position(surface.mesh(), mean.point) - expected).norm(), 1e-12);
  EXPECT_GT(mean.iterations, 0);
}

TEST(Mean, OfACapOfTheSphereComesNearerTheTruthUnderRefinement) {
  SKIP_WHERE_SANITIZED();
  const SmoothSurface sphere = smoothSphere();
  const Array<double> weights{0.4, 0.15, 0.25, 0.2};
  // The largest error on the finest mesh, in mean edges.
  const struct {
    FieldOptions field;
    double bound;
  } methods[] = {{{Method::kPaper, Solver::kExact, 6}, 0.1},
                 {{Method::kPaper, Solver::kGraph, 6}, 0.2},
                 {{Method::kKarcher, Solver::kFast, 6}, 0.006},
                 {{Method::kKarcher, Solver::kExact, 6}, 0.003}};
  for (const auto& [field, bound] : methods) {
    double coarser = kInfinity;
    double error = 0;
    double meanEdge = 0;
    for (const int frequency : {6, 12, 24}) {
      Surface surface(importMesh(icosphere(frequency)).mesh);
      Array<SurfacePoint> points;
      Array<Vec3> onSphere;
      for (const Vec3& p :
           {Vec3(0.5, 0.2, 0.8), Vec3(-0.3, 0.5, 0.8), Vec3(-0.1, -0.6, 0.7), Vec3(0.1, 0.1, 1)}) {
        points.push_back(nearestPoint(surface.mesh(), sphere.project(p)));
        onSphere.push_back(sphere.project(position(surface.mesh(), points.back())));
      }
      const Mean mean = centerOfMass(surface, points, weights, {field, std::nullopt, false});
      EXPECT_EQ(mean.status, Status::kConverged);
      const Vec3 truth = smoothCenter(sphere, onSphere, weights, onSphere[3]);
      error = (sphere.project(position(surface.mesh(), mean.point)) - truth).norm();
      meanEdge = surface.geometry().meanEdge;
      EXPECT_LT(error, coarser);
      coarser = error;
    }
    EXPECT_LT(error / meanEdge, bound);
  }
}

/// The bound on long steps is the size of the mesh, not that of its bounding box, which changes
/// when the mesh turns.
TEST(Mean, IsTheSameWhereverTheSurfaceLies) {
  struct Case {
    const char* mesh;
    Array<std::pair<int, int>> corners;  ///< the face and corner of each point
    Array<double> weights;
  };
  const Case cases[] = {{"crumpled sheet, 6 folds",
                         {{1429, 1}, {1773, 1}, {2762, 2}, {7, 2}},
                         {0.28724, 0.312429, 0.242658, 0.157673}},
                        {"very rough sheet",
                         {{230, 2}, {581, 2}, {852, 0}, {2712, 1}},
                         {0.542458, 0.0730141, 0.274081, 0.110447}}};
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  MeanOptions options;
  options.normalize = true;
  for (const Case& given : cases) {
    SCOPED_TRACE(given.mesh);
    Surface surface(galleryMesh(given.mesh));
    Array<SurfacePoint> points;
    for (const auto& [face, corner] : given.corners) {
      points.push_back(vertexPoint(surface.mesh(), surface.mesh().corner(face, corner)));
    }
    Array<Vec3> positions = surface.mesh().positions;
    for (Vec3& p : positions) p = turn * p;
    Surface turned(buildMesh(positions, surface.mesh().faces));
    const Mean center = centerOfMass(surface, points, given.weights, options);
    const Mean there = centerOfMass(turned, points, given.weights, options);
    EXPECT_EQ(center.status, Status::kConverged);
    EXPECT_EQ(there.status, Status::kConverged);
    EXPECT_LE(
        (position(surface.mesh(), there.point) - position(surface.mesh(), center.point)).norm(),
        1e-9 * surface.geometry().diagonal);
  }
}

TEST(Mean, TakesTheCallersDistances) {
  Surface surface(planeGrid(12, 12));
  Array<Array<double>> distances;
  for (const Vec3& p : {Vec3(3, 3.5, 0), Vec3(9, 4, 0)}) {
    Array<double>& field = distances.emplace_back();
    for (const Vec3& x : surface.mesh().positions) field.push_back((x - p).norm());
  }
  const Mean mean = centerOfMassOfDistances(surface, distances, {0.5, 0.5}, kPaperMean);
  EXPECT_EQ(mean.status, Status::kConverged);
  EXPECT_LT((position(surface.mesh(), mean.point) - Vec3(6, 3.75, 0)).norm(), 1e-12);

  distances[1][5] = std::nan("");
  EXPECT_EQ(codeOf([&] {
              centerOfMassOfDistances(surface, distances, {0.5, 0.5}, kPaperMean);
            }),
            ErrorCode::kNotFinite);
  distances[1].pop_back();
  EXPECT_EQ(codeOf([&] {
              centerOfMassOfDistances(surface, distances, {0.5, 0.5}, kPaperMean);
            }),
            ErrorCode::kBadArgument);
}

TEST(Mean, RefusesBadWeights) {
  Surface surface(planeGrid(4, 4));
  const Array<SurfacePoint> points{nearestPoint(surface.mesh(), Vec3(1, 1, 0)),
                                   nearestPoint(surface.mesh(), Vec3(3, 1, 0))};
  const auto mean = [&](const Array<double>& weights, bool normalize = false) {
    MeanOptions options = kPaperMean;
    options.normalize = normalize;
    return centerOfMass(surface, points, weights, options);
  };
  EXPECT_EQ(codeOf([&] { mean({0.5, 0.4}); }), ErrorCode::kBadWeights);
  EXPECT_EQ(codeOf([&] { mean({1}); }), ErrorCode::kBadWeights);
  EXPECT_EQ(codeOf([&] { mean({std::nan(""), 1}); }), ErrorCode::kNotFinite);
  EXPECT_EQ(codeOf([&] { mean({1, -1}, true); }), ErrorCode::kBadWeights);
  EXPECT_EQ(codeOf([&] { centerOfMass(surface, {}, {}, kPaperMean); }), ErrorCode::kTooFewPoints);
  EXPECT_EQ(mean({3, 1}, true).status, Status::kConverged);
}

TEST(Mean, OfManyPointsIsTheSameInBoundedMemory) {
  Surface surface(importMesh(makeShape(Shape::kTorus, 2000)).mesh);
  const uint64_t seed = 5;
  SCOPED_TRACE("seed 5");
  Random random(seed);
  Array<SurfacePoint> points;
  Array<double> weights;
  for (int i = 0; i < 40; ++i) {
    // The points lie on one side of the torus, so that there is one center.
    const Vec2 place(random.uniform(-0.6, 0.6), random.uniform(-1, 1));
    points.push_back(nearestPoint(surface.mesh(), conformalTorus(place)));
    weights.push_back(random.uniform(0.1, 1));
  }
  const FieldOptions fieldOptions[] = {{Method::kKarcher, Solver::kFast, 6},
                                       {Method::kKarcher, Solver::kExact, 6},
                                       {Method::kKarcher, Solver::kGraph, 3},
                                       {Method::kPaper, Solver::kExact, 6}};
  for (const FieldOptions& field : fieldOptions) {
    MeanOptions options;
    options.field = field;
    options.normalize = true;
    const Mean apart = centerOfMass(surface, points, weights, options);
    options.mostValues = 0;
    const Mean summed = centerOfMass(surface, points, weights, options);
    EXPECT_EQ(apart.status, summed.status);
    EXPECT_EQ(apart.otherMinima.count(), summed.otherMinima.count());
    const Vec3 there = position(surface.mesh(), apart.point);
    EXPECT_LT((position(surface.mesh(), summed.point) - there).norm(),
              1e-9 * surface.geometry().diagonal);
    EXPECT_NEAR(apart.energy, summed.energy, 1e-9 * apart.energy);
  }
}

TEST(Mean, KeepsTheFieldsOfPointsThatStay) {
  Surface surface(importMesh(makeShape(Shape::kTorus, 2000)).mesh);
  const uint64_t seed = 6;
  SCOPED_TRACE("seed 6");
  Random random(seed);
  const auto randomPoint = [&] { return SurfacePoint{random.index(200), Vec3(0.2, 0.3, 0.5)}; };
  Array<SurfacePoint> points;
  Array<double> weights;
  for (int i = 0; i < 5; ++i) {
    points.push_back(randomPoint());
    weights.push_back(1);
  }
  MeanOptions options;
  options.normalize = true;
  FieldSets sets(surface);
  std::shared_ptr<FieldSet> kept;
  // Reused fields do not change the results: they equal those of a cold start, bit by bit.
  const auto expectMade = [&](int count) {
    const bool goesOn = kept && kept->options() == options.field;
    const int before = goesOn ? kept->made() : 0;
    const Mean warm = centerOfMass(sets, points, weights, options, kept);
    EXPECT_EQ(kept->made() - before, count);
    const Mean cold = centerOfMass(surface, points, weights, options);
    EXPECT_EQ(warm.point.face, cold.point.face);
    EXPECT_EQ(warm.point.bary, cold.point.bary);
    EXPECT_EQ(warm.energy, cold.energy);
    EXPECT_EQ(warm.iterations, cold.iterations);
  };
  for (const Solver solver : {Solver::kFast, Solver::kExact}) {
    options.field.solver = solver;
    expectMade(points.count());
    for (const double weight : {3.0, 0.5, 16.0}) {
      weights[1] = weight;
      expectMade(0);
    }
    points[2] = randomPoint();
    expectMade(1);
    std::swap(points[0], points[3]);
    expectMade(0);
    points.erase(points.begin());
    weights.pop_back();
    expectMade(0);
    points.insert(points.begin() + 1, randomPoint());
    weights.push_back(2);
    expectMade(1);
  }
}

TEST(Mean, KeepsNoFieldsBeyondTheBudgetOrAfterAnError) {
  Surface surface(planeGrid(12, 12));
  const Array<SurfacePoint> points{nearestPoint(surface.mesh(), Vec3(3, 3.5, 0)),
                                   nearestPoint(surface.mesh(), Vec3(9, 4, 0))};
  FieldSets sets(surface);
  std::shared_ptr<FieldSet> kept;
  MeanOptions options;
  centerOfMass(sets, points, {0.5, 0.5}, options, kept);
  EXPECT_EQ(kept->count(), 2);
  EXPECT_EQ(codeOf([&] { centerOfMass(sets, points, {0.5}, options, kept); }),
            ErrorCode::kBadWeights);
  EXPECT_EQ(kept, nullptr);
  for (const double most : {0.0, 100.0}) {
    options.mostValues = most;
    centerOfMass(sets, points, {0.5, 0.5}, options, kept);
    EXPECT_EQ(kept, nullptr);
  }
}

/// Space does not bound where a lower mean lies if a weight is negative.
TEST(Mean, OfRowsWithNegativeWeightsAreNoHigherThanSingleMeans) {
  const uint64_t seed = 20261127;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Surface surface(importMesh(makeShape(Shape::kTorus, 2000)).mesh);
  MeanOptions options;
  options.isChecked = false;
  FieldSets sets(surface);
  for (int i = 0; i < (longRun() ? 300 : 30); ++i) {
    Array<SurfacePoint> points;
    for (int k = 0; k < 4; ++k) points.push_back(randomPlace(surface.mesh(), random));
    Array<double> rows;
    for (int row = 0; row < 4; ++row) {
      Array<double> weights;
      for (int k = 0; k < 3; ++k) weights.push_back(random.uniform(0.2, 1));
      weights.push_back(random.uniform(-0.8, -0.1));
      const double sum = weights[0] + weights[1] + weights[2] + weights[3];
      for (const double weight : weights) rows.push_back(weight / sum);
    }
    std::shared_ptr<FieldSet> kept;
    const Array<Mean> means = centersOfMass(sets, points, rows, options, kept);
    for (int row = 0; row < 4; ++row) {
      const Array<double> weights(rows.begin() + 4 * row, rows.begin() + 4 * row + 4);
      const Mean single = centerOfMass(sets, points, weights, options, kept);
      if (single.status != Status::kConverged) continue;
      EXPECT_LT(means[row].energy, single.energy + 1e-9) << "set " << i << ", row " << row;
    }
  }
}

TEST(Mean, OfOnePointIsThePoint) {
  Surface surface(bunnyMesh());
  const SurfacePoint one{1876, {0.3, 0.3, 0.4}};
  const SurfacePoint other{300, {0.2, 0.2, 0.6}};
  const struct {
    Array<SurfacePoint> points;
    Array<double> weights;
  } cases[] = {{{one}, {1}},
               {{other, one}, {0, 1}},
               {{one, one, one}, {0.2, 0.3, 0.5}},
               {{one, other, one}, {2, 0, -1}}};
  for (const FieldOptions& field : {kFast, kExact, kPaperExact}) {
    for (const auto& [points, weights] : cases) {
      const Mean mean = centerOfMass(surface, points, weights, {field, std::nullopt, false});
      EXPECT_EQ(mean.status, Status::kConverged);
      EXPECT_EQ(mean.point.face, one.face);
      EXPECT_EQ(mean.point.bary, one.bary);
      EXPECT_EQ(mean.energy, 0);
    }
    const Mean scaled = centerOfMass(surface, {one}, {7}, {field, std::nullopt, true});
    EXPECT_EQ(scaled.point.bary, one.bary);
  }
}

TEST(Mean, HasNoEnergyBelowZeroWithPositiveWeights) {
  Surface surface(bunnyMesh());
  const uint64_t seed = 5;
  Random random(seed);
  for (int i = 0; i < (longRun() ? 200 : 20); ++i) {
    // All points lie in one face, where the squared distances are smallest.
    const int face = random.index(surface.mesh().faceCount());
    Array<SurfacePoint> points;
    Array<double> weights;
    for (int k = 0; k < 3; ++k) {
      const double part = random.uniform();
      points.push_back({face, {0.3 - 1e-6 * part, 0.3 + 1e-6 * part, 0.4}});
      weights.push_back(1 / 3.0);
    }
    for (const FieldOptions& field : {kFast, kPaperExact}) {
      const Mean mean = centerOfMass(surface, points, weights, {field, std::nullopt, true});
      EXPECT_GE(mean.energy, 0) << "seed " << seed << ", face " << face;
    }
  }
}

}  // namespace
}  // namespace karcher

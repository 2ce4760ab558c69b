#include "rcm/uniqueness.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "generators/random.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"
#include "rcm/walk_to_center.h"
#include "support.h"

namespace karcher {
namespace {

/// A saddle: every inner vertex has more than 2 pi of angle.
TriangleMesh saddle(int steps) {
  TriangleMesh mesh = planeGrid(steps, steps);
  for (Vec3& p : mesh.positions) {
    const double x = 2 * p.x() / steps - 1;
    const double y = 2 * p.y() / steps - 1;
    p = Vec3(x, y, x * y);
  }
  return mesh;
}

Mean meanOf(Surface& surface, const Array<SurfacePoint>& points, const Array<double>& weights,
            bool looksForOthers = true) {
  MeanOptions options;
  options.normalize = true;
  options.looksForOthers = looksForOthers;
  return centerOfMass(surface, points, weights, options);
}

Array<SurfacePoint> nearestTo(const Surface& surface, const Array<Vec3>& places) {
  Array<SurfacePoint> points;
  for (const Vec3& place : places) points.push_back(nearestPoint(surface.mesh(), place));
  return points;
}

TEST(Uniqueness, IsCertainForAllPointsOfThePlane) {
  Surface surface(planeGrid(12, 12));
  const Array<SurfacePoint> points =
      nearestTo(surface, {Vec3(0, 0, 0), Vec3(12, 0, 0), Vec3(12, 12, 0), Vec3(1, 11, 0)});
  EXPECT_EQ(meanOf(surface, points, {1, 2, 1, 1}).uniqueness, Uniqueness::kCertain);
  EXPECT_EQ(meanOf(surface, points, {1, 2, 1, 1}, false).uniqueness, Uniqueness::kNotLooked);
  // With negative weights convex energies need not have a convex sum.
  EXPECT_EQ(meanOf(surface, points, {1, 2, -0.5, 1}).uniqueness, Uniqueness::kLikely);
}

TEST(Uniqueness, IsProvedInASaddleAndNotOnACone) {
  Surface bent(saddle(12));
  const Array<Vec3> corners{Vec3(-0.8, -0.8, 0.6), Vec3(0.8, -0.7, -0.6), Vec3(0.1, 0.8, 0.1)};
  EXPECT_EQ(meanOf(bent, nearestTo(bent, corners), {1, 1, 1}).uniqueness, Uniqueness::kCertain);
  // A raised vertex has positive curvature.
  TriangleMesh pulled = planeGrid(12, 12);
  pulled.positions[6 * 13 + 6].z() = 0.5;
  Surface cone(std::move(pulled));
  const Array<Vec3> around{Vec3(2, 2, 0), Vec3(10, 3, 0), Vec3(6, 10, 0)};
  EXPECT_EQ(meanOf(cone, nearestTo(cone, around), {1, 1, 1}).uniqueness, Uniqueness::kLikely);
  // Away from it the ball around the points is flat.
  const Array<Vec3> aside{Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2.5, 0)};
  EXPECT_EQ(meanOf(cone, nearestTo(cone, aside), {1, 1, 1}).uniqueness, Uniqueness::kCertain);
}

TEST(Uniqueness, IsNotCertainAroundAHole) {
  // The faces within reach of these points surround a hole of the plane: flat, but not a disk.
  const TriangleMesh plane = planeGrid(12, 12);
  Array<Triangle> faces;
  for (int f = 0; f < plane.faceCount(); ++f) {
    const Vec3 middle = position(plane, {f, Vec3::Constant(1.0 / 3)}) - Vec3(6, 6, 0);
    if (middle.cwiseAbs().maxCoeff() > 2) faces.push_back(plane.faces[f]);
  }
  Surface ring(importMesh({plane.positions, faces}).mesh);
  const Array<SurfacePoint> points = nearestTo(ring, {Vec3(6, 2, 0), Vec3(3, 9, 0), Vec3(9, 9, 0)});
  const Mean mean = meanOf(ring, points, {1, 1, 1});
  EXPECT_NE(mean.uniqueness, Uniqueness::kCertain);
}

TEST(Uniqueness, OtherMinimaAreSortedByEnergy) {
  Surface surface(importMesh(makeShape(Shape::kSphere, 2000)).mesh);
  // Points around the equator: each pole is a minimum, the northern one the lower.
  const Array<SurfacePoint> points =
      nearestTo(surface, {Vec3(1, 0, 0.1), Vec3(0, 1, 0.1), Vec3(-1, 0, 0.1), Vec3(0, -1, 0.1)});
  const Array<double> weights{1, 1, 1, 1};
  // Searches from the control points find only the nearer pole, and do not look for the other.
  EXPECT_EQ(meanOf(surface, points, weights, false).uniqueness, Uniqueness::kNotLooked);
  const Mean mean = meanOf(surface, points, weights);
  EXPECT_EQ(mean.uniqueness, Uniqueness::kNotUnique);
  EXPECT_GT(position(surface.mesh(), mean.point).z(), 0.99);
  ASSERT_GE(mean.otherMinima.count(), 1);
  EXPECT_LT(position(surface.mesh(), mean.otherMinima.back().point).z(), -0.99);
  double before = mean.energy;
  for (const Minimum& other : mean.otherMinima) {
    EXPECT_GE(other.energy, before);
    before = other.energy;
  }
  // A search that starts at the other pole stays there, but finds the lower one.
  MeanOptions options;
  options.normalize = true;
  options.looksForOthers = true;
  options.start = mean.otherMinima.back().point;
  const Mean other = centerOfMass(surface, points, weights, options);
  EXPECT_LT(position(surface.mesh(), other.point).z(), -0.99);
  EXPECT_LT(other.otherMinima[0].energy, other.energy);
}

TEST(Uniqueness, StartsAreSpreadEvenlyOverTheComponent) {
  Surface surface(importMesh(makeShape(Shape::kSphere, 2000)).mesh);
  const Array<SurfacePoint> starts = spreadPoints(surface, 0, 32);
  EXPECT_EQ(starts.count(), 32);
  // A 32nd of the sphere is a cap of radius 0.36.
  for (int f = 0; f < surface.mesh().faceCount(); f += 7) {
    const Vec3 place = position(surface.mesh(), {f, Vec3::Constant(1.0 / 3)});
    double nearest = kInfinity;
    for (const SurfacePoint& start : starts) {
      nearest = std::min(nearest, (position(surface.mesh(), start) - place).norm());
    }
    EXPECT_LT(nearest, 0.9);
  }
  Surface two(planeGrid(1, 1));
  EXPECT_EQ(spreadPoints(two, 1, 32).count(), 2);
}

/// A mesh, and the largest distance of control points from a random point on it.
struct Setting {
  Setting(const std::string& its, TriangleMesh mesh, double spread,
          std::optional<CurvatureBound> smooth = std::nullopt)
      : name(its), surface(std::move(mesh)), widest(spread), bound(smooth) {}

  std::string name;
  Surface surface;
  double widest;
  std::optional<CurvatureBound> bound;
};

Array<std::unique_ptr<Setting>> settings() {
  Array<std::unique_ptr<Setting>> result;
  const auto add = [&](const char* name, Shape shape, int triangles) {
    result.push_back(std::make_unique<Setting>(name, importMesh(makeShape(shape, triangles)).mesh,
                                               1.2, curvatureBound(shape)));
  };
  add("sphere of 500", Shape::kSphere, 500);
  add("sphere of 5,000", Shape::kSphere, 5000);
  add("torus of 500", Shape::kTorus, 500);
  add("torus of 5,000", Shape::kTorus, 5000);
  add("three rings", Shape::kGenus3, 3000);
  add("wavy sheet", Shape::kOpenSheet, 2000);
  result.push_back(std::make_unique<Setting>("plane", planeGrid(16, 16), 10));
  result.push_back(std::make_unique<Setting>("saddle", saddle(20), 1));
  return result;
}

/// Three to six points that lie within a random radius of a random place in space.
Array<SurfacePoint> randomPoints(Random& random, Setting& setting) {
  const TriangleMesh& mesh = setting.surface.mesh();
  const auto anywhere = [&] {
    const double s = random.uniform();
    const double t = random.uniform() * (1 - s);
    return SurfacePoint{random.index(mesh.faceCount()), Vec3(s, t, 1 - s - t)};
  };
  const Vec3 middle = position(mesh, anywhere());
  const double radius = random.uniform(0.1, 1) * setting.widest;
  const int count = 3 + random.index(4);
  Array<SurfacePoint> points;
  // Usually a few tries find one; the bound is for meshes whose faces are larger than the ball.
  for (int tries = 0; points.count() < count && tries < 10'000; ++tries) {
    const SurfacePoint point = anywhere();
    if ((position(mesh, point) - middle).norm() < radius) points.push_back(point);
  }
  while (points.count() < count) points.push_back(anywhere());
  return points;
}

// A test of certain uniqueness: searches from many places in the ball end at the center, and
// searches from elsewhere find no lower minimum.
TEST(Uniqueness, ACertainMinimumIsReachedFromAThousandStarts) {
  SKIP_WHERE_SANITIZED();
  const uint64_t seed = 16;
  SCOPED_TRACE("seed 16");
  Random random(seed);
  const int cases = longRun() ? 10'000 : 320;
  const int starts = longRun() ? 1000 : 100;
  Array<std::unique_ptr<Setting>> all = settings();
  int counts[4] = {0, 0, 0, 0};
  int movedCenters = 0;
  double farthest = 0;
  for (int k = 0; k < cases; ++k) {
    Setting& setting = *all[k % all.count()];
    Surface& surface = setting.surface;
    const Geometry& geometry = surface.geometry();
    const Array<SurfacePoint> points = randomPoints(random, setting);
    Array<double> weights;
    double sum = 0;
    for (int i = 0; i < points.count(); ++i) {
      weights.push_back(random.uniform(0.05, 1));
      sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    MeanOptions options;
    options.looksForOthers = true;
    options.smooth = setting.bound;
    const Mean mean = centerOfMass(surface, points, weights, options);
    ++counts[static_cast<int>(mean.uniqueness)];
    if (mean.uniqueness != Uniqueness::kCertain) continue;
    // The searches end at the zero of the fields. The check by exact distances (exact_minimum.h),
    // which may move the center, depends only on that zero.
    options.isChecked = false;
    const Mean zero = centerOfMass(surface, points, weights, options);
    SCOPED_TRACE(setting.name + ", case " + std::to_string(k));
    const double radius = provedRadius(surface, points, weights, mean.point, setting.bound);
    ASSERT_GE(radius, 0);
    FieldSets sets(surface);
    const std::shared_ptr<FieldSet> set = sets.of({});
    Array<std::shared_ptr<PointField>> fields;
    Array<ControlField*> pointers;
    for (const SurfacePoint& point : points) fields.push_back(set->at(point));
    for (const auto& field : fields) pointers.push_back(&field->field());
    FieldBlend blend(geometry, std::move(pointers));
    const Vec3 center = position(surface.mesh(), zero.point);
    const double moved = (position(surface.mesh(), mean.point) - center).norm();
    if (moved > 0) ++movedCenters;
    farthest = std::max(farthest, moved / geometry.meanEdge);
    const Array<double> distances =
        distancesFrom(*makeDistanceSolver(surface, {Method::kKarcher, Solver::kExact}), mean.point,
                      surface.mesh().vertexCount());
    for (int s = 0; s < starts; ++s) {
      const SurfacePoint start{random.index(surface.mesh().faceCount()), Vec3::Constant(1.0 / 3)};
      // The ball contains the whole face of the start.
      bool inBall = true;
      for (int c = 0; c < 3; ++c) {
        inBall = inBall && distances[surface.mesh().corner(start.face, c)] <= radius;
      }
      const SearchEnd end = walkToCenter(blend, weights, start);
      const Vec3 there = position(surface.mesh(), end.point);
      if (inBall) {
        EXPECT_EQ(end.status, Status::kConverged);
        EXPECT_LE((there - center).norm(), 0.1 * geometry.meanEdge);
      } else if (end.status == Status::kConverged) {
        const bool isSame = (there - center).norm() <= 0.1 * geometry.meanEdge;
        EXPECT_TRUE(isSame || blend.energy(end.point, weights) > zero.energy);
      }
    }
  }
  std::printf(
      "of %d cases: not looked %.1f %%, certain %.1f %%, likely %.1f %%, not unique %.1f %%\n",
      cases, 100.0 * counts[0] / cases, 100.0 * counts[1] / cases, 100.0 * counts[2] / cases,
      100.0 * counts[3] / cases);
  std::printf("of the certain ones %d were moved by exact distances, by %.2f h at most\n",
              movedCenters, farthest);
  EXPECT_GT(counts[1], cases / 20);
  EXPECT_GT(counts[2], 0);
  EXPECT_GT(counts[3], 0);
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/random_points.h"
#include "generators/renumbered.h"
#include "intrinsic/straightest.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// A mesh with control points, and what maps positions back to those of the first one.
struct Scene {
  TriangleMesh mesh;
  Array<SurfacePoint> points;
  Eigen::Affine3d back = Eigen::Affine3d::Identity();
};

Scene moved(const Scene& scene, const Eigen::Affine3d& motion) {
  Array<Vec3> positions;
  for (const Vec3& p : scene.mesh.positions) positions.push_back(motion * p);
  return {buildMesh(positions, scene.mesh.faces), scene.points, motion.inverse()};
}

Scene renumbered(const Scene& scene, uint64_t seed) {
  const Renumbered other = renumbered(scene.mesh, seed);
  Scene result{other.mesh, {}, scene.back};
  for (const SurfacePoint& p : scene.points) result.points.push_back(other.at(p));
  return result;
}

Array<Vec3> samplePositions(const Scene& scene, const CurveShape& shape, Solver solver) {
  Surface surface{TriangleMesh(scene.mesh)};
  Curve curve(surface, {shape, 17, {Method::kKarcher, solver, 6}}, scene.points);
  Array<Vec3> places;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      EXPECT_EQ(sample.status, SampleStatus::kConverged);
      places.push_back(scene.back * position(surface.mesh(), sample.point));
    }
  }
  return places;
}

double largestDistance(const Array<Vec3>& a, const Array<Vec3>& b) {
  EXPECT_EQ(a.count(), b.count());
  double worst = 0;
  for (int i = 0; i < std::min(a.count(), b.count()); ++i) {
    worst = std::max(worst, (a[i] - b[i]).norm());
  }
  return worst;
}

Array<SurfacePoint> ring(const TriangleMesh& mesh, const Vec3& center, double radius) {
  Array<SurfacePoint> points;
  for (int i = 0; i < 7; ++i) {
    const Vec2 around = radius * (1 + 0.3 * (i % 2)) * unitVector(2 * kPi * i / 7 + 0.2);
    points.push_back(nearestPoint(mesh, center + Vec3(around.x(), around.y(), 0)));
  }
  return points;
}

/// Largest changes, as parts of the bounding box.
struct Changes {
  double motion = 0;
  double scale = 0;
  double renumbering = 0;
  double reversal = 0;
};

Changes changesOf(const Scene& scene, Solver solver) {
  const double diagonal = Surface(TriangleMesh(scene.mesh)).geometry().diagonal;
  Eigen::Affine3d rigid =
      Eigen::Translation3d(3, -2, 0.7) * Eigen::AngleAxisd(1.1, Vec3(0.3, -0.5, 0.8).normalized());
  const Scene turned = moved(scene, rigid);
  const Scene scaled = moved(scene, Eigen::Affine3d(Eigen::Scaling(37.0)));
  const Scene shuffled = renumbered(scene, 5);
  Changes worst;
  for (const CurveShape& shape : everyShape(scene.points.count())) {
    SCOPED_TRACE(std::string(curveKindName(shape.kind)) + (shape.closed ? " closed" : ""));
    const Array<Vec3> places = samplePositions(scene, shape, solver);
    const auto compare = [&](const Scene& other, double& change) {
      const double moving = largestDistance(places, samplePositions(other, shape, solver));
      change = std::max(change, moving / diagonal);
    };
    compare(turned, worst.motion);
    compare(scaled, worst.scale);
    compare(shuffled, worst.renumbering);

    Scene backwards = scene;
    reverseEntries(backwards.points, shape.closed);
    Array<Vec3> reverse = samplePositions(backwards, reversed(shape), solver);
    std::reverse(reverse.begin(), reverse.end());
    // A closed B-spline of degree p starts p - 1 segments later.
    if (shape.closed && shape.kind == CurveKind::kBSpline) {
      std::rotate(reverse.begin(), reverse.begin() + 17 * (shape.degree - 1), reverse.end());
    }
    worst.reversal = std::max(worst.reversal, largestDistance(places, reverse) / diagonal);
  }
  std::printf("largest change: rigid motion %.1e, scale %.1e, renumbering %.1e, reversal %.1e\n",
              worst.motion, worst.scale, worst.renumbering, worst.reversal);
  return worst;
}

TEST(CurveInvariance, WithExactDistancesToRounding) {
  Scene bunny{bunnyMesh(), {}};
  bunny.points = ring(bunny.mesh, Vec3(-3, 7.5, 4), 1.1);
  const Changes changes = changesOf(bunny, Solver::kExact);
  EXPECT_LE(changes.motion, 1e-9);
  EXPECT_LE(changes.scale, 1e-9);
  EXPECT_LE(changes.renumbering, 1e-9);
  EXPECT_LE(changes.reversal, 1e-9);
}

/// A curve's samples in the order of its control points reversed or not, and whether it has
/// bridges.
struct Traced {
  Array<Vec3> places;
  bool bridged = false;
};

Traced tracedOn(Surface& surface, const CurveShape& shape, const Array<SurfacePoint>& points) {
  Curve curve(surface, {shape, 17, kExact}, points);
  Traced traced;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    traced.bridged = traced.bridged || !curve.bridges(j).empty();
    for (const CurveSample& sample : curve.samples(j)) {
      traced.places.push_back(position(surface.mesh(), sample.point));
    }
  }
  return traced;
}

TEST(CurveInvariance, ReversedControlPointsGiveTheSameCurve) {
  const uint64_t seed = 71;
  SCOPED_TRACE("seed " + std::to_string(seed));
  int bridged = 0;
  int bridgedMoved = 0;
  for (const bool knot : {false, true}) {
    Surface surface(knot ? importMesh(makeShape(Shape::kKnot, 3000)).mesh : bunnyMesh());
    const Geometry& geometry = surface.geometry();
    Random random(seed);
    for (int polygon = 0; polygon < (longRun() ? 300 : 2); ++polygon) {
      // From close together to a fifth of the surface.
      const double spacing = geometry.diagonal * random.uniform(0.02, 0.2);
      Array<SurfacePoint> points{randomPoint(surface.mesh(), random)};
      while (points.count() < 6) {
        const Vec2 step = spacing * unitVector(random.uniform(0, 2 * kPi));
        points.push_back(traceStraightest(geometry, points.back(), step).path.end());
      }
      Array<SurfacePoint> back = points;
      std::reverse(back.begin(), back.end());
      for (const CurveShape& shape : everyShape(points.count())) {
        if (shape.closed) continue;
        const Traced forth = tracedOn(surface, shape, points);
        Traced reverse = tracedOn(surface, reversed(shape), back);
        std::reverse(reverse.places.begin(), reverse.places.end());
        const double moved = largestDistance(forth.places, reverse.places) / geometry.diagonal;
        if (forth.bridged || reverse.bridged) {
          ++bridged;
          if (moved > 1e-9) ++bridgedMoved;
          continue;
        }
        EXPECT_LE(moved, 1e-9) << "polygon " << polygon << ", " << describe(shape);
      }
    }
  }
  std::printf("%d curves with bridges, of which %d differ when reversed\n", bridged, bridgedMoved);
  EXPECT_LE(bridgedMoved, 1 + bridged / 20);
}

TEST(CurveInvariance, WithTheFastSolverAndTiesWithinAPartOfAnEdge) {
  // An icosphere is full of equal edges, and paths that tie.
  Scene sphere{importMesh(icosphere(12)).mesh, {}};
  sphere.points = ring(sphere.mesh, Vec3(0.1, 0.05, 0.9), 0.3);
  const Geometry geometry = buildGeometry(sphere.mesh);
  const double most = 0.05 * geometry.meanEdge / geometry.diagonal;
  const Changes changes = changesOf(sphere, Solver::kFast);
  EXPECT_LE(changes.motion, most);
  EXPECT_LE(changes.scale, most);
  EXPECT_LE(changes.renumbering, most);
  EXPECT_LE(changes.reversal, most);
}

TEST(CurveInvariance, AtTheLargestAndSmallestSizes) {
  // By powers of two, which round nothing: 4e28 and 3e-29.
  Scene bunny{bunnyMesh(), {}};
  bunny.points = ring(bunny.mesh, Vec3(-3, 7.5, 4), 1.1);
  for (const double scale : {0x1p95, 0x1p-95}) {
    const Scene scaled = moved(bunny, Eigen::Affine3d(Eigen::Scaling(scale)));
    for (const Solver solver : {Solver::kFast, Solver::kExact}) {
      const Array<Vec3> places = samplePositions(bunny, {CurveKind::kBSpline}, solver);
      const Array<Vec3> others = samplePositions(scaled, {CurveKind::kBSpline}, solver);
      EXPECT_LE(largestDistance(places, others), 1e-9) << scale;
    }
  }
}

}  // namespace
}  // namespace karcher

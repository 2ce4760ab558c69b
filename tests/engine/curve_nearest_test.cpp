#include <gtest/gtest.h>

#include <string>

#include "curve_support.h"
#include "curves/query/measure.h"
#include "generators/curve_shapes.h"
#include "generators/random_points.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

constexpr int kPolygonPoints = 6;

/// Runs an action for curves of all kinds over random points, with three ways of sampling.
template <class Action>
void forRandomCurves(uint64_t seed, const Action& action) {
  Surface bunny(bunnyMesh());
  Surface grid(planeGrid(14, 14));
  Surface sphere(importMesh(icosphere(12)).mesh);
  Random random(seed);
  for (Surface* surface : {&bunny, &grid, &sphere}) {
    for (const CurveShape& shape : everyShape(kPolygonPoints)) {
      const Array<int> all{9, 33, 128, 0};
      for (const int samples : longRun() ? all : Array<int>{all[random.index(all.count())]}) {
        Array<SurfacePoint> points;
        for (int i = 0; i < kPolygonPoints; ++i)
          points.push_back(randomPoint(surface->mesh(), random));
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + describe(shape) + ", " +
                     std::to_string(surface->mesh().faceCount()) + " faces, samples " +
                     std::to_string(samples));
        CurveOptions options = ofLevelZero(shape, samples, kFast);
        if (samples == 0) options.samples = 2, options.tolerance = 1e-3;
        Curve curve(*surface, options, points);
        action(curve, random);
      }
    }
  }
}

TEST(CurveNearest, OfAPointOfTheCurveIsThatPoint) {
  const uint64_t seed = 11;
  double worst = 0;
  forRandomCurves(seed, [&](Curve& curve, Random& random) {
    const TriangleMesh& mesh = curve.surface().mesh();
    const double diagonal = curve.surface().geometry().diagonal;
    const CurveLine line = lineOf(curve);
    for (int i = 0; i < 12; ++i) {
      const double t = random.uniform() * curve.segmentCount();
      const Vec3 place = position(mesh, pointAt(curve, t).point);
      const NearestOnCurve nearest = nearestOnCurve(curve, line, place);
      worst = std::max(worst, nearest.distance / diagonal);
      // The parameter is accurate to 1e-12, and a length of the diagonal takes at least 1e-2 of it.
      EXPECT_LT(nearest.distance, 1e-10 * diagonal) << "t " << t;
      const CurvePoint there = pointAt(curve, nearest.at.parameter);
      EXPECT_EQ(position(mesh, there.point), position(mesh, nearest.at.point));
      EXPECT_EQ(there.status, nearest.at.status);
      EXPECT_NEAR((position(mesh, there.point) - place).norm(), nearest.distance, 1e-14 * diagonal);
    }
  });
  std::printf("nearest to a place on the curve: at most %.1e of the diagonal away\n", worst);
}

TEST(CurveNearest, NoOtherPointOfTheCurveIsNearer) {
  SKIP_WHERE_SANITIZED();
  const uint64_t seed = 12;
  forRandomCurves(seed, [](Curve& curve, Random& random) {
    const TriangleMesh& mesh = curve.surface().mesh();
    const double diagonal = curve.surface().geometry().diagonal;
    const CurveLine line = lineOf(curve);
    const Vec3 from = position(mesh, randomPoint(mesh, random));
    const Vec3 off = 0.1 * diagonal * Vec3(random.uniform(), random.uniform(), random.uniform());
    for (const Vec3& place : {from, Vec3(from + off)}) {
      const NearestOnCurve nearest = nearestOnCurve(curve, line, place);
      const int looks = longRun() ? 400 : 100;
      for (int i = 0; i <= looks; ++i) {
        const CurvePoint other =
            pointAt(curve, static_cast<double>(i) * curve.segmentCount() / looks);
        EXPECT_GT((position(mesh, other.point) - place).norm(), nearest.distance - 1e-9 * diagonal)
            << "parameter " << other.parameter << " instead of " << nearest.at.parameter;
      }
    }
  });
}

TEST(CurveNearest, LooksAcrossTheStartOfAClosedCurve) {
  Surface surface(planeGrid(14, 14));
  const TriangleMesh& mesh = surface.mesh();
  const Array<SurfacePoint> points =
      pointsNear(mesh, {{4, 4, 0}, {6, 9, 0}, {9, 10, 0}, {10, 6, 0}, {7, 4, 0}, {5, 2, 0}});
  for (const CurveKind kind : {CurveKind::kBSpline, CurveKind::kCatmullRom}) {
    Curve curve(surface, ofLevelZero({kind, true}, 9, kFast), points);
    const CurveLine line = lineOf(curve);
    for (const double t : {-1e-3, -1e-9, 1e-9, 1e-3}) {
      const Vec3 place = position(mesh, pointAt(curve, t).point);
      EXPECT_LT(nearestOnCurve(curve, line, place).distance, 1e-10);
    }
  }
}

TEST(CurveMeasure, LengthsOfAClosedCurveEndWithTheWhole) {
  Surface surface(planeGrid(14, 14));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{4, 4, 0}, {6, 9, 0}, {9, 10, 0}, {10, 6, 0}});
  for (const CurveShape& shape : everyShape(4)) {
    if (shape.kind == CurveKind::kBSpline && shape.degree > 3 && !shape.closed) continue;
    Curve curve(surface, ofLevelZero(shape, 9, kFast), points);
    const CurveLine line = lineOf(curve);
    EXPECT_EQ(lengthAt(curve, line, 0), 0);
    EXPECT_EQ(lengthAt(curve, line, curve.segmentCount()), line.path.lengths.back());
    if (!shape.closed) continue;
    EXPECT_EQ(lengthAt(curve, line, 2 * curve.segmentCount()), line.path.lengths.back());
    EXPECT_EQ(lengthAt(curve, line, -curve.segmentCount()), 0);
  }
}

TEST(CurveMeasure, ErrorsStateAllDigitsOfAParameter) {
  Surface surface(planeGrid(14, 14));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{4, 4, 0}, {6, 9, 0}, {9, 10, 0}, {10, 6, 0}});
  Curve curve(surface, ofLevelZero({CurveKind::kCatmullRom}, 9, kFast), points);
  try {
    pointAt(curve, 3.000000000001);
    FAIL() << "a parameter beyond the end was taken";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the curve has no parameter 3.000000000001: it runs from 0 to 3");
  }
}

}  // namespace
}  // namespace karcher

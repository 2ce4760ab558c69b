#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "cases.h"
#include "curve_support.h"
#include "curves/curve.h"
#include "curves/query/evaluate.h"
#include "generators/control_polygons.h"
#include "generators/flat.h"
#include "generators/gallery.h"
#include "generators/random_points.h"
#include "generators/sphere.h"
#include "measures/polyline_distance.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// The largest distance between points of two curves at even parameters.
double largestDistance(Curve& a, Curve& b) {
  double largest = 0;
  for (int i = 0; i <= 32; ++i) {
    const TriangleMesh& mesh = a.surface().mesh();
    largest = std::max(largest, (position(mesh, pointAt(a, i / 32.0).point) -
                                 position(mesh, pointAt(b, i / 32.0).point))
                                    .norm());
  }
  return largest;
}

Array<SurfacePoint> pointsOnCircle(const TriangleMesh& mesh, double leg) {
  Array<SurfacePoint> points;
  for (int i = 0; i < 4; ++i) {
    const Vec3 place(std::cos(leg * i), std::sin(leg * i), 0.4 * std::sin(2.0 * leg * i));
    points.push_back(nearestPoint(mesh, place));
  }
  return points;
}

TEST(AutomaticLevels, Are0OnASmoothSurfaceWhereTheyWouldMoveTheCurve) {
  // On the sphere far points have no level on any mesh, near ones as many as stay quick.
  const int sizes[] = {8000, 32000};
  for (const int triangles : casesOf(sizes, 1)) {
    Surface surface(meshOf(makeShape(Shape::kSphere, triangles)));
    const double edge = surface.geometry().meanEdge;
    for (const double leg : {0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 0.9}) {
      SCOPED_TRACE(std::to_string(triangles) + " triangles, legs of " + std::to_string(leg));
      const Array<SurfacePoint> points = pointsOnCircle(surface.mesh(), leg);
      const CurveOptions options = levelsOptions({CurveKind::kBezier}, 65, kAutomaticLevels, kFast);
      Curve curve(surface, options, points);
      if (leg >= 0.4) {
        EXPECT_EQ(curve.levels(), 0);
      }
      EXPECT_LE(curve.deviation(), kLevelsTolerance * edge);
      Curve centers(surface, levelsOptions({CurveKind::kBezier}, 65, 0, kFast), points);
      EXPECT_LE(largestDistance(curve, centers), 0.03 * edge);
      // A draft of the curve is quick.
      CurveOptions draft = options;
      draft.levelsTolerance = kInfinity;
      Curve quick(surface, draft, points);
      if (leg > 5 * edge) {
        EXPECT_GT(quick.levels(), 0);
      }
      // The reported deviation is correct to second order in the curvature.
      const double deviation = largestDistance(quick, centers);
      if (leg <= 0.3 && quick.levels() > 0 && deviation > 0.01 * edge) {
        EXPECT_LE(deviation, quick.deviation() + 0.01 * edge);
        EXPECT_GE(deviation, 0.4 * quick.deviation());
      }
    }
  }
}

TEST(AutomaticLevels, OfSegmentsAllAroundAClosedCurveReportTheirDeviation) {
  Surface surface(meshOf(makeShape(Shape::kSphere, 32000)));
  const double edge = surface.geometry().meanEdge;
  for (const CurveKind kind : {CurveKind::kBSpline, CurveKind::kBezier}) {
    const CurveShape shape{kind, true};
    const int count = kind == CurveKind::kBSpline ? 3 : 6;
    for (const double radius : {0.3, 0.4}) {
      SCOPED_TRACE(std::to_string(count) + " points at radius " + std::to_string(radius));
      Array<Vec3> places;
      for (int i = 0; i < count; ++i) {
        const Vec2 around = std::sin(radius) * unitVector(0.2 + 2 * kPi * i / count);
        places.emplace_back(around.x(), around.y(), std::cos(radius));
      }
      const Array<SurfacePoint> points = pointsNear(surface.mesh(), places);
      Curve levels(surface, levelsOptions(shape, 65, 4, kExact), points);
      Curve centers(surface, levelsOptions(shape, 65, 0, kExact), points);
      const double deviation = largestDistance(levels, centers);
      EXPECT_LE(deviation, levels.deviation() + 0.01 * edge);
      EXPECT_GE(deviation + 0.01 * edge, 0.4 * levels.deviation());
    }
  }
}

TEST(AutomaticLevels, DoNotDependOnTheTrianglesOfADevelopableSurface) {
  // Levels do not move the curve on such a surface, and every point is safe.
  const FlatCylinder cylinder = flatCylinder(24, 3, 5);
  Surface surface(meshOf(cylinder.soup));
  Random random(2);
  for (int i = 0; i < 10; ++i) {
    const Array<SurfacePoint> points =
        randomControlPolygon(surface.geometry(), random, {.spacing = 0.12});
    Curve curve(surface, levelsOptions({CurveKind::kBezier}, 65, kAutomaticLevels, kExact), points);
    EXPECT_LE(curve.deviation(), 1e-9);
    Curve centers(surface, levelsOptions({CurveKind::kBezier}, 65, 0, kExact), points);
    EXPECT_LE(largestDistance(curve, centers), 1e-6 * surface.geometry().diagonal);
  }
}

TEST(AutomaticLevels, NeverRelyOnWrongFields) {
  SKIP_WHERE_SANITIZED();
  // Paths on the inside of a ring tube bend around many vertices.
  Random random(4);
  int zeros = 0;
  const int tubes = casesOf(12, 3);
  for (int i = 0; i < tubes; ++i) {
    const double radius = 0.01 * std::pow(30.0, random.uniform());
    const int around = 12 + static_cast<int>(random.uniform(0, 100));
    const int along = 6 + static_cast<int>(random.uniform(0, 18));
    SCOPED_TRACE("tube " + std::to_string(i) + " of radius " + std::to_string(radius) + ", " +
                 std::to_string(around) + " x " + std::to_string(along));
    Surface surface(meshOf(ringTube(radius, around, along)));
    for (const double spacing : {0.05, 0.1, 0.2}) {
      const Array<SurfacePoint> points =
          randomControlPolygon(surface.geometry(), random, {.spacing = spacing});
      Curve curve(surface, levelsOptions({CurveKind::kBezier}, 65, kAutomaticLevels, kFast),
                  points);
      Curve exact(surface, levelsOptions({CurveKind::kBezier}, 65, curve.levels(), kExact), points);
      EXPECT_LE(largestDistance(curve, exact), 0.02 * curve.path(0).line.length())
          << "legs of " << spacing << ", " << curve.levels() << " levels";
      zeros += static_cast<int>(curve.levels() == 0);
    }
  }
  std::printf("of %d curves on ring tubes %d have no level\n", 3 * tubes, zeros);
}

TEST(AutomaticLevels, MakeCurvesAroundATubeSafe) {
  // The shortest path between its ends passes on the other side.
  Surface surface(meshOf(makeShape(Shape::kTorus, 20000)));
  Array<SurfacePoint> points;
  for (const double angle : {0.0, 1.4, 2.8, 4.2}) {
    const double out = 1 + 0.4 * std::cos(angle);
    points.push_back(nearestPoint(
        surface.mesh(),
        Vec3(out * std::cos(angle / 9), out * std::sin(angle / 9), 0.4 * std::sin(angle))));
  }
  const Curve curve(surface, levelsOptions({CurveKind::kBezier}, 65, kAutomaticLevels, kFast),
                    points);
  EXPECT_GT(curve.levels(), 1);
  EXPECT_TRUE(curve.bridges(0).empty());
}

TEST(AutomaticLevels, AreTheSameBesideAPartOfHugeTriangles) {
  // The legs go around a tube, and just beyond half of it the shortest path goes the other way.
  const TriangleSoup torus = makeShape(Shape::kTorus, 8000);
  CurveOptions options = levelsOptions({CurveKind::kBezier}, 17, kAutomaticLevels, kFast);
  options.levelsTolerance = 0;
  for (const double span : {2.6, 3.3, 3.6, 4.2}) {
    SCOPED_TRACE("span " + std::to_string(span));
    Array<Vec3> places;
    for (int i = 0; i < 4; ++i) {
      const double angle = span * i / 3;
      const double out = 1 + 0.4 * std::cos(angle);
      places.emplace_back(out * std::cos(angle / 9), out * std::sin(angle / 9),
                          0.4 * std::sin(angle));
    }
    int levels = -1;
    for (const double size : {0.0, 1e2, 1e4, 1e6}) {
      TriangleSoup soup = torus;
      const int first = soup.positions.count();
      for (const Vec3& p : icosphere(1).positions) {
        if (size > 0) soup.positions.push_back(size * p + Vec3(0, 0, 3 * size));
      }
      for (const Triangle& corners : icosphere(1).triangles) {
        if (size > 0) {
          soup.triangles.push_back({corners[0] + first, corners[1] + first, corners[2] + first});
        }
      }
      Surface surface(meshOf(soup));
      const Curve curve(surface, options, pointsNear(surface.mesh(), places));
      if (size == 0) levels = curve.levels();
      EXPECT_EQ(curve.levels(), levels) << "size " << size;
    }
    EXPECT_EQ(levels == 0, span < kPi);
  }
}

Array<Vec3> positionsOf(const Curve& curve) {
  Array<Vec3> positions;
  for (const SurfacePoint& p : curve.path(0).line.points) {
    positions.push_back(position(curve.surface().mesh(), p));
  }
  return positions;
}

TEST(AutomaticLevels, AreEnoughAroundTheRimOfAnEar) {
  // A flat ellipsoid: legs on its sides do not see the rim that the curve crosses.
  TriangleSoup ear = icosphere(10);
  for (Vec3& p : ear.positions) p = p.cwiseProduct(Vec3(1, 0.6, 0.15));
  Surface surface(meshOf(ear));
  const Geometry& geometry = surface.geometry();
  Random random(1);
  int atRims = 0;
  for (int i = 0; i < 60; ++i) {
    const Array<SurfacePoint> points = randomControlPolygon(
        geometry, random, {.spacing = 4 * geometry.meanEdge / geometry.diagonal});
    const Curve curve(surface, levelsOptions({CurveKind::kBezier}, 65, kAutomaticLevels, kFast),
                      points);
    const Curve limit(surface, levelsOptions({CurveKind::kBezier}, 65, kLimitLevels, kFast),
                      points);
    const double length = limit.path(0).line.length();
    const double moved = hausdorffDistance(MeasuredPolyline(positionsOf(curve)),
                                           MeasuredPolyline(positionsOf(limit)), 1e-4 * length);
    EXPECT_TRUE(curve.bridges(0).empty()) << "polygon " << i;
    // The curve of level 0 differs.
    if (curve.levels() > 0) {
      EXPECT_LE(moved, 0.005 * length) << "polygon " << i << ", " << curve.levels() << " levels";
    }
    const auto isAtRim = [](const Vec3& p) { return std::abs(p.z()) < 0.05; };
    const Array<Vec3> line = positionsOf(limit);
    atRims += static_cast<int>(std::any_of(line.begin(), line.end(), isAtRim));
  }
  EXPECT_GT(atRims, 20);
}

/// Checks that a curve has a known deviation within the tolerance, and lies where the curve of
/// centers of mass does.
void expectNearCenters(Surface& surface, const CurveShape& shape,
                       const Array<SurfacePoint>& points) {
  const double edge = surface.geometry().meanEdge;
  Curve curve(surface, levelsOptions(shape, 33, kAutomaticLevels, kFast), points);
  Curve centers(surface, levelsOptions(shape, 33, 0, kFast), points);
  EXPECT_LE(curve.deviation(), kLevelsTolerance * edge) << curve.levels() << " levels";
  EXPECT_LE(largestDistance(curve, centers), 0.03 * edge) << curve.levels() << " levels";
}

TEST(AutomaticLevels, OfNearlyEqualPointsKeepTheTolerance) {
  // A point is dragged onto its neighbour; the two meet at last. Three legs of the torus are
  // shorter than half of its tube.
  Random random(8);
  for (const Shape shape : {Shape::kSphere, Shape::kTorus}) {
    Surface surface(meshOf(makeShape(shape, 20000)));
    const TriangleMesh& mesh = surface.mesh();
    for (int i = 0; i < casesOf(12, 3); ++i) {
      const Array<SurfacePoint> apart =
          randomControlPolygon(surface.geometry(), random, {.spacing = 0.08});
      const int first = i % 3;
      for (const double gap : {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 0.0}) {
        SCOPED_TRACE("polygon " + std::to_string(i) + ", gap " + std::to_string(gap));
        Array<SurfacePoint> points = apart;
        const Vec3 place = position(mesh, points[first]);
        const Vec3 next = position(mesh, points[first + 1]);
        points[first + 1] = nearestPoint(mesh, (1 - gap) * place + gap * next);
        expectNearCenters(surface, {CurveKind::kBezier}, points);
      }
    }
  }
}

TEST(AutomaticLevels, OfRepeatedPointsKeepTheTolerance) {
  Surface surface(meshOf(makeShape(Shape::kSphere, 20000)));
  Random random(9);
  for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kBSpline, CurveKind::kCatmullRom}) {
    for (int i = 0; i < casesOf(9, 3); ++i) {
      SCOPED_TRACE(describe({kind}) + ", polygon " + std::to_string(i));
      Array<SurfacePoint> points =
          randomControlPolygon(surface.geometry(), random, {.spacing = 0.15});
      points[1 + i % 2] = points[2 - i % 2];
      expectNearCenters(surface, {kind}, points);
    }
  }
}

}  // namespace
}  // namespace karcher

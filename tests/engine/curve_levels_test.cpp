#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "cases.h"
#include "curve_support.h"
#include "curves/curve.h"
#include "curves/query/evaluate.h"
#include "curves/query/measure.h"
#include "generators/control_polygons.h"
#include "generators/flat.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/sphere.h"
#include "intrinsic/straightest.h"
#include "measures/polyline_distance.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

CurveOptions optionsOf(const CurveShape& shape, int samples, int levels, FieldOptions field) {
  CurveOptions options{shape, samples, field};
  options.levels = levels;
  return options;
}

/// The largest distance between the samples of two curves, which have the same parameters.
double largestGap(const Curve& a, const Curve& b) {
  const TriangleMesh& mesh = a.surface().mesh();
  double gap = 0;
  EXPECT_EQ(a.segmentCount(), b.segmentCount());
  for (int j = 0; j < a.segmentCount(); ++j) {
    EXPECT_EQ(a.samples(j).count(), b.samples(j).count());
    for (int i = 0; i < a.samples(j).count(); ++i) {
      const CurveSample& p = a.samples(j)[i];
      const CurveSample& q = b.samples(j)[i];
      EXPECT_EQ(p.t, q.t);
      EXPECT_EQ(p.status, q.status);
      gap = std::max(gap, (position(mesh, p.point) - position(mesh, q.point)).norm());
    }
  }
  return gap;
}

void expectIdentical(const Curve& a, const Curve& b) {
  EXPECT_EQ(a.levels(), b.levels());
  EXPECT_EQ(largestGap(a, b), 0);
  for (int j = 0; j < a.segmentCount(); ++j) {
    EXPECT_EQ(a.path(j).line.length(), b.path(j).line.length());
    EXPECT_EQ(a.path(j).line.points.count(), b.path(j).line.points.count());
  }
}

TEST(CurveLevels, OfThePlaneAreTheSameCurve) {
  SKIP_WHERE_SANITIZED();
  Surface surface(meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 2000, 7)));
  const Array<SurfacePoint> points = pointsNear(surface.mesh(), kPlaces);
  const double diagonal = surface.geometry().diagonal;
  double worst = 0;
  int compared = 0;
  for (const CurveShape& shape : everyShape(points.count())) {
    if (!takesLevels(shape.kind)) continue;
    SCOPED_TRACE(describe(shape));
    Curve center(surface, optionsOf(shape, 33, 0, kExact), points);
    for (int levels = 1; levels <= 5; ++levels) {
      SCOPED_TRACE("levels " + std::to_string(levels));
      Curve curve(surface, optionsOf(shape, 33, levels, kExact), points);
      EXPECT_EQ(curve.levels(), levels);
      EXPECT_EQ(curve.piecesPerSegment(), 1 << levels);
      const double gap = largestGap(center, curve) / diagonal;
      worst = std::max(worst, gap);
      EXPECT_LE(gap, 1e-12);
      for (double u = 0.03; u < curve.segmentCount(); u += 0.17) {
        const CurveTangent a = tangentAt(center, u);
        const CurveTangent b = tangentAt(curve, u);
        EXPECT_LE(
            (position(surface.mesh(), a.at.point) - position(surface.mesh(), b.at.point)).norm(),
            1e-12 * diagonal);
        // Derivatives of the weights are difference quotients (evaluate.cpp).
        EXPECT_LE((a.inSpace - b.inSpace).norm(), 1e-6 * (1 + a.inSpace.norm()));
      }
      EXPECT_NEAR(lineOf(curve).path.lengths.back(), lineOf(center).path.lengths.back(),
                  2e-3 * diagonal);
      ++compared;
    }
  }
  EXPECT_GE(compared, 60);
  std::printf("largest gap between levels on the plane: %.1e of the bounding box\n", worst);
}

/// New points between knots that nearly coincide are averages like any others.
TEST(CurveLevels, OfKnotsThatNearlyCoincideAreTheSameCurve) {
  Surface surface(meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 500, 9)));
  const Array<SurfacePoint> points = pointsNear(surface.mesh(), kPlaces);
  ASSERT_GE(points.count(), 6);
  const Array<SurfacePoint> six(points.begin(), points.begin() + 6);
  for (const double apart : {1e-3, 1e-6, 1e-8, 1e-10, 1e-14, 0x1p-52}) {
    SCOPED_TRACE(apart);
    for (const bool closed : {false, true}) {
      CurveShape shape{CurveKind::kBSpline, closed, 3, KnotRule::kOwn};
      if (closed) {
        shape.knots = {0, 0.5, 1, 1 + apart, 1.5, 1.7, 2};
      } else {
        shape.knots = {0, 0, 0, 0, 1, 1 + apart, 2, 2, 2, 2};
      }
      Curve center(surface, optionsOf(shape, 17, 0, kExact), six);
      for (const int levels : {1, 3, 5, kMostLevels}) {
        SCOPED_TRACE("levels " + std::to_string(levels));
        Curve curve(surface, optionsOf(shape, 17, levels, kExact), six);
        ASSERT_EQ(curve.segmentCount(), center.segmentCount());
        EXPECT_LE(largestGap(center, curve), 1e-11 * surface.geometry().diagonal);
      }
    }
  }
}

TEST(CurveLevels, OfThePlaneKeepTolerancesAndCrossEdgesExactly) {
  Surface surface(meshOf(tessellatedPlane(PlaneTessellation::kStretchedRandom, 2000, 8)));
  const Array<SurfacePoint> points = pointsNear(surface.mesh(), kPlaces);
  for (const bool exact : {false, true}) {
    CurveOptions options = optionsOf({CurveKind::kBSpline}, 65, 3, kExact);
    options.tolerance = exact ? 0 : 1e-4;
    options.geometry = exact ? CurveGeometry::kExact : CurveGeometry::kGeodesic;
    Curve curve(surface, options, points);
    options.levels = 0;
    Curve center(surface, options, points);
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (int i = 0; i < curve.path(j).line.points.count(); ++i) {
        const Vec3 place = position(surface.mesh(), curve.path(j).line.points[i]);
        const NearestOnCurve nearest = nearestOnCurve(center, lineOf(center), place);
        EXPECT_LE(nearest.distance, (exact ? 1e-12 : 1e-4) * surface.geometry().diagonal);
        if (i % 7 != 0) i += 5;
      }
      EXPECT_EQ(curve.samples(j).front().t, 0);
      EXPECT_EQ(curve.samples(j).back().t, 1);
    }
  }
}

/// On a sphere the deviation from the center of mass is of third order in the polygon's size.
TEST(CurveLevels, ApproachTheCenterOfMassWithTheThirdPowerOfTheSize) {
  Surface surface(meshOf(relaxedSphere(20000, 3)));
  const TriangleMesh& mesh = surface.mesh();
  Array<double> gaps;
  for (const double size : {0.8, 0.4}) {
    Array<SurfacePoint> points;
    for (const Vec2& at : {Vec2(0, 0), Vec2(0.5, 0.6), Vec2(1, -0.4), Vec2(1.5, 0.3)}) {
      points.push_back(nearestPoint(mesh, Vec3(size * at.x(), size * at.y(), 1).normalized()));
    }
    Curve center(surface, optionsOf({CurveKind::kBezier}, 33, 0, kExact), points);
    Curve curve(surface, optionsOf({CurveKind::kBezier}, 33, 2, kExact), points);
    gaps.push_back(largestGap(center, curve));
  }
  std::printf("from the center of mass: %.2e of the radius, at half the size %.2e\n", gaps[0],
              gaps[1]);
  EXPECT_LT(gaps[0], 0.05);
  EXPECT_GT(gaps[0] / gaps[1], 6);
}

TEST(CurveLevels, RunBackwardsGiveTheSameCurve) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const double diagonal = surface.geometry().diagonal;
  const uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random dice(seed);
  double worst = 0;
  int compared = 0;
  for (const CurveShape& shape : everyShape(6)) {
    if (!takesLevels(shape.kind)) continue;
    SCOPED_TRACE(describe(shape));
    Array<SurfacePoint> points;
    SurfacePoint last = nearestPoint(mesh, Vec3(-3, 7.5, 4));
    for (int i = 0; i < 6; ++i) {
      points.push_back(last);
      const double angle = dice.uniform(0, 2 * kPi);
      last = traceStraightest(surface.geometry(), last, 0.06 * diagonal * unitVector(angle))
                 .path.end();
    }
    Curve forth(surface, optionsOf(shape, 17, 2, kExact), points);
    Curve back(surface, reversed(forth.value()));
    bool isBridged = false;
    double gap = 0;
    const int segments = forth.segmentCount();
    // A closed curve keeps its first point, and a closed B-spline's span j blends point j and those
    // behind it.
    const bool isShifted = shape.closed && shape.kind == CurveKind::kBSpline;
    const int end = segments - (isShifted ? shape.degree - 1 : 0);
    for (int j = 0; j < segments; ++j) {
      isBridged = isBridged || !forth.bridges(j).empty();
      for (const CurveSample& sample : forth.samples(j)) {
        const double parameter = end - (j + sample.t);
        const SurfacePoint other = pointAt(back, parameter).point;
        gap = std::max(gap, (position(mesh, other) - position(mesh, sample.point)).norm());
      }
    }
    if (isBridged) continue;
    worst = std::max(worst, gap / diagonal);
    EXPECT_LE(gap, 1e-9 * diagonal);
    ++compared;
  }
  EXPECT_GE(compared, 10);
  std::printf("largest change by reversal: %.1e of the bounding box\n", worst);
}

TEST(CurveLevels, OfClosedCurvesMeetAtTheirEnds) {
  SKIP_WHERE_SANITIZED();
  // A fitted field has its zero beside its point, so both ends must have the same field.
  Surface surface(meshOf(randomSphere(20000, 4)));
  const TriangleMesh& mesh = surface.mesh();
  Random dice(5);
  SCOPED_TRACE("seed 5");
  for (int i = 0; i < (longRun() ? 20 : 2); ++i) {
    Array<SurfacePoint> points;
    while (points.count() < 5) points.push_back(randomPoint(mesh, dice));
    for (const CurveShape& shape : everyShape(points.count())) {
      if (!shape.closed || !takesLevels(shape.kind)) continue;
      for (const int levels : {kAutomaticLevels, 1, 2, 3}) {
        const Curve curve(surface, optionsOf(shape, 9, levels, kFast), points);
        for (int j = 0; j < curve.segmentCount(); ++j) {
          const SurfacePoint& end = curve.samples(j).back().point;
          const SurfacePoint& start = curve.samples((j + 1) % curve.segmentCount()).front().point;
          EXPECT_LE((position(mesh, end) - position(mesh, start)).norm(),
                    1e-12 * surface.geometry().diagonal)
              << describe(shape) << ", polygon " << i << ", segment " << j << ", levels " << levels;
        }
      }
    }
  }
}

TEST(CurveLevels, AfterAnyEditsAreTheCurveTracedAnew) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const double diagonal = surface.geometry().diagonal;
  for (const uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random dice(seed);
    const CurveKind kinds[] = {CurveKind::kBSpline, CurveKind::kBezier, CurveKind::kCatmullRom};
    Array<SurfacePoint> points;
    for (int i = 0; i < 6; ++i) {
      points.push_back(nearestPoint(mesh, Vec3(-3 + 1.1 * i, 7.5 + dice.uniform(), 4)));
    }
    Curve curve(surface, optionsOf({kinds[seed % 3]}, 17, 2, kFast), points);
    for (int edit = 0; edit < 12; ++edit) {
      const int i = dice.index(curve.pointCount());
      const SurfacePoint near =
          traceStraightest(surface.geometry(), curve.point(i),
                           0.03 * diagonal * unitVector(dice.uniform(0, 2 * kPi)))
              .path.end();
      switch (dice.index(7)) {
        case 0:
          curve.insertPoint(i, near);
          break;
        case 1:
          if (curve.pointCount() > 5) curve.removePoint(i);
          break;
        case 2:
          curve.movePoint(i, near);
          break;
        case 3:
          curve.setClosed(!curve.shape().closed);
          break;
        case 4:
          curve.reverse();
          break;
        default:
          curve.dragPoint(i, near);
      }
      expectIdentical(curve, Curve(surface, curve.value()));
    }
  }
}

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

TEST(CurveLevels, ChosenAutomaticallyAre0OnASmoothSurfaceWhereTheyWouldMoveTheCurve) {
  // On the sphere far points have no level on any mesh, near ones as many as stay quick.
  const int sizes[] = {8000, 32000};
  for (const int triangles : casesOf(sizes, 1)) {
    Surface surface(meshOf(makeShape(Shape::kSphere, triangles)));
    const double edge = surface.geometry().meanEdge;
    for (const double leg : {0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 0.9}) {
      SCOPED_TRACE(std::to_string(triangles) + " triangles, legs of " + std::to_string(leg));
      const Array<SurfacePoint> points = pointsOnCircle(surface.mesh(), leg);
      const CurveOptions options = optionsOf({CurveKind::kBezier}, 65, kAutomaticLevels, kFast);
      Curve curve(surface, options, points);
      if (leg >= 0.4) {
        EXPECT_EQ(curve.levels(), 0);
      }
      EXPECT_LE(curve.deviation(), kLevelsTolerance * edge);
      Curve centers(surface, optionsOf({CurveKind::kBezier}, 65, 0, kFast), points);
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

TEST(CurveLevels, OfSegmentsAllAroundAClosedCurveReportTheirDeviation) {
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
      Curve levels(surface, optionsOf(shape, 65, 4, kExact), points);
      Curve centers(surface, optionsOf(shape, 65, 0, kExact), points);
      const double deviation = largestDistance(levels, centers);
      EXPECT_LE(deviation, levels.deviation() + 0.01 * edge);
      EXPECT_GE(deviation + 0.01 * edge, 0.4 * levels.deviation());
    }
  }
}

TEST(CurveLevels, ChosenAutomaticallyDoNotDependOnTheTrianglesOfADevelopableSurface) {
  // Levels do not move the curve on such a surface, and every point is safe.
  const FlatCylinder cylinder = flatCylinder(24, 3, 5);
  Surface surface(meshOf(cylinder.soup));
  Random random(2);
  for (int i = 0; i < 10; ++i) {
    const Array<SurfacePoint> points =
        randomControlPolygon(surface.geometry(), random, {.spacing = 0.12});
    Curve curve(surface, optionsOf({CurveKind::kBezier}, 65, kAutomaticLevels, kExact), points);
    EXPECT_LE(curve.deviation(), 1e-9);
    Curve centers(surface, optionsOf({CurveKind::kBezier}, 65, 0, kExact), points);
    EXPECT_LE(largestDistance(curve, centers), 1e-6 * surface.geometry().diagonal);
  }
}

TEST(CurveLevels, ChosenAutomaticallyNeverRelyOnWrongFields) {
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
      Curve curve(surface, optionsOf({CurveKind::kBezier}, 65, kAutomaticLevels, kFast), points);
      Curve exact(surface, optionsOf({CurveKind::kBezier}, 65, curve.levels(), kExact), points);
      EXPECT_LE(largestDistance(curve, exact), 0.02 * curve.path(0).line.length())
          << "legs of " << spacing << ", " << curve.levels() << " levels";
      zeros += static_cast<int>(curve.levels() == 0);
    }
  }
  std::printf("of %d curves on ring tubes %d have no level\n", 3 * tubes, zeros);
}

TEST(CurveLevels, ChosenAutomaticallyMakeCurvesAroundATubeSafe) {
  // The shortest path between its ends passes on the other side.
  Surface surface(meshOf(makeShape(Shape::kTorus, 20000)));
  Array<SurfacePoint> points;
  for (const double angle : {0.0, 1.4, 2.8, 4.2}) {
    const double out = 1 + 0.4 * std::cos(angle);
    points.push_back(nearestPoint(
        surface.mesh(),
        Vec3(out * std::cos(angle / 9), out * std::sin(angle / 9), 0.4 * std::sin(angle))));
  }
  const Curve curve(surface, optionsOf({CurveKind::kBezier}, 65, kAutomaticLevels, kFast), points);
  EXPECT_GT(curve.levels(), 1);
  EXPECT_TRUE(curve.bridges(0).empty());
}

Array<Vec3> positionsOf(const Curve& curve) {
  Array<Vec3> positions;
  for (const SurfacePoint& p : curve.path(0).line.points) {
    positions.push_back(position(curve.surface().mesh(), p));
  }
  return positions;
}

TEST(CurveLevels, ChosenAutomaticallyAreEnoughAroundTheRimOfAnEar) {
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
    const Curve curve(surface, optionsOf({CurveKind::kBezier}, 65, kAutomaticLevels, kFast),
                      points);
    const Curve limit(surface, optionsOf({CurveKind::kBezier}, 65, kLimitLevels, kFast), points);
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

TEST(CurveLevels, AreAtLeastTheLeastLevels) {
  Surface surface(bunnyMesh());
  Array<SurfacePoint> points;
  for (int i = 0; i < 4; ++i) {
    points.push_back(nearestPoint(surface.mesh(), Vec3(-3 + 1.1 * i, 7.5, 4)));
  }
  CurveOptions options = optionsOf({CurveKind::kBezier}, 17, kAutomaticLevels, kFast);
  const int fitting = Curve(surface, options, points).levels();
  ASSERT_LT(fitting, 4);
  for (int least = 0; least <= 4; ++least) {
    options.leastLevels = least;
    const Curve curve(surface, options, points);
    const int expected = std::max(least, fitting);
    EXPECT_EQ(curve.levels(), expected);
    expectIdentical(curve,
                    Curve(surface, optionsOf({CurveKind::kBezier}, 17, expected, kFast), points));
  }
  options.leastLevels = 9;
  EXPECT_EQ(codeOf([&] { Curve(surface, options, points); }), ErrorCode::kBadArgument);
}

TEST(CurveLevels, FollowTheGivenLegs) {
  // Around a tube there are two paths.
  const FlatCylinder tube = flatCylinder(24, 2, 5);
  Surface surface(meshOf(tube.soup));
  const TriangleMesh& mesh = surface.mesh();
  const SurfacePoint a = nearestPoint(mesh, Vec3(1, 0.05, 1));
  const SurfacePoint b = nearestPoint(mesh, Vec3(-1, 0.3, 1));
  for (const CurveKind kind : {CurveKind::kPolyline, CurveKind::kBezier}) {
    const CurveOptions options = optionsOf({kind}, 65, 2, kFast);
    Curve curve(surface, options, {a, b});
    const double shortest = lineOf(curve).path.lengths.back();
    // The long path comes from a drag around the tube.
    for (int step = 1; step <= 40; ++step) {
      const double angle = 2.84 + (2 * kPi - 2.84 + 0.3) * step / 40;
      const Vec3 place(std::cos(angle), std::sin(angle), 1);
      curve.dragPoint(1, nearestPoint(mesh, place));
    }
    EXPECT_GT(lineOf(curve).path.lengths.back(), 1.5 * shortest) << curveKindName(kind);
    // A move, unlike a drag, resets the point's legs to the shortest.
    curve.movePoint(1, b);
    EXPECT_NEAR(lineOf(curve).path.lengths.back(), shortest, 1e-9) << curveKindName(kind);
  }
}

TEST(CurveLevels, StayIfAPointTakesItsPlaceInAnotherFace) {
  Surface surface(meshOf(makeShape(Shape::kTorus, 3000)));
  const TriangleMesh& mesh = surface.mesh();
  Array<SurfacePoint> points = pointsNear(
      mesh, {{1.4, 0, 0}, {1.3, 0.35, 0.1}, {1.1, 0.7, 0.2}, {0.9, 0.9, 0.25}, {0.6, 1.2, 0.1}});
  for (int corner = 0; corner < 3; ++corner) {
    const int h = 3 * points[1].face + corner;
    ASSERT_GE(mesh.twin[h], 0);
    Array<SurfacePoint> here = points;
    here[1] = edgePoint(h, 0.5);
    const CurveOptions options = optionsOf({CurveKind::kCatmullRom}, 33, 3, kFast);
    const Curve before(surface, options, here);
    Curve after(surface, options, here);
    after.dragPoint(1, edgePoint(mesh.twin[h], 0.5));
    EXPECT_LT(largestGap(before, after), 1e-9);
  }
}

TEST(CurveLevels, FollowAPointAcrossASlit) {
  // The line x = 2 is cut up to y = 2: its vertices below have a copy for the squares on its right.
  const TriangleMesh whole = planeGrid(4, 4);
  Array<Vec3> positions = whole.positions;
  positions.push_back({2, 0, 0});
  positions.push_back({2, 1, 0});
  Array<Triangle> triangles;
  for (int f = 0; f < whole.faceCount(); ++f) {
    Triangle triangle(whole.corner(f, 0), whole.corner(f, 1), whole.corner(f, 2));
    double middle = 0;
    for (int k = 0; k < 3; ++k) middle += positions[triangle[k]].x() / 3;
    for (int k = 0; k < 3; ++k) {
      const Vec3& at = positions[triangle[k]];
      if (middle > 2 && at.x() == 2 && at.y() < 2) triangle[k] = 25 + static_cast<int>(at.y());
    }
    triangles.push_back(triangle);
  }
  Surface surface(buildMesh(positions, triangles));
  const TriangleMesh& mesh = surface.mesh();
  const Array<SurfacePoint> points{nearestPoint(mesh, {0.5, 0.6, 0}),
                                   nearestPoint(mesh, {1, 1.2, 0}), vertexPoint(mesh, 5 + 2)};
  Curve curve(surface, optionsOf({CurveKind::kBezier}, 9, 2, kExact), points);
  curve.dragPoint(2, vertexPoint(mesh, 26));
  const SurfacePath& leg = curve.legs()[1];
  EXPECT_TRUE(samePlace(mesh, leg.end(), vertexPoint(mesh, 26)));
  // Around the end of the slit.
  EXPECT_NEAR(leg.length(), std::hypot(1, 0.8) + 1, 1e-9);
}

bool hasAllCenters(const Curve& curve) {
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      if (sample.status != SampleStatus::kConverged) return false;
    }
  }
  return true;
}

TEST(CurveLevels, OfACurveThroughPointsBesideTheBoundaryAreTheSameCurve) {
  // The curve's handles may lie beyond the boundary, and legs along it lead straight back.
  Surface surface(planeGrid(8, 8));
  const Geometry& geometry = surface.geometry();
  Random random(23);
  SCOPED_TRACE("seed 23");
  int refined = 0;
  for (int i = 0; i < 200; ++i) {
    Array<SurfacePoint> points;
    for (int k = 0; k < 5; ++k) {
      const double x = random.index(3) == 0 ? random.index(9) : 0;
      points.push_back(nearestPoint(surface.mesh(), Vec3(x, random.index(9), 0)));
    }
    CurveShape shape{CurveKind::kCatmullRom};
    shape.closed = i % 2 == 0;
    shape.centripetal = i % 4 < 2;
    for (const int levels : {1, 2, kLimitLevels}) {
      const CurveOptions options = optionsOf(shape, 9, levels, kFast);
      const Curve center(surface, optionsOf(shape, 9, 0, kFast), points);
      // Beyond the boundary no centers exist.
      if (!hasAllCenters(center)) continue;
      const Curve curve(surface, options, points);
      refined += curve.levels() > 0 ? 1 : 0;
      EXPECT_LT(largestGap(curve, center), 1e-11 * geometry.diagonal) << "curve " << i;
    }
  }
  EXPECT_GT(refined, 0);
}

TEST(CurveLevels, ToTheLimitAre0BeyondTheBoundOfWork) {
  Surface surface(planeGrid(30, 30));
  Array<SurfacePoint> points;
  for (int i = 0; i < 502; ++i) {
    points.push_back({3 * i, Vec3(0.2, 0.3, 0.5)});
  }
  for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kRational}) {
    CurveShape shape{kind};
    shape.closed = kind == CurveKind::kRational;
    const Curve limit(surface, optionsOf(shape, 2, kLimitLevels, kFast), points);
    EXPECT_EQ(limit.levels(), 0);
    EXPECT_TRUE(limit.isOfCenters());
  }
}

TEST(CurveLevels, AreRefusedForOtherKindsAndMethods) {
  Surface surface(planeGrid(10, 10));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{2, 2, 0}, {4, 6, 0}, {6, 3, 0}, {8, 7, 0}});
  const auto make = [&](CurveKind kind, int levels, FieldOptions field) {
    return Curve(surface, optionsOf({kind}, 9, levels, field), points).levels();
  };
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, 9, kFast); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, -3, kFast); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, 1, kPaperExact); }), ErrorCode::kBadArgument);
  EXPECT_EQ(make(CurveKind::kBezier, kAutomaticLevels, kPaperExact), 0);
  EXPECT_EQ(make(CurveKind::kBezier, 8, kFast), 8);
  // Kinds that blend all their points at once remain centers of mass.
  EXPECT_EQ(make(CurveKind::kBarycentric, 3, kFast), 0);
  EXPECT_EQ(make(CurveKind::kPolyline, 3, kFast), 0);

  Curve curve(surface, optionsOf({CurveKind::kBezier}, 9, 2, kFast), points);
  CurveValue wrong = curve.value();
  for (const size_t count : {1u, 2u, 4u, 5u}) {
    wrong.legs.assign(count, {});
    EXPECT_EQ(codeOf([&] { curve.set(wrong); }), ErrorCode::kBadArgument) << count;
  }
  expectIdentical(curve, Curve(surface, curve.value()));
}

}  // namespace
}  // namespace karcher

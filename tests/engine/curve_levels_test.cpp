#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "cases.h"
#include "curve_support.h"
#include "curves/curve.h"
#include "curves/query/evaluate.h"
#include "curves/query/measure.h"
#include "generators/flat.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/sphere.h"
#include "intrinsic/straightest.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

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
    Curve center(surface, levelsOptions(shape, 33, 0, kExact), points);
    for (int levels = 1; levels <= 5; ++levels) {
      SCOPED_TRACE("levels " + std::to_string(levels));
      Curve curve(surface, levelsOptions(shape, 33, levels, kExact), points);
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
      Curve center(surface, levelsOptions(shape, 17, 0, kExact), six);
      for (const int levels : {1, 3, 5, kMostLevels}) {
        SCOPED_TRACE("levels " + std::to_string(levels));
        Curve curve(surface, levelsOptions(shape, 17, levels, kExact), six);
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
    CurveOptions options = levelsOptions({CurveKind::kBSpline}, 65, 3, kExact);
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
    Curve center(surface, levelsOptions({CurveKind::kBezier}, 33, 0, kExact), points);
    Curve curve(surface, levelsOptions({CurveKind::kBezier}, 33, 2, kExact), points);
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
    Curve forth(surface, levelsOptions(shape, 17, 2, kExact), points);
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
        const Curve curve(surface, levelsOptions(shape, 9, levels, kFast), points);
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
    Curve curve(surface, levelsOptions({kinds[seed % 3]}, 17, 2, kFast), points);
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

TEST(CurveLevels, AreAtLeastTheLeastLevels) {
  Surface surface(bunnyMesh());
  Array<SurfacePoint> points;
  for (int i = 0; i < 4; ++i) {
    points.push_back(nearestPoint(surface.mesh(), Vec3(-3 + 1.1 * i, 7.5, 4)));
  }
  CurveOptions options = levelsOptions({CurveKind::kBezier}, 17, kAutomaticLevels, kFast);
  const int fitting = Curve(surface, options, points).levels();
  ASSERT_LT(fitting, 4);
  for (int least = 0; least <= 4; ++least) {
    options.leastLevels = least;
    const Curve curve(surface, options, points);
    const int expected = std::max(least, fitting);
    EXPECT_EQ(curve.levels(), expected);
    expectIdentical(
        curve, Curve(surface, levelsOptions({CurveKind::kBezier}, 17, expected, kFast), points));
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
    const CurveOptions options = levelsOptions({kind}, 65, 2, kFast);
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
    const CurveOptions options = levelsOptions({CurveKind::kCatmullRom}, 33, 3, kFast);
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
  Curve curve(surface, levelsOptions({CurveKind::kBezier}, 9, 2, kExact), points);
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
      const CurveOptions options = levelsOptions(shape, 9, levels, kFast);
      const Curve center(surface, levelsOptions(shape, 9, 0, kFast), points);
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
    const Curve limit(surface, levelsOptions(shape, 2, kLimitLevels, kFast), points);
    EXPECT_EQ(limit.levels(), 0);
    EXPECT_TRUE(limit.isOfCenters());
  }
}

TEST(CurveLevels, AreRefusedForOtherKindsAndMethods) {
  Surface surface(planeGrid(10, 10));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{2, 2, 0}, {4, 6, 0}, {6, 3, 0}, {8, 7, 0}});
  const auto make = [&](CurveKind kind, int levels, FieldOptions field) {
    return Curve(surface, levelsOptions({kind}, 9, levels, field), points).levels();
  };
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, 9, kFast); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, -3, kFast); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { make(CurveKind::kBezier, 1, kPaperExact); }), ErrorCode::kBadArgument);
  EXPECT_EQ(make(CurveKind::kBezier, kAutomaticLevels, kPaperExact), 0);
  EXPECT_EQ(make(CurveKind::kBezier, 8, kFast), 8);
  // Kinds that blend all their points at once remain centers of mass.
  EXPECT_EQ(make(CurveKind::kBarycentric, 3, kFast), 0);
  EXPECT_EQ(make(CurveKind::kPolyline, 3, kFast), 0);

  Curve curve(surface, levelsOptions({CurveKind::kBezier}, 9, 2, kFast), points);
  CurveValue wrong = curve.value();
  for (const size_t count : {1u, 2u, 4u, 5u}) {
    wrong.legs.assign(count, {});
    EXPECT_EQ(codeOf([&] { curve.set(wrong); }), ErrorCode::kBadArgument) << count;
  }
  expectIdentical(curve, Curve(surface, curve.value()));
}

}  // namespace
}  // namespace karcher

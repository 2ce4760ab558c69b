#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/curve_shapes.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "mesh/mesh_import.h"
#include "rcm/mean.h"
#include "support.h"

namespace karcher {
namespace {

/// Points around a place of the bunny, near enough for every search to converge.
Array<SurfacePoint> ring(const TriangleMesh& mesh, int count, double radius) {
  Array<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const Vec2 around = radius * (1 + 0.3 * (i % 2)) * unitVector(2 * kPi * i / count);
    points.push_back(nearestPoint(mesh, Vec3(-3 + around.x(), 7.5 + around.y(), 4)));
  }
  return points;
}

/// A new curve with the shape and points of another.
Curve anew(Curve& curve) {
  CurveOptions options = curve.options();
  if (!takesWeights(options.shape.kind)) options.shape.weights.clear();
  if (!takesBetas(options.shape.kind)) options.shape.betas.clear();
  Curve result(curve.surface(), options, curve.points());
  return result;
}

void expectSame(const Curve& a, const Curve& b) {
  ASSERT_EQ(a.segmentCount(), b.segmentCount());
  for (int j = 0; j < a.segmentCount(); ++j) {
    ASSERT_EQ(a.samples(j).count(), b.samples(j).count());
    for (int i = 0; i < a.samples(j).count(); ++i) {
      EXPECT_EQ(a.samples(j)[i].status, b.samples(j)[i].status);
      EXPECT_EQ(a.samples(j)[i].point.face, b.samples(j)[i].point.face);
      EXPECT_EQ(a.samples(j)[i].point.bary, b.samples(j)[i].point.bary);
    }
    EXPECT_EQ(a.path(j).line.length(), b.path(j).line.length());
  }
}

TEST(CurveKinds, OnThePlaneAreTheAffineAverages) {
  Surface surface(importMesh(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 2000, 4)).mesh);
  const Array<Vec3> places{{0.3, 0.3, 0},  {0.45, 0.68, 0}, {0.62, 0.41, 0},
                           {0.7, 0.65, 0}, {0.52, 0.3, 0},  {0.38, 0.52, 0}};
  Array<SurfacePoint> points;
  for (const Vec3& place : places) points.push_back(nearestPoint(surface.mesh(), place));
  for (const CurveShape& shape : everyShape(6)) {
    SCOPED_TRACE(describe(shape));
    Curve curve(surface, ofLevelZero(shape, 17, kExact), points);
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const CurveSample& sample : curve.samples(j)) {
        const Array<double> weights = curve.weights(j, sample.t);
        Vec3 expected = Vec3::Zero();
        for (int k = 0; k < weights.count(); ++k) {
          expected += weights[k] * places[curve.pointsOf(j)[k]];
        }
        EXPECT_EQ(sample.status, SampleStatus::kConverged);
        // quad2 on the plane: 1e-10 of the bounding box.
        EXPECT_LT((position(surface.mesh(), sample.point) - expected).norm(), 1e-10);
      }
    }
  }
}

TEST(CurveKinds, SegmentsMeetOnAnyMesh) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const Array<SurfacePoint> points = ring(mesh, 7, 1.2);
  double worst = 0;
  for (const FieldOptions& field : {kFast, kExact}) {
    for (const CurveShape& shape : everyShape(7)) {
      SCOPED_TRACE(describe(shape));
      Curve curve(surface, ofLevelZero(shape, 24, field), points);
      const int count = curve.segmentCount();
      for (int j = shape.closed ? 0 : 1; j < count; ++j) {
        const CurveSample& before = curve.samples((j + count - 1) % count).back();
        const CurveSample& after = curve.samples(j).front();
        EXPECT_EQ(before.status, SampleStatus::kConverged);
        EXPECT_EQ(after.status, SampleStatus::kConverged);
        const double gap = (position(mesh, before.point) - position(mesh, after.point)).norm();
        EXPECT_LE(gap, 1e-9 * surface.geometry().diagonal);
        worst = std::max(worst, gap / surface.geometry().diagonal);
      }
    }
  }
  std::printf("largest gap at a join: %.1e of the bounding box\n", worst);
}

TEST(CurveKinds, CurvesAndCentersOfMassShareFields) {
  Surface surface(bunnyMesh());
  const Array<SurfacePoint> points = ring(surface.mesh(), 6, 1);
  const auto sets = std::make_shared<FieldSets>(surface);
  CurveValue value;
  value.options.levels = 0;
  value.options.field = kFast;
  value.points = points;
  Curve first(sets, value);
  EXPECT_EQ(first.fieldsMade(), 6);
  Curve second(sets, value);
  EXPECT_EQ(second.fieldsMade(), 0);
  MeanOptions options;
  options.field = kFast;
  options.normalize = true;
  std::shared_ptr<FieldSet> kept;
  const Array<double> equal(points.size(), 1.0);
  const Mean mean = centerOfMass(*sets, points, equal, options, kept);
  EXPECT_EQ(kept, sets->of(kFast));
  EXPECT_EQ(kept->made(), 6);
  const Mean alone = centerOfMass(surface, points, equal, options);
  EXPECT_EQ(mean.point.bary, alone.point.bary);
  EXPECT_EQ(mean.energy, alone.energy);
  // When one of them moves points, the others stay.
  first.movePoint(0, vertexPoint(surface.mesh(), 7));
  EXPECT_EQ(first.fieldsMade(), 7);
  expectSame(first, anew(first));
  value.options.samples = 33;
  second.set(value);
  EXPECT_EQ(second.fieldsMade(), 0);
  expectSame(second, anew(second));
  // Other options are another set.
  value.options.field = kExact;
  second.set(value);
  EXPECT_EQ(second.fieldsMade(), 6);
  EXPECT_NE(sets->of(kExact), sets->of(kFast));
}

TEST(CurveKinds, WeightsAndBetasComputeNoField) {
  Surface surface(bunnyMesh());
  for (const CurveKind kind :
       {CurveKind::kBSpline, CurveKind::kRational, CurveKind::kBarycentric}) {
    SCOPED_TRACE(curveKindName(kind));
    Curve curve(surface, ofLevelZero({kind}, 16, kFast), ring(surface.mesh(), 6, 1));
    EXPECT_EQ(curve.fieldsMade(), 6);
    for (const double value : {0.25, 4.0}) {
      if (takesBetas(kind)) curve.setBeta(2, value);
      if (takesWeights(kind)) curve.setWeight(2, value);
      expectSame(curve, anew(curve));
    }
    EXPECT_EQ(curve.fieldsMade(), 6);
    // Two points at one place share its field.
    curve.movePoint(2, curve.point(3));
    EXPECT_EQ(curve.fieldsMade(), 6);
    curve.movePoint(2, vertexPoint(surface.mesh(), 7));
    EXPECT_EQ(curve.fieldsMade(), 7);
  }
}

TEST(CurveKinds, AfterAnyEditsAreTheCurveTracedAnew) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  for (const uint64_t seed : {1u, 2u, 3u, 4u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto somewhere = [&] {
      const double x = random.uniform(-4, -2);
      return nearestPoint(mesh, Vec3(x, random.uniform(6.5, 8.5), 4));
    };
    CurveOptions options = ofLevelZero({CurveKind::kBSpline}, 12, seed % 2 == 0 ? kFast : kExact);
    if (seed == 4) options.tolerance = 1e-3;
    Curve curve(surface, options, ring(mesh, 6, 1));
    for (int edit = 0; edit < 60; ++edit) {
      const int i = random.index(curve.pointCount());
      try {
        switch (random.index(10)) {
          case 0:
            curve.insertPoint(i, somewhere());
            break;
          case 1:
            curve.removePoint(i);
            break;
          case 2:
            curve.setKind(kCurveKinds[random.index(6)]);
            break;
          case 3:
            curve.setClosed(!curve.shape().closed);
            break;
          case 4:
            curve.reverse();
            break;
          case 5:
            curve.movePointInOrder(i, random.index(curve.pointCount()));
            break;
          case 6:
            if (takesWeights(curve.shape().kind)) curve.setWeight(i, random.uniform(0.3, 2.3));
            if (takesBetas(curve.shape().kind)) curve.setBeta(i, random.uniform(0.3, 2.3));
            break;
          default:
            curve.movePoint(i, somewhere());
        }
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kTooFewPoints) << error.what();
      }
      if (edit % 3 == 0) continue;
      expectSame(curve, anew(curve));
    }
  }
}

TEST(CurveKinds, ACustomBasisIsUsedUnchanged) {
  Surface surface(planeGrid(12, 12));
  CurveShape shape{CurveKind::kOwn};
  // The basis is a quadratic through the three points, at 0, 0.5 and 1.
  shape.basis = std::make_shared<OwnBasis>([](int, double t) {
    return Array<double>{(2 * t - 1) * (t - 1), 4 * t * (1 - t), t * (2 * t - 1)};
  });
  const Array<Vec3> places{{3, 4, 0}, {6, 8, 0}, {9, 5, 0}};
  Array<SurfacePoint> points;
  for (const Vec3& place : places) points.push_back(nearestPoint(surface.mesh(), place));
  Curve curve(surface, ofLevelZero(shape, 5, kExact), points);
  ASSERT_EQ(curve.segmentCount(), 1);
  EXPECT_LT((position(surface.mesh(), curve.samples(0)[2].point) - places[1]).norm(), 1e-9);
  // The basis has no fourth weight, so the curve refuses and stays.
  EXPECT_EQ(codeOf([&] { curve.insertPoint(1, points[0]); }), ErrorCode::kBadWeights);
  EXPECT_EQ(curve.pointCount(), 3);
}

TEST(CurveKinds, ACustomBasisThatIsNotSymmetricIsMirroredWhereTheCurveIsReversed) {
  Surface surface(planeGrid(12, 12));
  CurveShape shape{CurveKind::kOwn};
  // The basis is a quadratic through the three points, at 0, 0.2 and 1.
  shape.basis = std::make_shared<OwnBasis>([](int, double t) {
    return Array<double>{(1 - t / 0.2) * (1 - t), t * (1 - t) / 0.16, t * (t - 0.2) / 0.8};
  });
  Array<SurfacePoint> points;
  for (const Vec3& place : {Vec3(3, 4, 0), Vec3(6, 8, 0), Vec3(9, 5, 0)}) {
    points.push_back(nearestPoint(surface.mesh(), place));
  }
  Curve curve(surface, ofLevelZero(shape, 9, kExact), points);
  const Array<CurveSample> before = curve.samples(0);
  const auto farthest = [&](bool isReversed) {
    const Array<CurveSample>& after = curve.samples(0);
    double most = 0;
    for (int i = 0; i < after.count(); ++i) {
      const CurveSample& same = before[isReversed ? before.count() - 1 - i : i];
      const Vec3 way =
          position(surface.mesh(), after[i].point) - position(surface.mesh(), same.point);
      most = std::max(most, way.norm());
    }
    return most;
  };
  curve.reverse();
  EXPECT_LT(farthest(true), 1e-9);
  curve.setKind(CurveKind::kBezier);
  curve.reverse();
  curve.setKind(CurveKind::kOwn);
  EXPECT_EQ(farthest(false), 0);
}

TEST(CurveKinds, AdaptiveSamplesKeepTheirTolerance) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const double diagonal = surface.geometry().diagonal;
  const Array<SurfacePoint> points = ring(mesh, 7, 1.2);
  for (const CurveShape& shape : everyShape(7)) {
    SCOPED_TRACE(describe(shape));
    if (shape.kind == CurveKind::kPolyline) continue;
    Curve dense(surface, ofLevelZero(shape, 600, kFast), points);
    int last = 0;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      Curve curve(surface, ofLevelZero(shape, 2, kFast, tolerance), points);
      int count = 0;
      double worst = 0;
      for (int j = 0; j < curve.segmentCount(); ++j) {
        count += curve.samples(j).count();
        const Array<SurfacePoint>& path = curve.path(j).line.points;
        for (const CurveSample& sample : dense.samples(j)) {
          const Vec3 p = position(mesh, sample.point);
          double nearest = kInfinity;
          for (int k = 1; k < path.count(); ++k) {
            const Vec3 a = position(mesh, path[k - 1]);
            const Vec3 along = position(mesh, path[k]) - a;
            const double s =
                std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
            nearest = std::min(nearest, (a + s * along - p).norm());
          }
          worst = std::max(worst, nearest);
        }
      }
      EXPECT_LE(worst, tolerance * diagonal);
      EXPECT_GE(count, last);
      last = count;
    }
  }
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <string>

#include "curve_support.h"
#include "curves/query/measure.h"
#include "generators/curve_shapes.h"
#include "generators/plane.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

Array<CurveShape> plainShapes() {
  Array<CurveShape> all;
  for (const bool closed : {false, true}) {
    for (const CurveKind kind : kCurveKinds) {
      if (kind != CurveKind::kOwn) all.push_back({kind, closed});
    }
  }
  return all;
}

TriangleMesh randomPlane() {
  return importMesh(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 2000, 4)).mesh;
}

/// The curve of the plane.
Vec3 planePoint(const Curve& curve, const SegmentParameter& at) {
  const Array<double> weights = curve.weights(at.segment, at.t);
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < weights.count(); ++k) {
    sum += weights[k] * kPlaces[curve.pointsOf(at.segment)[k]];
  }
  return sum;
}

TEST(CurveMeasure, PointsAndTangentsOnThePlaneAreThoseOfThePlane) {
  Surface surface(randomPlane());
  const TriangleMesh& mesh = surface.mesh();
  for (const CurveShape& shape : plainShapes()) {
    SCOPED_TRACE(std::string(curveKindName(shape.kind)) + (shape.closed ? " closed" : ""));
    Curve curve(surface, ofLevelZero(shape, 9, kExact), pointsNear(mesh, kPlaces));
    for (const double part : {0.0, 0.123, 0.5, 0.77, 0.999, 1.0}) {
      const double parameter = part * curve.segmentCount();
      const SegmentParameter at = segmentParameter(curve, parameter);
      const CurvePoint point = pointAt(curve, parameter);
      EXPECT_EQ(point.status, SampleStatus::kConverged);
      EXPECT_LT((position(mesh, point.point) - planePoint(curve, at)).norm(), 1e-10);
      const CurveTangent tangent = tangentAt(curve, parameter);
      constexpr double kStep = 1e-4;
      const double middle = std::clamp(at.t, kStep, 1 - kStep);
      const Vec3 before = planePoint(curve, {at.segment, middle - kStep});
      const Vec3 after = planePoint(curve, {at.segment, middle + kStep});
      const Vec3 here = planePoint(curve, {at.segment, middle});
      const Vec3 expected = (after - before) / (2 * kStep) +
                            (at.t - middle) / (kStep * kStep) * (after - 2 * here + before);
      // The differences have an error of fourth order in the step.
      EXPECT_LT((tangent.inSpace - expected).norm(), 1e-5 * (1 + expected.norm()));
      EXPECT_NEAR(tangent.inFace.norm(), tangent.inSpace.norm(), 1e-12);
    }
  }
}

TEST(CurveMeasure, ParametersWrapOnClosedCurvesOnly) {
  Surface surface(planeGrid(12, 12));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{3, 3, 0}, {5, 8, 0}, {8, 7, 0}, {9, 4, 0}, {6, 3, 0}});
  Curve open(surface, ofLevelZero({CurveKind::kBSpline}, 9, kFast), points);
  EXPECT_EQ(segmentParameter(open, 2).segment, 1);
  EXPECT_EQ(segmentParameter(open, 2).t, 1);
  for (const double outside : {-0.01, 2.01, kInfinity, std::nan("")}) {
    EXPECT_EQ(codeOf([&] { pointAt(open, outside); }), ErrorCode::kBadArgument);
  }
  Curve closed(surface, ofLevelZero({CurveKind::kBSpline, true}, 9, kFast), points);
  const Vec3 start = position(surface.mesh(), pointAt(closed, 0.25).point);
  for (const double round : {5.25, -4.75, 50.25}) {
    EXPECT_LT((position(surface.mesh(), pointAt(closed, round).point) - start).norm(), 1e-12);
  }
}

TEST(CurveMeasure, DividesCurvesEvenly) {
  Surface surface(bunnyMesh());
  Array<Vec3> places;
  for (int i = 0; i < 6; ++i) {
    const Vec2 around = unitVector(2 * kPi * i / 6);
    places.emplace_back(-3 + around.x(), 7.5 + around.y(), 4);
  }
  for (const CurveShape& shape : plainShapes()) {
    SCOPED_TRACE(std::string(curveKindName(shape.kind)) + (shape.closed ? " closed" : ""));
    Curve curve(surface, ofLevelZero(shape, 2, kFast, 1e-4), pointsNear(surface.mesh(), places));
    const CurveLine line = lineOf(curve);
    double length = 0;
    for (int j = 0; j < curve.segmentCount(); ++j) length += curve.path(j).line.length();
    EXPECT_NEAR(line.path.lengths.back(), length, 1e-9);
    EXPECT_NEAR(lengthAt(curve, line, 0.999999 * curve.segmentCount()), length, 1e-3 * length);
    const int count = 20;
    const Array<CurvePoint> points = equallySpaced(curve, line, count);
    const double part = length / (shape.closed ? count : count - 1);
    for (int i = 0; i < count; ++i) {
      EXPECT_NEAR(lengthAt(curve, line, points[i].parameter), i * part, 1e-9 * length);
      const CurvePoint again =
          pointAtLength(curve, line, i == count - 1 ? i * part - 1e-9 : i * part);
      EXPECT_LT((position(surface.mesh(), again.point) - position(surface.mesh(), points[i].point))
                    .norm(),
                1e-8);
      // A point on the line lies within the tolerance of the curve.
      const CurvePoint onCurve = pointAt(curve, points[i].parameter);
      EXPECT_LT(
          (position(surface.mesh(), onCurve.point) - position(surface.mesh(), points[i].point))
              .norm(),
          2e-3 * surface.geometry().diagonal);
    }
    EXPECT_EQ(codeOf([&] { equallySpaced(curve, line, 1); }), ErrorCode::kBadArgument);
    if (shape.closed) continue;
    EXPECT_EQ(codeOf([&] { pointAtLength(curve, line, -1); }), ErrorCode::kBadArgument);
    EXPECT_EQ(codeOf([&] { pointAtLength(curve, line, 1.01 * length); }), ErrorCode::kBadArgument);
  }
}

TEST(CurveMeasure, FindsTheNearestPoint) {
  Surface surface(randomPlane());
  const TriangleMesh& mesh = surface.mesh();
  for (const CurveShape& shape : plainShapes()) {
    SCOPED_TRACE(std::string(curveKindName(shape.kind)) + (shape.closed ? " closed" : ""));
    Curve curve(surface, ofLevelZero(shape, 40, kExact), pointsNear(mesh, kPlaces));
    const CurveLine line = lineOf(curve);
    for (const double part : {0.0, 0.21, 0.5, 0.83, 1.0}) {
      const CurvePoint point = pointAt(curve, part * curve.segmentCount());
      const NearestOnCurve nearest = nearestOnCurve(curve, line, position(mesh, point.point));
      // On a curve that crosses itself another parameter may be as near.
      EXPECT_LT(nearest.distance, 1e-8);
    }
    // No sample is nearer to a place beside the curve.
    const Vec3 place(0.55, 0.5, 0.1);
    const NearestOnCurve nearest = nearestOnCurve(curve, line, place);
    for (int i = 0; i <= 2000; ++i) {
      const CurvePoint other = pointAt(curve, i * curve.segmentCount() / 2000.0);
      EXPECT_GT((position(mesh, other.point) - place).norm(), nearest.distance - 1e-6);
    }
  }
}

/// The largest jumps of a curve's direction, in radians.
struct Jumps {
  double tangent = 0;    ///< the jump between the two sides of a knot, by the derivatives
  double knotSteps = 0;  // the same by difference quotients, extrapolated to the knot
  double edges = 0;      ///< the largest turn within 5e-4 of t anywhere: at edges of the mesh
};

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Jumps jumpsOf(Curve& curve) {
  const TriangleMesh& mesh = curve.surface().mesh();
  const auto place = [&](int j, double t) { return position(mesh, pointAt(curve, {j, t}).point); };
  Jumps jumps;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    const int onward = (j + 1) % curve.segmentCount();
    const CurveTangent end = tangentAt(curve, {j, 1});
    const CurveTangent start = tangentAt(curve, {onward, 0});
    jumps.tangent = std::max(jumps.tangent, angleBetween(end.inSpace, start.inSpace));
    constexpr double kStep = 0.02;
    const Vec3 knot = place(onward, 0);
    const Vec3 arriving = 3 * knot - 4 * place(j, 1 - kStep) + place(j, 1 - 2 * kStep);
    const Vec3 leaving = -3 * knot + 4 * place(onward, kStep) - place(onward, 2 * kStep);
    jumps.knotSteps = std::max(jumps.knotSteps, angleBetween(arriving, leaving));
    CurveTangent last = tangentAt(curve, {j, 0});
    for (int i = 1; i <= 2000; ++i) {
      const CurveTangent next = tangentAt(curve, {j, i / 2000.0});
      // Directions are projected, so that the fold of the surface at the edge does not count.
      const Vec3 normal = (place(j, (i - 0.5) / 2000)).normalized();
      const Vec3 a = last.inSpace - last.inSpace.dot(normal) * normal;
      const Vec3 b = next.inSpace - next.inSpace.dot(normal) * normal;
      jumps.edges = std::max(jumps.edges, angleBetween(a, b));
      last = next;
    }
  }
  return jumps;
}

TEST(CurveMeasure, TangentsAreContinuousUpToTheMesh) {
  SKIP_WHERE_SANITIZED();
  const Array<int> frequencies = longRun() ? Array<int>{10, 20, 40, 80} : Array<int>{10, 20, 40};
  for (const CurveKind kind : {CurveKind::kBSpline, CurveKind::kCatmullRom}) {
    double coarse = 0;
    for (const int frequency : frequencies) {
      Surface surface(importMesh(icosphere(frequency)).mesh);
      Array<SurfacePoint> points;
      for (int i = 0; i < 6; ++i) {
        const Vec2 around = (i % 2 == 0 ? 0.5 : 0.35) * unitVector(2 * kPi * i / 6 + 0.1);
        points.push_back(
            nearestPoint(surface.mesh(), Vec3(around.x(), around.y(), 0.8).normalized()));
      }
      Curve curve(surface, ofLevelZero({kind, true}, 64, kExact), points);
      const Jumps jumps = jumpsOf(curve);
      std::printf(
          "%-10s %7d triangles: tangent's jump at knots %.1e by derivatives, %.1e by steps "
          "of 0.02; largest turn in 5e-4 of t %.1e\n",
          curveKindName(kind), surface.mesh().faceCount(), jumps.tangent, jumps.knotSteps,
          jumps.edges);
      // Derivatives of weights by difference quotients are accurate to 1e-10 of their size.
      EXPECT_LT(jumps.tangent, 1e-7);
      if (frequency == frequencies.front()) coarse = jumps.knotSteps;
      if (frequency == frequencies.back()) {
        EXPECT_LT(jumps.knotSteps, coarse);
      }
    }
  }
}

}  // namespace
}  // namespace karcher

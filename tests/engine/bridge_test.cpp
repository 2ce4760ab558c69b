#include "curves/trace/bridge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "curves/query/evaluate.h"
#include "curves/query/measure.h"
#include "curves/spec/bases.h"
#include "generators/curve_shapes.h"
#include "generators/random_points.h"
#include "intrinsic/straightest.h"
#include "intrinsic/strip_path.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// Checks that bridges are where the curve has them, that their lines are connected, and that
/// bridged samples lie on them.
void expectWhole(const Curve& curve, const Surface& surface) {
  const TriangleMesh& mesh = surface.mesh();
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const Bridge& bridge : curve.bridges(j)) {
      EXPECT_LT(bridge.t0, bridge.t1);
      EXPECT_EQ(bridge.line.t.front(), bridge.t0);
      EXPECT_EQ(bridge.line.t.back(), bridge.t1);
      EXPECT_TRUE(std::is_sorted(bridge.line.t.begin(), bridge.line.t.end()));
      for (int i = 1; i < bridge.line.path.points.count(); ++i) {
        EXPECT_TRUE(
            haveCommonFace(mesh, bridge.line.path.points[i - 1], bridge.line.path.points[i]));
      }
    }
    const Array<CurveSample>& samples = curve.samples(j);
    for (const CurveSample& sample : samples) {
      const Bridge* bridge = bridgeOver(curve.bridges(j), sample.t);
      if (sample.status == SampleStatus::kBridged) {
        ASSERT_NE(bridge, nullptr);
      } else {
        EXPECT_EQ(sample.status, SampleStatus::kConverged);
      }
      if (bridge == nullptr) continue;
      const Vec3 onBridge = position(mesh, pointAt(mesh, *bridge, sample.t));
      EXPECT_LT((position(mesh, sample.point) - onBridge).norm(),
                1e-12 * surface.geometry().diagonal);
    }
    const JoinedPath& path = curve.path(j);
    for (int i = 1; i < path.line.points.count(); ++i) {
      EXPECT_TRUE(haveCommonFace(mesh, path.line.points[i - 1], path.line.points[i]));
    }
    if (j == 0) continue;
    const Vec3 before = position(mesh, curve.samples(j - 1).back().point);
    const Vec3 after = position(mesh, samples.front().point);
    EXPECT_LT((before - after).norm(), 1e-9 * surface.geometry().diagonal);
  }
}

TEST(Bridge, OnThePlaneTheSchemeIsTheBezierCurve) {
  // The last polygons of de Casteljau's subdivision, cut in 64, lie within 1/64^2 of the second
  // differences of the first one; on a plane every geodesic is a straight line.
  const TriangleMesh mesh = planeGrid(20, 14);
  const Geometry geometry = buildGeometry(mesh);
  const Array<Vec3> corners{{3.2, 3.1, 0}, {6.7, 9.3, 0}, {10.4, 4.6, 0}, {14.1, 9.8, 0}};
  Bridge bridge;
  SubdivisionWorkspace workspace;
  appendBezier(geometry, pointsNear(mesh, corners), 0, 1, workspace, bridge.line);
  for (int i = 0; i <= 50; ++i) {
    const double t = i / 50.0;
    const Array<double> weights = bernsteinBasis(3, t);
    Vec3 expected = Vec3::Zero();
    for (int k = 0; k < 4; ++k) expected += weights[k] * corners[k];
    EXPECT_LT((position(mesh, pointAt(mesh, bridge, t)) - expected).norm(), 20.0 / (64 * 64));
  }
}

TEST(Bridge, RepeatedAveragesOnThePlaneAreAverages) {
  const TriangleMesh mesh = planeGrid(20, 14);
  const Geometry geometry = buildGeometry(mesh);
  const Array<Vec3> corners{{3.2, 3.1, 0}, {6.7, 9.3, 0}, {10.4, 4.6, 0}, {14.1, 9.8, 0}};
  SubdivisionWorkspace workspace;
  for (const Array<double>& weights :
       {Array<double>{1.0 / 6, 4.0 / 6, 1.0 / 6, 0}, Array<double>{0.1, 0.2, 0.3, 0.4},
        Array<double>{-0.1, 0.7, 0.6, -0.2}, Array<double>{0, 1, 0, 0}}) {
    Vec3 expected = Vec3::Zero();
    for (int k = 0; k < 4; ++k) expected += weights[k] * corners[k];
    const SurfacePoint found =
        repeatedAverage(geometry, pointsNear(mesh, corners), weights, workspace);
    EXPECT_LT((position(mesh, found) - expected).norm(), 1e-12);
  }
}

TEST(Bridge, IsAbsentBetweenNearPoints) {
  Surface surface(importMesh(makeShape(Shape::kTorus, 3000)).mesh);
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(),
                 {{1.4, 0, 0}, {1.35, 0.2, 0.1}, {1.3, 0.35, 0.1}, {1.2, 0.5, 0}, {1, 0.7, 0}});
  Curve curve(surface, ofLevelZero({CurveKind::kBSpline}, 40, kFast), points);
  for (int j = 0; j < curve.segmentCount(); ++j) EXPECT_TRUE(curve.bridges(j).empty());
  expectWhole(curve, surface);
}

TEST(Bridge, HasTheSameStatusAtALengthAsAtAParameter) {
  Surface surface(importMesh(icosphere(12)).mesh);
  Array<Vec3> corners;
  for (int i = 0; i < 7; ++i) {
    const double angle = 1.9 * i;
    corners.emplace_back(std::cos(angle), std::sin(angle), 0.2 * (i % 3) - 0.2);
  }
  int tested = 0;
  for (const CurveKind kind : {CurveKind::kBSpline, CurveKind::kBezier}) {
    Curve curve(surface, ofLevelZero({kind}, 16, kFast), pointsNear(surface.mesh(), corners));
    const CurveLine line = lineOf(curve);
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const Bridge& bridge : curve.bridges(j)) {
        for (int k = 1; k < 64; ++k) {
          const double t = bridge.t0 + (bridge.t1 - bridge.t0) * k / 64;
          const double length = lengthAt(curve, line, j + t);
          // Bridges may end with a part without length.
          if (length == lengthAt(curve, line, j + bridge.t1)) continue;
          ++tested;
          EXPECT_EQ(pointAtLength(curve, line, length).status, pointAt(curve, j + t).status)
              << "t = " << t << " between " << bridge.t0 << " and " << bridge.t1;
        }
      }
    }
  }
  EXPECT_GT(tested, 0);
}

TEST(Bridge, KeepsTheCurveContinuousAroundTheSphere) {
  // Control points all round the equator: no convex ball holds them.
  Surface surface(importMesh(icosphere(12)).mesh);
  Array<Vec3> corners;
  for (int i = 0; i < 7; ++i) {
    const double angle = 1.9 * i;
    corners.emplace_back(std::cos(angle), std::sin(angle), 0.2 * (i % 3) - 0.2);
  }
  int bridges = 0;
  for (const CurveKind kind : {CurveKind::kBSpline, CurveKind::kBezier}) {
    Curve curve(surface, ofLevelZero({kind}, 64, kFast), pointsNear(surface.mesh(), corners));
    for (int j = 0; j < curve.segmentCount(); ++j) bridges += curve.bridges(j).count();
    expectWhole(curve, surface);
  }
  EXPECT_GT(bridges, 0);
}

TEST(Bridge, OverAnInterpolatedPointPassesIt) {
  SKIP_WHERE_SANITIZED();
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const uint64_t seed = 8;
  Random random(seed);
  int passed = 0;
  const int curves = longRun() ? 24 : 10;
  for (int i = 0; i < curves; ++i) {
    CurveShape shape{CurveKind::kBarycentric, i % 2 == 1};
    Array<SurfacePoint> points;
    for (int k = 0; k < 5; ++k) points.push_back(randomPoint(mesh, random));
    for (int k = 0; k < 5; ++k) shape.betas.push_back(k % 2 == 0 ? 1 : 16);
    for (const double tolerance : {0.0, 1e-3}) {
      Curve curve(surface, ofLevelZero(shape, 64, kFast, tolerance), points);
      expectWhole(curve, surface);
      const int nodes = shape.closed ? 5 : 4;
      for (int k = 0; k < 5; ++k) {
        const double t = static_cast<double>(k) / nodes;
        const Bridge* bridge = bridgeOver(curve.bridges(0), t);
        if (bridge == nullptr) continue;
        ++passed;
        const Vec3 onBridge = position(mesh, pointAt(mesh, *bridge, t));
        // A sample at the start or end of a bridge is a center of mass, up to the accuracy of
        // fields.
        const bool isEnd = t == bridge->t0 || t == bridge->t1;
        EXPECT_LT((onBridge - position(mesh, points[k])).norm(),
                  isEnd ? 0.05 * surface.geometry().meanEdge : 1e-9)
            << "seed " << seed << ", curve " << i << ", point " << k << ", t " << t;
      }
    }
  }
  EXPECT_GT(passed, 20 * curves / 24);
}

TEST(Bridge, EveryGapIsMarked) {
  const uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Surface surface(importMesh(makeShape(Shape::kGenus3, 3000)).mesh);
  const TriangleMesh& mesh = surface.mesh();
  const Geometry& geometry = surface.geometry();
  Random random(seed);
  constexpr int kLooks = 500;
  for (int polygon = 0; polygon < (longRun() ? 200 : 12); ++polygon) {
    Array<SurfacePoint> points{randomPoint(mesh, random)};
    CurveShape shape{CurveKind::kRational, true};
    while (points.count() < 5) {
      const double length = random.uniform(0.05, 0.3) * geometry.diagonal;
      const Vec2 step = length * unitVector(random.uniform(0, 2 * kPi));
      points.push_back(traceStraightest(geometry, points.back(), step).path.end());
    }
    for (int i = 0; i < points.count(); ++i) {
      shape.weights.push_back(std::exp(random.uniform(-1.6, 3.2)));
    }
    Curve curve(surface, ofLevelZero(shape, 3, kFast), points);
    const auto at = [&](double t) { return pointAt(curve, SegmentParameter{0, t}); };
    const auto converged = [](const CurvePoint& p) { return p.status == SampleStatus::kConverged; };
    const auto gap = [&](const CurvePoint& a, const CurvePoint& b) {
      return (position(mesh, a.point) - position(mesh, b.point)).norm();
    };
    for (int i = 0; i < kLooks; ++i) {
      double t0 = static_cast<double>(i) / kLooks;
      double t1 = static_cast<double>(i + 1) / kLooks;
      CurvePoint from = at(t0);
      CurvePoint to = at(t1);
      // The loop bisects towards the larger half; a step that stays long is a gap.
      while (converged(from) && converged(to) && t1 - t0 > 1e-10) {
        const double t = (t0 + t1) / 2;
        const CurvePoint middle = at(t);
        if (!converged(middle) || gap(from, middle) > gap(middle, to)) {
          t1 = t;
          to = middle;
        } else {
          t0 = t;
          from = middle;
        }
      }
      if (!converged(from) || !converged(to)) continue;
      EXPECT_LE(gap(from, to), 1.1 * kLongestStep * geometry.meanEdge)
          << "polygon " << polygon << ", t " << t0;
    }
  }
}

TEST(Bridge, AroundACornerOfTheBoundaryIsMarked) {
  // The center of mass of points in both arms leaves the surface at the inner corner.
  Surface surface(gridWithCorner());
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{2.1, 11.3, 0}, {3.6, 8.2, 0}, {8.2, 3.7, 0}, {11.2, 2.2, 0}});
  Curve curve(surface, ofLevelZero({CurveKind::kBezier}, 64, kFast), points);
  ASSERT_FALSE(curve.bridges(0).empty());
  EXPECT_EQ(curve.bridges(0)[0].reason, SampleStatus::kBoundary);
  expectWhole(curve, surface);
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <string>

#include "curve_support.h"
#include "curves/query/evaluate.h"
#include "curves/refine/refine.h"
#include "curves/spec/knots.h"
#include "generators/curve_shapes.h"
#include "generators/plane.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "support.h"

namespace karcher {
namespace {

/// Tolerances: quad2 on the plane, and averages along exact shortest paths.
constexpr double kPlane = 1e-9;

class CurveRefine : public testing::Test {
 protected:
  Surface surface{importMesh(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 600, 4)).mesh};

  Array<SurfacePoint> points(int count = 6) const {
    Array<SurfacePoint> result;
    for (int i = 0; i < count; ++i) {
      result.push_back(nearestPoint(surface.mesh(), kPlaces[i]));
    }
    return result;
  }

  Curve curveOf(const CurveShape& shape, const Array<SurfacePoint>& where) {
    Curve curve(surface, ofLevelZero(shape, 5, kExact), where);
    return curve;
  }

  Vec3 at(Curve& curve, double parameter) const {
    return position(surface.mesh(), pointAt(curve, parameter).point);
  }

  /// Compares the points at the same part of a span between knots or of the single segment.
  void expectPart(Curve& whole, double from, double to, Curve& part) const {
    for (int i = 0; i <= 12; ++i) {
      const double s = i / 12.0;
      EXPECT_LT((at(whole, from + s * (to - from)) - at(part, s * part.segmentCount())).norm(),
                kPlane);
    }
  }
};

/// The parameter of a point after the insertion of a knot.
double afterCut(const SegmentParameter& at, const SegmentParameter& cut) {
  if (cut.t == 0 || cut.t == 1 || at.segment < cut.segment) return at.segment + at.t;
  if (at.segment > cut.segment) return at.segment + 1 + at.t;
  return at.t < cut.t ? at.segment + at.t / cut.t : at.segment + 1 + (at.t - cut.t) / (1 - cut.t);
}

Array<CurveShape> bsplines() {
  Array<CurveShape> all;
  for (const bool closed : {false, true}) {
    for (int degree = 1; degree <= 5; ++degree) {
      all.push_back({CurveKind::kBSpline, closed, degree});
      all.back().weights = {1, 2, 0.5, 1, 3, 1};
    }
    all.push_back({CurveKind::kBSpline, closed});
  }
  all.push_back({CurveKind::kBSpline, false, 3, KnotRule::kClamped});
  all.push_back({CurveKind::kBSpline, false, 3, KnotRule::kOwn, {0, 0, 0, 0, 1, 1, 3, 3, 3, 4}});
  all.push_back({CurveKind::kBSpline, true, 2, KnotRule::kOwn, {0, 1, 1.5, 1.5, 4, 5, 6}});
  return all;
}

TEST_F(CurveRefine, InsertingAKnotLeavesABSplineAsItIs) {
  for (const CurveShape& shape : bsplines()) {
    Curve curve = curveOf(shape, points());
    for (const double part : {0.0, 0.13, 0.5, 0.8}) {
      SCOPED_TRACE(describe(shape) + " at " + std::to_string(part));
      const double parameter = part * curve.segmentCount();
      RefinedCurve refined;
      try {
        refined = withPointOnCurve(curve, parameter);
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("repeated"), std::string::npos);
        continue;
      }
      ASSERT_EQ(refined.curve.points.count(), 7);
      EXPECT_GE(refined.point, 0);
      EXPECT_LT(refined.point, 7);
      Curve more = curveOf(refined.curve.shape, refined.curve.points);
      const SegmentParameter cut = segmentParameter(curve, parameter);
      const int added = cut.t > 0 && cut.t < 1 ? 1 : 0;
      ASSERT_EQ(more.segmentCount(), curve.segmentCount() + added);
      for (int j = 0; j < curve.segmentCount(); ++j) {
        for (const double t : {0.0, 0.25, 0.6, 1.0}) {
          EXPECT_LT((at(curve, j + t) - at(more, afterCut({j, t}, cut))).norm(), kPlane)
              << j << " + " << t;
        }
      }
    }
  }
}

TEST_F(CurveRefine, AClosedBSplineOfFewPointsTakesKnotsToo) {
  // The curve has fewer points than its degree: the knot's new points go more than once around.
  for (const int degree : {4, 5}) {
    for (int count = 3; count <= degree; ++count) {
      for (const bool weighted : {false, true}) {
        CurveShape shape{CurveKind::kBSpline, true, degree};
        if (weighted) shape.weights.assign({1, 2, 0.5, 1, 3}), shape.weights.resize(size_t(count));
        Curve curve = curveOf(shape, points(count));
        for (const double part : {0.0, 0.13, 0.5, 0.99}) {
          SCOPED_TRACE(describe(shape) + ", " + std::to_string(count) + " points, at " +
                       std::to_string(part));
          const double parameter = part * curve.segmentCount();
          const SegmentParameter cut = segmentParameter(curve, parameter);
          const RefinedCurve refined = withPointOnCurve(curve, parameter);
          ASSERT_EQ(refined.curve.points.count(), count + 1);
          Curve more = curveOf(refined.curve.shape, refined.curve.points);
          for (int j = 0; j < curve.segmentCount(); ++j) {
            for (const double t : {0.01, 0.25, 0.6, 0.99}) {
              EXPECT_LT((at(curve, j + t) - at(more, afterCut({j, t}, cut))).norm(), kPlane);
            }
          }
          const Array<CurveParts> parts = splitAt(curve, parameter);
          ASSERT_EQ(parts.count(), 1);
          Curve open = curveOf(parts[0].shape, parts[0].points);
          EXPECT_LT((at(open, 0) - at(curve, parameter)).norm(), kPlane);
          EXPECT_LT((at(open, open.segmentCount()) - at(curve, parameter)).norm(), kPlane);
          EXPECT_LT((at(open, open.segmentCount() - 1e-9) - at(curve, parameter - 1e-9)).norm(),
                    1e-7);
        }
      }
    }
  }
}

TEST_F(CurveRefine, CurvesThroughPointsTakePointsUntilTheirBetasEnd) {
  // Each point raises the degree of a curve of degree 5: its betas approach binomial numbers, which
  // beyond 35 points differ by more than 1e12.
  Surface small(planeGrid(4, 4));
  CurveParts parts{{CurveKind::kBarycentric}, {}};
  for (const Vec3& place : kPlaces) {
    parts.points.push_back(nearestPoint(small.mesh(), 4 * place));
  }
  std::string refusal;
  while (refusal.empty() && parts.points.count() < 200) {
    Curve curve(small, ofLevelZero(parts.shape, 2, kFast), parts.points);
    try {
      parts = withPointOnCurve(curve, 0.4).curve;
      checkShape(parts.shape, parts.points.count());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadArgument);
      refusal = error.what();
    }
  }
  std::printf("a barycentric curve of 6 points grows to %d\n", parts.points.count());
  EXPECT_GT(parts.points.count(), 60);
  EXPECT_NE(refusal.find("betas that differ by a factor of 1e25"), std::string::npos) << refusal;
}

TEST_F(CurveRefine, RaisingTheDegreeLeavesCurvesOfOneSegmentAsTheyAre) {
  for (const bool closed : {false, true}) {
    CurveShape rational{CurveKind::kRational, closed};
    rational.weights = {1, 2, 0.5, 1, 3, 1};
    CurveShape barycentric{CurveKind::kBarycentric, closed};
    barycentric.betas = {1, 2, 4, 3, 1.5, 0.7};
    for (const CurveShape& shape : {CurveShape{CurveKind::kBezier, closed}, rational, barycentric,
                                    CurveShape{CurveKind::kBarycentric, closed}}) {
      SCOPED_TRACE(describe(shape));
      Curve curve = curveOf(shape, points());
      const RefinedCurve refined = withPointOnCurve(curve, 0.4);
      ASSERT_EQ(refined.curve.points.count(), 7);
      Curve more = curveOf(refined.curve.shape, refined.curve.points);
      expectPart(curve, 0, 1, more);
    }
  }
}

TEST_F(CurveRefine, CurvesThroughPointsTakeAPointOfTheCurve) {
  for (const CurveKind kind : {CurveKind::kCatmullRom, CurveKind::kPolyline}) {
    for (const bool closed : {false, true}) {
      Curve curve = curveOf({kind, closed}, points());
      const double parameter = curve.segmentCount() - 0.3;
      const Vec3 place = at(curve, parameter);
      const RefinedCurve refined = withPointOnCurve(curve, parameter);
      EXPECT_EQ(refined.point, curve.segmentCount());
      Curve more = curveOf(refined.curve.shape, refined.curve.points);
      EXPECT_LT((at(more, curve.segmentCount()) - place).norm(), kPlane);
      EXPECT_EQ(codeOf([&] { withPointOnCurve(curve, 1); }), ErrorCode::kBadArgument);
    }
  }
}

TEST_F(CurveRefine, TheHalvesOfABSplineRunAlongIt) {
  for (const CurveShape& shape : bsplines()) {
    Curve curve = curveOf(shape, points());
    const int segments = curve.segmentCount();
    for (const double part : {0.0, 0.3, 0.5, 0.77}) {
      if (part == 0 && !shape.closed) continue;
      SCOPED_TRACE(describe(shape) + " at " + std::to_string(part));
      const double parameter = part * segments;
      const SegmentParameter cut = segmentParameter(curve, parameter);
      const Array<CurveParts> parts = splitAt(curve, parameter);
      ASSERT_EQ(parts.count(), shape.closed ? 1 : 2);
      Curve after = curveOf(parts[parts.count() - 1].shape, parts[parts.count() - 1].points);
      // First the rest of the cut segment, then the other segments.
      for (int i = 0; i <= 6; ++i) {
        const double s = i / 6.0;
        EXPECT_LT((at(after, s) - at(curve, cut.segment + cut.t + s * (1 - cut.t))).norm(), kPlane);
        if (cut.segment + 1 < segments) {
          EXPECT_LT((at(after, 1 + s) - at(curve, cut.segment + 1 + s)).norm(), kPlane);
        }
      }
      EXPECT_LT(
          (at(after, after.segmentCount()) - at(curve, shape.closed ? parameter : segments)).norm(),
          kPlane);
      if (shape.closed) continue;
      Curve before = curveOf(parts[0].shape, parts[0].points);
      for (int i = 0; i <= 6 && cut.t > 0; ++i) {
        EXPECT_LT(
            (at(before, cut.segment + i / 6.0) - at(curve, cut.segment + cut.t * i / 6)).norm(),
            kPlane);
      }
      EXPECT_LT((at(before, 0) - at(curve, 0)).norm(), kPlane);
    }
  }
}

TEST_F(CurveRefine, TheHalvesOfOneSegmentRunAlongIt) {
  for (const bool closed : {false, true}) {
    CurveShape rational{CurveKind::kRational, closed};
    rational.weights = {1, 2, 0.5, 1, 3, 1};
    CurveShape barycentric{CurveKind::kBarycentric, closed};
    barycentric.betas = {1, 2, 4, 3, 1.5, 0.7};
    for (const CurveShape& shape :
         {CurveShape{CurveKind::kBezier, closed}, rational, barycentric}) {
      SCOPED_TRACE(describe(shape));
      Curve curve = curveOf(shape, points());
      const Array<CurveParts> parts = splitAt(curve, 0.35);
      ASSERT_EQ(parts.count(), 2);
      Curve before = curveOf(parts[0].shape, parts[0].points);
      Curve after = curveOf(parts[1].shape, parts[1].points);
      expectPart(curve, 0, 0.35, before);
      expectPart(curve, 0.35, 1, after);
      EXPECT_EQ(codeOf([&] { splitAt(curve, 0); }), ErrorCode::kBadArgument);
    }
  }
}

TEST_F(CurveRefine, CurvesThroughPointsAreSplitAtANewControlPoint) {
  for (const CurveKind kind : {CurveKind::kCatmullRom, CurveKind::kPolyline}) {
    Curve open = curveOf({kind}, points());
    for (const double parameter : {2.0, 2.4}) {
      const Array<CurveParts> parts = splitAt(open, parameter);
      ASSERT_EQ(parts.count(), 2);
      EXPECT_EQ(parts[0].points.count(), parameter > 2 ? 4 : 3);
      EXPECT_EQ(parts[1].points.count(), parameter > 2 ? 4 : 4);
      Curve before = curveOf(parts[0].shape, parts[0].points);
      EXPECT_LT((at(before, before.segmentCount()) - at(open, parameter)).norm(), kPlane);
    }
    Curve closed = curveOf({kind, true}, points());
    for (const double parameter : {0.0, 2.0, 2.4, 5.9}) {
      const Array<CurveParts> parts = splitAt(closed, parameter);
      ASSERT_EQ(parts.count(), 1);
      Curve around = curveOf(parts[0].shape, parts[0].points);
      EXPECT_LT((at(around, 0) - at(closed, parameter)).norm(), kPlane);
      EXPECT_LT((at(around, around.segmentCount()) - at(closed, parameter)).norm(), kPlane);
    }
  }
}

TEST_F(CurveRefine, JoiningTheHalvesRestoresTheCurve) {
  for (const CurveShape& shape : bsplines()) {
    if (shape.closed) continue;
    SCOPED_TRACE(describe(shape));
    Curve curve = curveOf(shape, points());
    const double parameter = 0.4 * curve.segmentCount();
    const Array<CurveParts> parts = splitAt(curve, parameter);
    const Curve before = curveOf(parts[0].shape, parts[0].points);
    const Curve after = curveOf(parts[1].shape, parts[1].points);
    const CurveParts whole = joined(before, after);
    Curve again = curveOf(whole.shape, whole.points);
    const SegmentParameter cut = segmentParameter(curve, parameter);
    ASSERT_EQ(again.segmentCount(), curve.segmentCount() + (cut.t > 0 ? 1 : 0));
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const double t : {0.0, 0.25, 0.6, 1.0}) {
        EXPECT_LT((at(curve, j + t) - at(again, afterCut({j, t}, cut))).norm(), kPlane);
      }
    }
    EXPECT_LT((at(again, again.segmentCount()) - at(curve, curve.segmentCount())).norm(), kPlane);
  }
}

TEST_F(CurveRefine, JoinsTouchingAndSeparateCurves) {
  const Array<SurfacePoint> all = points();
  const Array<SurfacePoint> front(all.begin(), all.begin() + 3);
  const Array<SurfacePoint> back(all.begin() + 3, all.end());
  Array<SurfacePoint> touching = back;
  touching[0] = front[2];
  for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kRational, CurveKind::kBarycentric,
                               CurveKind::kCatmullRom, CurveKind::kPolyline}) {
    SCOPED_TRACE(curveKindName(kind));
    Curve first = curveOf({kind}, front);
    for (const bool meet : {true, false}) {
      Curve second = curveOf({kind}, meet ? touching : back);
      const CurveParts parts = joined(first, second);
      Curve whole = curveOf(parts.shape, parts.points);
      EXPECT_LT((at(whole, 0) - at(first, 0)).norm(), kPlane);
      EXPECT_LT((at(whole, whole.segmentCount()) - at(second, second.segmentCount())).norm(),
                kPlane);
      if (kind != CurveKind::kBezier && kind != CurveKind::kRational) continue;
      EXPECT_EQ(parts.shape.kind, CurveKind::kBSpline);
      EXPECT_EQ(whole.segmentCount(), meet ? 2 : 3);
      for (int i = 0; i <= 6; ++i) {
        EXPECT_LT((at(whole, i / 6.0) - at(first, i / 6.0)).norm(), kPlane);
        EXPECT_LT((at(whole, whole.segmentCount() - 1 + i / 6.0) - at(second, i / 6.0)).norm(),
                  kPlane);
      }
      if (!meet) {
        EXPECT_LT((at(whole, 1.5) - (at(first, 1) + at(second, 0)) / 2).norm(), kPlane);
      }
    }
  }
  Curve spline = curveOf({CurveKind::kBSpline, false, 2}, front);
  Curve cubic = curveOf({CurveKind::kBSpline}, all);
  Curve closed = curveOf({CurveKind::kBSpline, true}, all);
  Curve polyline = curveOf({CurveKind::kPolyline}, all);
  Curve bezier = curveOf({CurveKind::kBezier}, all);
  EXPECT_EQ(codeOf([&] { joined(spline, cubic); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { joined(cubic, closed); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { joined(polyline, bezier); }), ErrorCode::kBadArgument);
  EXPECT_NO_THROW(joined(bezier, bezier));
}

TEST(CurveJoins, LeadRoundASlitBetweenEndsAtOnePlaceInSpace) {
  // A square of 4 x 4 cells with a slit along x = 2 from y = 2 to its boundary.
  constexpr int kSide = 4;
  Array<Vec3> positions;
  for (int y = 0; y <= kSide; ++y) {
    for (int x = 0; x <= kSide; ++x) positions.push_back(Vec3(x, y, 0));
  }
  const auto left = [](int x, int y) { return y * (kSide + 1) + x; };
  const int bank = positions.count() - 3;
  for (const int y : {3, 4}) positions.push_back(Vec3(2, y, 0));
  const auto right = [&](int x, int y) { return x == 2 && y > 2 ? bank + y : left(x, y); };
  Array<Triangle> faces;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto at = [&](int i, int j) { return x < 2 ? left(i, j) : right(i, j); };
      faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  Surface slit(buildMesh(positions, faces));
  const auto pointOn = [&](double x, double y, double side) {
    for (int v = 0; v < slit.mesh().vertexCount(); ++v) {
      if (slit.mesh().positions[v] != Vec3(x, y, 0)) continue;
      const int f = vertexPoint(slit.mesh(), v).face;
      const Vec3 middle = position(slit.mesh(), {f, Vec3::Constant(1.0 / 3)});
      if ((middle.x() - x) * side > 0) return vertexPoint(slit.mesh(), v);
    }
    throw Error(ErrorCode::kBadArgument, "no such vertex");
  };
  const SurfacePoint from = pointOn(0, 3, 1);
  const SurfacePoint leftBank = pointOn(2, 4, -1);
  const SurfacePoint rightBank = pointOn(2, 4, 1);
  const SurfacePoint to = pointOn(4, 3, -1);
  for (const CurveKind kind : {CurveKind::kPolyline, CurveKind::kBezier}) {
    SCOPED_TRACE(curveKindName(kind));
    Curve first(slit, ofLevelZero({kind}, 5, kExact), {from, leftBank});
    Curve second(slit, ofLevelZero({kind}, 5, kExact), {rightBank, to});
    const CurveParts parts = joined(first, second);
    EXPECT_EQ(parts.points.count(), 4);
    Curve third(slit, ofLevelZero({kind}, 5, kExact), {leftBank, to});
    EXPECT_EQ(joined(first, third).points.count(), 3);
  }
}

TEST_F(CurveRefine, AParameterBesideAJointMeansTheJoint) {
  const CurveShape own{
      CurveKind::kBSpline, true, 3, KnotRule::kOwn, {0.1, 0.15, 0.2, 0.25, 0.3, 0.4}};
  for (const CurveShape& shape : {CurveShape{CurveKind::kBSpline, true}, own}) {
    SCOPED_TRACE(describe(shape));
    Curve curve = curveOf(shape, points(5));
    const RefinedCurve refined = withPointOnCurve(curve, 0);
    for (const double beside : {-1e-20, -1e-17, 1e-17, 5.0, std::nextafter(5.0, 0)}) {
      const RefinedCurve more = withPointOnCurve(curve, beside);
      EXPECT_EQ(more.curve.shape.knots, refined.curve.shape.knots) << beside;
      EXPECT_EQ(more.point, refined.point) << beside;
      for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(more.curve.points[i].bary, refined.curve.points[i].bary) << beside << ", " << i;
      }
      const Array<CurveParts> parts = splitAt(curve, beside);
      ASSERT_EQ(parts.count(), 1);
      Curve open = curveOf(parts[0].shape, parts[0].points);
      ASSERT_EQ(open.segmentCount(), 5);
      for (int i = 0; i <= 20; ++i) {
        EXPECT_LT((at(open, i / 4.0) - at(curve, i / 4.0)).norm(), kPlane) << beside << ", " << i;
      }
    }
  }
  Curve curve = curveOf({CurveKind::kBSpline}, points());
  for (const double joint : {0.0, 1.0, 2.0, 3.0}) {
    for (const double end : {0.0, 3.0}) {
      const double beside = std::nextafter(joint, joint == end ? 1.5 : end);
      EXPECT_EQ(withPointOnCurve(curve, beside).curve.shape.knots,
                withPointOnCurve(curve, joint).curve.shape.knots)
          << inFull(beside);
    }
  }
  for (const double end : {0.0, 3.0}) {
    EXPECT_EQ(codeOf([&] { splitAt(curve, std::nextafter(end, 1.5)); }), ErrorCode::kBadArgument);
  }
}

TEST_F(CurveRefine, ASpanWithoutANumberInsideIsSplitAtItsEnds) {
  const double before = std::nextafter(2.0, 0);
  Curve curve =
      curveOf({CurveKind::kBSpline, false, 3, KnotRule::kOwn, {0, 0, 0, 0, 1, before, 2, 2, 2, 2}},
              points());
  ASSERT_EQ(curve.segmentCount(), 3);
  EXPECT_EQ(codeOf([&] { splitAt(curve, 2.5); }), ErrorCode::kBadArgument);
  EXPECT_EQ(splitAt(curve, 2).count(), 2);
}

TEST_F(CurveRefine, ClosedKnotsMayRepeatTheFirstKnotAtTheirEnd) {
  Curve curve =
      curveOf({CurveKind::kBSpline, true, 3, KnotRule::kOwn, {0, 1, 1.5, 4, 5, 6, 6}}, points());
  ASSERT_EQ(curve.segmentCount(), 5);
  const Array<CurveParts> parts = splitAt(curve, 0);
  Curve open = curveOf(parts[0].shape, parts[0].points);
  ASSERT_EQ(open.segmentCount(), 5);
  for (int i = 0; i <= 20; ++i) {
    EXPECT_LT((at(open, i / 4.0) - at(curve, i / 4.0)).norm(), kPlane) << i;
  }
}

TEST_F(CurveRefine, AGeodesicBetweenJoinedCurvesTakesTheMeanSpan) {
  const Array<SurfacePoint> all = points();
  Curve first = curveOf({CurveKind::kBSpline}, {all[0], all[1], all[2], all[3]});
  Curve second = curveOf({CurveKind::kBSpline}, {all[5], all[4], all[2], all[1]});
  EXPECT_EQ(joined(first, second).shape.knots,
            Array<double>({-3, -2, -1, 0, 1, 1, 1, 2, 2, 2, 3, 4, 5, 6}));
}

TEST_F(CurveRefine, OnACurvedSurfaceTheNewPointsStayNear) {
  Surface bunny(bunnyMesh());
  Array<SurfacePoint> where;
  for (int i = 0; i < 6; ++i) {
    const Vec2 around = unitVector(2 * kPi * i / 6);
    where.push_back(nearestPoint(bunny.mesh(), Vec3(-3 + around.x(), 7.5 + around.y(), 4)));
  }
  Curve curve(bunny, ofLevelZero({CurveKind::kBSpline, true}, 9, kExact), where);
  const RefinedCurve refined = withPointOnCurve(curve, 2.4);
  Curve more(bunny, {refined.curve.shape, 9, kExact}, refined.curve.points);
  double worst = 0;
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const double other = t < 0.4 ? 2 + t / 0.4 : 3 + (t - 0.4) / 0.6;
    worst = std::max(worst, (position(bunny.mesh(), pointAt(curve, 2 + t).point) -
                             position(bunny.mesh(), pointAt(more, other).point))
                                .norm());
  }
  std::printf("a knot in a curve on the bunny moves it by %.1e of the bounding box\n",
              worst / bunny.geometry().diagonal);
  EXPECT_LT(worst, 5e-3 * bunny.geometry().diagonal);
}

}  // namespace
}  // namespace karcher

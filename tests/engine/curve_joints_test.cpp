#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "generators/curve_shapes.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/straightest.h"
#include "measures/corner.h"
#include "support.h"

namespace karcher {
namespace {

constexpr double kSpacings[] = {0.05, 0.1, 0.2, 0.3};

CurveOptions automatic(const CurveShape& shape) {
  CurveOptions options = ofLevelZero(shape, 17, kFast);
  options.levels = kAutomaticLevels;
  return options;
}

bool isBridged(const Curve& curve) {
  for (int j = 0; j < curve.segmentCount(); ++j) {
    if (!curve.bridges(j).empty()) return true;
  }
  return false;
}

/// Measurements at the joints of curves.
struct Joints {
  int curves = 0;
  int segments = 0;       ///< the number of joints between segments
  int pieces = 0;         ///< the number of joints between pieces of a segment
  double atSegments = 0;  ///< the largest angles, in degrees
  double atPieces = 0;

  void add(Curve& curve) {
    ++curves;
    EXPECT_FALSE(isBridged(curve));
    const CurveShape& shape = curve.shape();
    // A closed Bezier curve has a corner at its end.
    const bool isBezier = shape.kind == CurveKind::kBezier || shape.kind == CurveKind::kRational;
    const int count = curve.piecesPerSegment();
    for (int i = shape.closed && !isBezier ? 0 : 1; i < count * curve.segmentCount(); ++i) {
      const double angle = cornerAt(curve, static_cast<double>(i) / count);
      EXPECT_FALSE(std::isnan(angle)) << "joint " << i << " of " << count << " pieces a segment";
      const bool isBetweenSegments = i % count == 0;
      ++(isBetweenSegments ? segments : pieces);
      double& largest = isBetweenSegments ? atSegments : atPieces;
      largest = std::max(largest, angle);
    }
  }
};

/// Four anchors, each between two handles on a geodesic through it: consecutive cubic Bezier
/// curves. The second handle turns away from that geodesic by `bend` radians.
Array<SurfacePoint> anchorsWithHandles(const Geometry& geometry, Random& random, double spacing,
                                       double bend) {
  const Array<SurfacePoint> anchors =
      randomControlPolygon(geometry, random, {.points = 4, .spacing = spacing});
  Array<SurfacePoint> points;
  for (int i = 0; i < anchors.count(); ++i) {
    const double direction = random.uniform(-kPi, kPi);
    const double length = 0.3 * spacing * geometry.diagonal;
    const auto handle = [&](double angle) {
      return traceStraightest(geometry, anchors[i], length * unitVector(angle)).path.end();
    };
    if (i > 0) points.push_back(handle(direction + kPi));
    points.push_back(anchors[i]);
    if (i + 1 < anchors.count()) points.push_back(handle(direction + bend));
  }
  return points;
}

CurveShape splineOfBezierCurves(int curves) {
  CurveShape shape{CurveKind::kBSpline, false, 3, KnotRule::kOwn};
  shape.knots.push_back(0);
  for (int i = 0; i <= curves; ++i) shape.knots.insert(shape.knots.end(), 3, i);
  shape.knots.push_back(curves);
  return shape;
}

Joints jointsOn(const TriangleSoup& soup, uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Surface surface(meshOf(soup));
  Random random(seed);
  Joints joints;
  for (const double spacing : kSpacings) {
    SCOPED_TRACE("spacing " + std::to_string(spacing));
    for (int i = 0; i < (longRun() ? 20 : 2); ++i) {
      SCOPED_TRACE("polygon " + std::to_string(i));
      const Array<SurfacePoint> points =
          randomControlPolygon(surface.geometry(), random, {.points = 6, .spacing = spacing});
      for (const CurveShape& shape : everyShape(points.count())) {
        if (!takesLevels(shape.kind)) continue;
        SCOPED_TRACE(describe(shape));
        Curve curve(surface, automatic(shape), points);
        joints.add(curve);
      }
      SCOPED_TRACE("Bezier curves one after the other");
      Curve curve(surface, automatic(splineOfBezierCurves(3)),
                  anchorsWithHandles(surface.geometry(), random, spacing, 0));
      joints.add(curve);
    }
  }
  std::printf(
      "%d triangles, %d curves; at %d joints of segments up to %.2g degrees, at %d of "
      "pieces %.2g\n",
      surface.mesh().faceCount(), joints.curves, joints.segments, joints.atSegments, joints.pieces,
      joints.atPieces);
  EXPECT_GT(joints.pieces, joints.curves);
  EXPECT_GT(joints.segments, joints.curves);
  return joints;
}

/// Checks that the remaining angle comes from the mesh: it falls with the square of its edges.
void expectSmoothJoints(const TriangleSoup& coarse, const TriangleSoup& fine, uint64_t seed) {
  const Joints onCoarse = jointsOn(coarse, seed);
  const Joints onFine = jointsOn(fine, seed);
  EXPECT_LT(onFine.atSegments, 0.5);
  EXPECT_LT(onFine.atPieces, 0.5);
  EXPECT_LT(onFine.atSegments, onCoarse.atSegments / 2);
  EXPECT_LT(onFine.atPieces, onCoarse.atPieces / 2);
}

TEST(CurveJoints, OfAutomaticLevelsAreSmoothOnASphere) {
  SKIP_WHERE_SANITIZED();
  expectSmoothJoints(relaxedSphere(5000, 5), relaxedSphere(20000, 5), 31);
}

TEST(CurveJoints, OfAutomaticLevelsAreSmoothOnATorus) {
  SKIP_WHERE_SANITIZED();
  expectSmoothJoints(irregularTorus(5000, 1, 6), irregularTorus(20000, 1, 6), 32);
}

/// Where a polygon turns by 180 degrees, the derivative of its centripetal Catmull-Rom curve is 0,
/// whatever the lengths of the legs: the curve turns back there, in the plane and on a surface.
TEST(CurveJoints, OfACatmullRomCurveTurnBackWithItsLegs) {
  Surface surface(planeGrid(20, 20));
  const TriangleMesh& mesh = surface.mesh();
  for (const double back : {2.0, 5.0, 9.0}) {
    SCOPED_TRACE(back);
    Array<SurfacePoint> points;
    const Vec3 turn(14.3, 9.1, 0);
    for (const Vec3& place : {Vec3(5.3, 3.1, 0), Vec3(8.3, 9.1, 0), turn,
                              Vec3(turn - Vec3(back, 0, 0)), Vec3(6.3, 15.1, 0)}) {
      points.push_back(nearestPoint(mesh, place));
    }
    const Curve curve(surface, ofLevelZero({CurveKind::kCatmullRom}, 129, kFast), points);
    const auto before = [&](int steps) -> Vec3 {
      const auto& samples = curve.samples(1);
      return position(mesh, samples[samples.count() - 1 - steps].point) - turn;
    };
    const auto after = [&](int steps) -> Vec3 {
      return position(mesh, curve.samples(2)[steps].point) - turn;
    };
    EXPECT_LT(before(0).norm(), 1e-9);
    for (const auto& side : {before(1), after(1)}) EXPECT_LT(side.normalized().x(), -0.9);
    // The curve slows down to rest: in twice the time it moves four times as far.
    EXPECT_NEAR(before(2).norm() / before(1).norm(), 4, 0.1);
    EXPECT_NEAR(after(2).norm() / after(1).norm(), 4, 0.1);
  }
}

TEST(CurveJoints, HaveTheAnglesOfTheirHandles) {
  Surface surface(meshOf(relaxedSphere(8000, 5)));
  Random random(33);
  SCOPED_TRACE("seed 33");
  for (const double bend : {0.2, 1.0}) {
    Curve curve(surface, automatic(splineOfBezierCurves(3)),
                anchorsWithHandles(surface.geometry(), random, 0.1, bend));
    ASSERT_FALSE(isBridged(curve));
    for (const int joint : {1, 2}) {
      EXPECT_NEAR(cornerAt(curve, joint), bend * 180 / kPi, 0.5);
    }
  }
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <cmath>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/curve_shapes.h"
#include "generators/flat.h"
#include "support.h"

namespace karcher {
namespace {

/// A curve of four points around a tube of radius 1, each at an angle and a height.
class ContinuedLegs : public testing::Test {
 protected:
  SurfacePoint at(double angle, double height) const {
    return nearestPoint(surface_.mesh(), Vec3(std::cos(angle), std::sin(angle), height));
  }

  Curve curveOf(const Array<SurfacePoint>& points) {
    CurveOptions options = ofLevelZero({CurveKind::kBezier}, 9, kFast);
    options.levels = 2;
    return Curve(surface_, options, points);
  }

  /// Moves points of the curve to other places, as a drag does.
  static void drag(Curve& curve, const Array<int>& dragged, const Array<SurfacePoint>& places) {
    CurveValue value = curve.value();
    for (int k = 0; k < dragged.count(); ++k) {
      value = withPointDragged(std::move(value), dragged[k], places[k], curve.legs());
    }
    curve.set(std::move(value));
  }

  /// The curve whose last point moved nearly once around: its last leg is the long path.
  Curve drawnOut() {
    Curve curve = curveOf({at(0, 1.2), at(0.1, 1), at(0.2, 0.9), at(0.3, 0.9)});
    for (double angle = 0.4; angle < 5; angle += 0.1) curve.dragPoint(3, at(angle, 0.9));
    return curve;
  }

  Surface surface_{meshOf(flatCylinder(24, 2, 5).soup)};
};

TEST_F(ContinuedLegs, OfWhichBothEndsMoveKeepTheirSide) {
  Curve curve = drawnOut();
  const double before = curve.legs()[2].length();
  // The leg lies on a polygon of 24 sides, slightly shorter than the arc.
  EXPECT_NEAR(before, 4.75, 0.1);
  for (int step = 1; step <= 40; ++step) {
    drag(curve, {2, 3}, {at(0.2 + 0.1 * step, 0.9), at(4.95 + 0.1 * step, 0.9)});
    // Faces are flat: an arc's length varies with its start by up to a side's bulge.
    ASSERT_NEAR(curve.legs()[2].length(), before, 0.05) << "step " << step;
    // Half around from its start a path back is shorter.
    ASSERT_NEAR(curve.legs()[1].length(), 0.1 + 0.1 * step, 0.1) << "step " << step;
  }
  // The legs are part of the value, and stay.
  const Curve again(surface_, curve.value());
  EXPECT_EQ(again.usedLegs()[1].length(), curve.legs()[1].length());
  EXPECT_EQ(again.usedLegs()[2].length(), curve.legs()[2].length());
}

TEST_F(ContinuedLegs, OfSeveralDraggedPointsEqualThoseOfTheOneThatMoves) {
  Curve one = drawnOut();
  Curve several = drawnOut();
  for (int step = 1; step <= 40; ++step) {
    const SurfacePoint place = at(0.2 + 0.1 * step, 0.9);
    drag(one, {2}, {place});
    drag(several, {1, 2, 3}, {several.point(1), place, several.point(3)});
    for (int i = 0; i < 3; ++i) {
      const SurfacePath& a = one.legs()[i];
      const SurfacePath& b = several.legs()[i];
      ASSERT_EQ(a.points.count(), b.points.count()) << "step " << step << ", leg " << i;
      ASSERT_EQ(a.length(), b.length()) << "step " << step << ", leg " << i;
    }
  }
}

TEST_F(ContinuedLegs, AreShortestPathsAfterTheOtherEndIsPlaced) {
  Curve curve = drawnOut();
  const CurveValue value = withPointDragged(curve.value(), 3, at(5, 0.9), curve.legs());
  curve.set(withPointPlaced(value, 2, at(0.3, 0.9)));
  EXPECT_LT(curve.legs()[2].length(), 1.7);
}

TEST_F(ContinuedLegs, StayWhileACurveThatUsesNoneIsDragged) {
  CurveValue value = drawnOut().value();
  value.options.levels = 0;
  Curve curve(surface_, value);
  curve.dragPoint(0, at(0, 1.3));
  value = curve.value();
  ASSERT_EQ(value.legs.count(), 3);
  value.options.levels = 2;
  EXPECT_NEAR(Curve(surface_, value).legs()[2].length(), 4.75, 0.1);
}

TEST_F(ContinuedLegs, OfMissingPointsAreRefused) {
  Curve curve = drawnOut();
  EXPECT_EQ(codeOf([&] { curve.dragPoint(4, at(0, 1)); }), ErrorCode::kBadIndex);
}

TEST_F(ContinuedLegs, ContinueTheLegsOfAValueWithMovedPoints) {
  Curve curve = drawnOut();
  CurveValue value = curve.value();
  value.points[3] = at(5, 0.9);
  // A new curve of the value equals the dragged one.
  Curve made(surface_, value);
  curve.dragPoint(3, at(5, 0.9));
  EXPECT_EQ(made.legs()[2].length(), curve.legs()[2].length());
  EXPECT_EQ(made.value().legs[2].points.count(), curve.value().legs[2].points.count());
  // Legs in the wrong places do not count: each leg still joins its own two points.
  value = curve.value();
  std::swap(value.legs[2], value.legs[1]);
  Curve swapped(surface_, value);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(swapped.legs()[i].start().face, value.points[i].face) << "leg " << i;
    EXPECT_EQ(swapped.legs()[i].end().face, value.points[i + 1].face) << "leg " << i;
  }
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include "curve_support.h"
#include "curves/curve.h"
#include "distance/paged_array.h"
#include "generators/control_polygons.h"
#include "measures/allocations.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

constexpr int kDragged = 1;

TEST(DragMemory, IsCounted) {
  const int64_t before = allocationsSoFar();
  void* const memory = ::operator new(16);
  EXPECT_EQ(allocationsSoFar() - before, 1);
  ::operator delete(memory);
}

TEST(DragMemory, IsNoPartOfTheCurve) {
  Surface surface(planeGrid(8, 8));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{1, 1, 0}, {3, 6, 0}, {5, 2, 0}, {7, 7, 0}});
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, 17, kFast);
  options.levels = 2;
  Curve curve(surface, options, points);
  const SurfacePoint elsewhere = nearestPoint(surface.mesh(), {4, 5, 0});
  for (int step = 0; step < 3; ++step) {
    const Array<SurfacePoint> line = curve.path(0).line.points;
    CurveValue refused = withPointPlaced(curve.value(), kDragged, elsewhere);
    refused.options.samples = 1;
    EXPECT_EQ(codeOf([&] { curve.set(refused); }), ErrorCode::kBadArgument);
    const Curve anew(surface, curve.value());
    ASSERT_EQ(curve.path(0).line.points.count(), line.count());
    for (int i = 0; i < line.count(); ++i) {
      EXPECT_EQ(curve.path(0).line.points[i].bary, line[i].bary);
      EXPECT_EQ(anew.path(0).line.points[i].bary, line[i].bary);
    }
    curve.dragPoint(kDragged, nearestPoint(surface.mesh(), {3.0 + 0.3 * step, 6, 0}));
  }
}

TEST(DragMemory, OfAPlacedPointKeepsTheOtherLegs) {
  Surface surface(planeGrid(8, 8));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{1, 1, 0}, {3, 6, 0}, {5, 2, 0}, {7, 7, 0}});
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, 17, kFast);
  options.levels = 1;
  options.shape.closed = true;
  Curve curve(surface, options, points);
  CurveValue value{options, points, curve.legs()};
  value = withPointPlaced(value, 0, points[0]);
  for (const SurfacePath& leg : value.legs) EXPECT_FALSE(leg.points.empty());
  value = withPointPlaced(value, 0, nearestPoint(surface.mesh(), {1, 2, 0}));
  ASSERT_EQ(value.legs.count(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(value.legs[i].points.empty(), i == 0 || i == 3) << i;
  EXPECT_EQ(codeOf([&] { withPointPlaced(value, 4, points[0]); }), ErrorCode::kBadIndex);
}

/// Default curves check whether level 0 follows the paths to which the legs straighten. If the
/// curve takes levels anyway, it frees the fields from end to end of this check.
TEST(CurveMemory, OfAutomaticLevelsEqualsThatOfGivenLevels) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kTorus, 80000));
  const auto heldBy = [&](const CurveOptions& options, const Array<SurfacePoint>& polygon,
                          int& levels) {
    Surface surface(mesh);
    const int64_t before = bytesHeld();
    const Curve curve(surface, options, polygon);
    levels = curve.levels();
    return bytesHeld() - before;
  };
  const Geometry geometry = buildGeometry(mesh);
  Random random(5);
  for (int i = 0; i < 4; ++i) {
    const Array<SurfacePoint> polygon = randomControlPolygon(geometry, random, {.spacing = 0.2});
    CurveOptions options;
    options.shape.kind = CurveKind::kBezier;
    options.levels = kAutomaticLevels;
    options.leastLevels = 3;
    int levels = 0;
    const int64_t chosen = heldBy(options, polygon, levels);
    ASSERT_GE(levels, options.leastLevels);
    options.levels = levels;
    const int64_t given = heldBy(options, polygon, levels);
    EXPECT_LE(chosen, given + given / 4) << "polygon " << i;
  }
}

TEST(PagedArray, TakesPagesFromAPoolAsNewOnes) {
  struct Entry {
    int number = 7;
  };
  const auto pool = std::make_shared<PagePool>();
  PagedArray<Entry, 4> first(100, pool);
  PagedArray<Entry, 4> second(100, pool);
  for (int i = 0; i < 100; ++i) first.touch(i).number = i;
  const Entry* const page = first.find(50);
  first.clear();
  EXPECT_EQ(first.find(50), nullptr);
  bool isUsedAgain = false;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(second.touch(i).number, 7);
    isUsedAgain = isUsedAgain || second.find(i) == page;
  }
  EXPECT_TRUE(isUsedAgain);
  pool->trim();
  EXPECT_EQ(second.find(3)->number, 7);
}

TEST(PagedArray, FreesThePagesThatNoArrayHolds) {
  constexpr int kCount = 4000;
  const auto pool = std::make_shared<PagePool>();
  PagedArray<double, 4> held(kCount, pool);
  PagedArray<double, 4> other(kCount, pool);
  const auto fill = [](PagedArray<double, 4>& array, int step) {
    const int64_t before = allocationsSoFar();
    for (int i = 0; i < kCount; i += step) array.touch(i) = i;
    return allocationsSoFar() - before;
  };
  // Many pages come in few blocks.
  const int64_t made = fill(other, 1);
  EXPECT_GT(made, 0);
  EXPECT_LT(made, kCount / 16 / 4);
  other.clear();
  EXPECT_EQ(fill(other, 1), 0);
  other.clear();
  // Some pages of several blocks stay.
  EXPECT_EQ(fill(held, 160), 1) << "the numbers of its pages";
  pool->trim();
  for (int i = 0; i < kCount; i += 160) EXPECT_EQ(held.find(i) ? *held.find(i) : -1, i);
  EXPECT_GT(fill(other, 1), 0);
  for (int i = 0; i < kCount; ++i) ASSERT_EQ(*other.find(i), i);
  held.clear();
  other.clear();
  pool->trim();
  EXPECT_GT(fill(held, 1), 0);
  for (int i = 0; i < kCount; ++i) ASSERT_EQ(*held.find(i), i);
}

}  // namespace
}  // namespace karcher

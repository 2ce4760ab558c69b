#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cases.h"
#include "curve_support.h"
#include "curves/curve.h"
#include "distance/paged_array.h"
#include "generators/control_polygons.h"
#include "generators/curve_shapes.h"
#include "measures/allocations.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

constexpr int kDragged = 1;

int bridgesOf(const Curve& curve) {
  int bridges = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) bridges += curve.bridges(j).count();
  return bridges;
}

/// How often each step of a drag takes memory, after the first ones. `bridgedOnly`: of the steps
/// after which the curve has bridges.
Array<int64_t> allocationsOfDrag(Surface& surface, const CurveOptions& options, double spacing,
                                 uint64_t seed, bool bridgedOnly = false) {
  constexpr int kSteps = 80;
  constexpr int kWarmUp = 20;
  const Geometry& geometry = surface.geometry();
  Random random(seed);
  Array<SurfacePoint> polygon;
  Array<SurfacePoint> path;
  while (path.empty()) {
    polygon = randomControlPolygon(geometry, random, {.spacing = spacing});
    path = dragPath(geometry, polygon[kDragged], unitVector(random.uniform(-kPi, kPi)),
                    0.1 * geometry.meanEdge, kSteps);
  }
  Curve curve(surface, options, polygon);
  Array<int64_t> counts;
  for (int i = 0; i < path.count(); ++i) {
    const int64_t before = allocationsSoFar();
    if (options.levels == 0) {
      curve.movePoint(kDragged, path[i]);
    } else {
      curve.edit([&](CurveValue& value) {
        dragIn(value, kDragged, path[i], curve.legs());
        // As the page does: a drag shows drafts, and keeps the most levels that it ever had.
        value.options.levelsTolerance = kInfinity;
        value.options.leastLevels = curve.levels();
      });
    }
    const int64_t count = allocationsSoFar() - before;
    if (i >= kWarmUp && (!bridgedOnly || bridgesOf(curve) > 0)) counts.push_back(count);
  }
  return counts;
}

/// Half of the steps take memory `half` times at most, nine of ten `nine` times. The others come to
/// ground, to levels or to bridges as no step of the drag had before.
void expectFew(Array<int64_t> counts, int64_t half, int64_t nine, const std::string& name) {
  std::sort(counts.begin(), counts.end());
  EXPECT_LE(counts[counts.count() / 2], half) << name << ", the most " << counts.back();
  EXPECT_LE(counts[counts.count() * 9 / 10], nine) << name << ", the most " << counts.back();
}

CurveOptions optionsOf(const CurveShape& shape, int levels) {
  CurveOptions options = ofLevelZero(shape, 128, kFast);
  options.levels = levels;
  return options;
}

void expectMostStepsTake(Surface& surface, const CurveOptions& options, double spacing,
                         int64_t half, int64_t nine) {
  Array<int64_t> counts;
  for (const uint64_t seed : {1u, 2u, 3u}) {
    const Array<int64_t> ofDrag = allocationsOfDrag(surface, options, spacing, seed);
    counts.insert(counts.end(), ofDrag.begin(), ofDrag.end());
  }
  expectFew(
      counts, half, nine,
      curveKindName(options.shape.kind) + std::string(", spacing ") + std::to_string(spacing));
}

void expectMostStepsTakeNone(Surface& surface, const CurveOptions& options, double spacing) {
  expectMostStepsTake(surface, options, spacing, 0, 8);
}

void expectMostStepsTakeNone(Surface& surface, const CurveShape& shape, int levels,
                             double spacing) {
  expectMostStepsTakeNone(surface, optionsOf(shape, levels), spacing);
}

TEST(DragMemory, IsCounted) {
  const int64_t before = allocationsSoFar();
  void* const memory = ::operator new(16);
  EXPECT_EQ(allocationsSoFar() - before, 1);
  ::operator delete(memory);
}

/// Of default curves. A step whose values are not all by sight takes memory for the paths that are
/// searched.
void expectMostStepsTakeLittle(Surface& surface, double spacing) {
  expectMostStepsTake(surface, optionsOf({CurveKind::kBezier}, kAutomaticLevels), spacing, 2, 40);
}

TEST(DragMemory, IsThatOfTheStepsBefore) {
  Surface torus(meshOf(makeShape(Shape::kTorus, 20000)));
  Surface bunny(bunnyMesh());
  const CurveShape bezier{CurveKind::kBezier};
  const double spacings[] = {0.1, 0.05, 0.2, 0.3};
  for (const double spacing : casesOf(spacings, 1)) {
    expectMostStepsTakeLittle(torus, spacing);
  }
  for (const double spacing : casesOf(spacings, 1)) {
    if (spacing < 0.3) expectMostStepsTakeLittle(bunny, spacing);
  }
  expectMostStepsTakeNone(torus, bezier, 0, 0.1);
  CurveShape spline{CurveKind::kBSpline};
  expectMostStepsTakeNone(torus, spline, 2, 0.1);
  spline.closed = true;
  spline.degree = 2;
  spline.weights = {1, 2, 3, 1};
  expectMostStepsTakeNone(bunny, spline, 2, 0.1);
  CurveShape through{CurveKind::kCatmullRom};
  expectMostStepsTakeNone(torus, through, 2, 0.1);
  through.closed = true;
  expectMostStepsTakeNone(bunny, through, 2, 0.1);
}

TEST(DragMemory, OfCrossingsAndOfAToleranceIsThatOfTheStepsBefore) {
  Surface torus(meshOf(makeShape(Shape::kTorus, 5000)));
  Surface bunny(bunnyMesh());
  for (const int levels : {0, 2}) {
    CurveOptions exact = optionsOf({CurveKind::kBSpline}, levels);
    exact.geometry = CurveGeometry::kExact;
    expectMostStepsTakeNone(torus, exact, 0.1);
    expectMostStepsTakeNone(bunny, exact, 0.1);
    CurveOptions adaptive = optionsOf({CurveKind::kBezier}, levels);
    adaptive.tolerance = 1e-3;
    expectMostStepsTakeNone(torus, adaptive, 0.1);
    expectMostStepsTakeNone(bunny, adaptive, 0.1);
  }
}

TEST(DragMemory, OfBridgesIsThatOfTheStepsBefore) {
  Surface bunny(bunnyMesh());
  CurveShape closed{CurveKind::kBSpline};
  closed.closed = true;
  closed.weights = {1, 2, 3, 1};
  const CurveShape shapes[] = {closed, CurveShape{CurveKind::kBezier},
                               CurveShape{CurveKind::kBSpline}, CurveShape{CurveKind::kCatmullRom}};
  for (const CurveShape& shape : casesOf(shapes, 1)) {
    Array<int64_t> counts;
    for (const uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
      for (const double spacing : {0.2, 0.3}) {
        const Array<int64_t> ofDrag =
            allocationsOfDrag(bunny, optionsOf(shape, 0), spacing, seed, true);
        counts.insert(counts.end(), ofDrag.begin(), ofDrag.end());
      }
    }
    // Of so many steps with bridges.
    ASSERT_GT(counts.count(), 100) << curveKindName(shape.kind);
    // A bucket of the queue may hold more than at any step before. Without memory that is kept a
    // step would take some 500, with knots that follow the points
    // some 30,000.
    expectFew(counts, 1, 35, curveKindName(shape.kind));
  }
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
    const auto fail = [&](CurveValue& value) {
      placePoint(value, kDragged, elsewhere);
      throw std::runtime_error("in the middle of an edit");
    };
    EXPECT_THROW(curve.edit(fail), std::runtime_error);
    EXPECT_EQ(codeOf([&] { curve.edit([](CurveValue& value) { value.options.samples = 1; }); }),
              ErrorCode::kBadArgument);
    const Curve anew(surface, curve.value());
    ASSERT_EQ(curve.path(0).line.points.count(), line.count());
    for (int i = 0; i < line.count(); ++i) {
      EXPECT_EQ(curve.path(0).line.points[i].bary, line[i].bary);
      EXPECT_EQ(anew.path(0).line.points[i].bary, line[i].bary);
    }
    curve.dragPoint(kDragged, nearestPoint(surface.mesh(), {3.0 + 0.3 * step, 6, 0}));
  }
}

TEST(DragMemory, OfAPlacedPointAreTheLegsOfOthers) {
  Surface surface(planeGrid(8, 8));
  const Array<SurfacePoint> points =
      pointsNear(surface.mesh(), {{1, 1, 0}, {3, 6, 0}, {5, 2, 0}, {7, 7, 0}});
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, 17, kFast);
  options.levels = 1;
  options.shape.closed = true;
  Curve curve(surface, options, points);
  CurveValue value{options, points, curve.legs()};
  placePoint(value, 0, points[0]);
  for (const SurfacePath& leg : value.legs) EXPECT_FALSE(leg.points.empty());
  placePoint(value, 0, nearestPoint(surface.mesh(), {1, 2, 0}));
  ASSERT_EQ(value.legs.count(), 4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(value.legs[i].points.empty(), i == 0 || i == 3) << i;
  EXPECT_EQ(codeOf([&] { placePoint(value, 4, points[0]); }), ErrorCode::kBadIndex);
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

TEST(PagedArray, GivesBackWhatNoArrayHolds) {
  constexpr int kCount = 4000;
  const auto pool = std::make_shared<PagePool>();
  PagedArray<double, 4> held(kCount, pool);
  PagedArray<double, 4> other(kCount, pool);
  const auto fill = [](PagedArray<double, 4>& array, int step) {
    const int64_t before = allocationsSoFar();
    for (int i = 0; i < kCount; i += step) array.touch(i) = i;
    return allocationsSoFar() - before;
  };
  // Many pages are made in few blocks.
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

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/torus.h"
#include "measures/gauss_bonnet.h"
#include "mesh/shapes.h"
#include "regions/region.h"
#include "support.h"

/// Cells and regions against closed forms and clipped polygons; region_fuzz_test.cpp has random
/// ones.
namespace karcher {
namespace {

constexpr PathRange kFirst{0, 1};
constexpr PathRange kSecond{1, 1};

Array<Vec2> rectangle(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

double polygonArea(const Array<Vec2>& polygon) {
  double twice = 0;
  for (int i = 0; i < polygon.count(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.count()]);
  }
  return twice / 2;
}

/// The part of a convex, counterclockwise polygon inside another (I. Sutherland, G. Hodgman, 1974).
Array<Vec2> clipped(Array<Vec2> polygon, const Array<Vec2>& by) {
  for (int i = 0; i < by.count(); ++i) {
    const Vec2 a = by[i];
    const Vec2 way = by[(i + 1) % by.count()] - a;
    Array<Vec2> kept;
    for (int k = 0; k < polygon.count(); ++k) {
      const Vec2 p = polygon[k];
      const Vec2 q = polygon[(k + 1) % polygon.count()];
      const double inP = cross(way, p - a);
      const double inQ = cross(way, q - a);
      if (inP >= 0) kept.push_back(p);
      if ((inP > 0 && inQ < 0) || (inP < 0 && inQ > 0)) {
        kept.push_back(p + inP / (inP - inQ) * (q - p));
      }
    }
    polygon = std::move(kept);
  }
  return polygon;
}

double perimeter(const Geometry& geometry, const Arrangement& arrangement, const Region& region) {
  double length = 0;
  for (const Array<int>& loop : boundaryOf(arrangement, region)) {
    length += pathOf(geometry, arrangement, loop).length();
  }
  return length;
}

/// Checks the invariants of arrangements.
void expectSound(const Geometry& geometry, const Arrangement& all) {
  const double whole = surfaceArea(geometry);
  double sum = 0;
  for (const double area : all.cellArea) {
    EXPECT_GE(area, -1e-13 * whole);
    sum += area;
  }
  EXPECT_NEAR(sum, whole, 1e-10 * whole);
  for (int h = 0; h < all.halfedgeCount(); ++h) {
    ASSERT_EQ(all.piece[h], all.piece[all.next[h]]);
    const int twin = all.twin[h];
    if (twin < 0) continue;
    ASSERT_EQ(all.twin[twin], h);
    ASSERT_EQ(all.tail[twin], all.head(h));
    ASSERT_EQ(all.tail[h], all.head(twin));
  }
}

void expectGaussBonnet(const Geometry& geometry, const Arrangement& all, const Region& region) {
  const GaussBonnet both = gaussBonnet(geometry, all, region);
  EXPECT_NEAR(both.curvature, 2 * kPi * both.euler, 1e-9);
}

void expectAreas(const Geometry& geometry, const Arrangement& all, double a, double b, double both,
                 double rounding) {
  const Region first = enclosed(all, kFirst, FillRule::kEvenOdd);
  const Region second = enclosed(all, kSecond, FillRule::kNonZero);
  const auto area = [&](Boolean how) { return areaOf(all, combined(first, second, how)); };
  EXPECT_NEAR(areaOf(all, first), a, rounding);
  EXPECT_NEAR(areaOf(all, second), b, rounding);
  EXPECT_NEAR(area(Boolean::kIntersection), both, rounding);
  EXPECT_NEAR(area(Boolean::kUnion), a + b - both, rounding);
  EXPECT_NEAR(area(Boolean::kDifference), a - both, rounding);
  EXPECT_NEAR(area(Boolean::kExclusion), a + b - 2 * both, rounding);
  for (const Boolean how :
       {Boolean::kUnion, Boolean::kIntersection, Boolean::kDifference, Boolean::kExclusion}) {
    expectGaussBonnet(geometry, all, combined(first, second, how));
  }
}

TEST(Regions, OfTwoSquares) {
  const Sheet sheet(planeGrid(12, 12));
  const auto check = [&](const Array<Vec2>& a, const Array<Vec2>& b, double both, int cells) {
    const SurfacePath paths[] = {polygonOn(sheet.geometry, a), polygonOn(sheet.geometry, b)};
    const Arrangement all = arrange(sheet.geometry, paths);
    expectSound(sheet.geometry, all);
    EXPECT_EQ(all.cellCount(), cells);
    expectAreas(sheet.geometry, all, polygonArea(a), polygonArea(b), both, 1e-9);
  };
  {
    SCOPED_TRACE("crossing");
    check(rectangle(1.3, 1.2, 4.8, 4.1), rectangle(3.1, 2.2, 7.3, 6.4), 1.7 * 1.9, 4);
  }
  {
    SCOPED_TRACE("along edges of the mesh");
    check(rectangle(1, 1, 5, 5), rectangle(3, 2, 7, 8), 2 * 3, 4);
  }
  {
    SCOPED_TRACE("side by side, along edges of the mesh");
    check(rectangle(1, 1, 4, 4), rectangle(4, 2, 6, 7), 0, 3);
  }
  {
    SCOPED_TRACE("side by side, inside faces");
    check(rectangle(1.3, 1.2, 4.4, 4.1), rectangle(4.4, 2.3, 6.1, 6.7), 0, 3);
  }
  {
    SCOPED_TRACE("touching at a corner");
    check(rectangle(1.3, 1.2, 4.4, 4.1), rectangle(4.4, 4.1, 6.1, 6.7), 0, 3);
  }
  {
    SCOPED_TRACE("touching at a vertex");
    check(rectangle(1, 1, 4, 4), rectangle(4, 4, 6, 6), 0, 3);
  }
  {
    SCOPED_TRACE("the same");
    check(rectangle(1.3, 1.2, 4.4, 4.1), rectangle(1.3, 1.2, 4.4, 4.1), 3.1 * 2.9, 2);
  }
  {
    SCOPED_TRACE("inside, in one face");
    check(rectangle(1.3, 1.2, 4.4, 4.1), rectangle(2.5, 2.1, 2.7, 2.3), 0.04, 3);
  }
  {
    SCOPED_TRACE("both in one face");
    check(rectangle(2.5, 2.1, 2.7, 2.3), rectangle(2.6, 2.2, 2.75, 2.4), 0.01, 4);
  }
  {
    SCOPED_TRACE("one within the other, in one face");
    check(rectangle(2.4, 2.1, 2.8, 2.3), rectangle(2.5, 2.15, 2.7, 2.2), 0.01, 3);
  }
  {
    SCOPED_TRACE("apart in one face");
    check(rectangle(2.4, 2.1, 2.5, 2.3), rectangle(2.6, 2.1, 2.8, 2.2), 0, 3);
  }
  {
    SCOPED_TRACE("along the boundary of the mesh");
    check(rectangle(0, 0, 4, 4), rectangle(0, 2, 3, 7), 3 * 2, 4);
  }
}

TEST(Regions, OfNearlyOneLineAreOne) {
  const Sheet sheet(planeGrid(8, 8));
  const uint64_t seed = 4;
  SCOPED_TRACE(seed);
  Random random(seed);
  const Array<Vec2> square = rectangle(1.3, 1.2, 4.4, 4.1);
  for (const double noise : {1e-15, 1e-13, 1e-12}) {
    Array<Vec2> moved = square;
    for (Vec2& p : moved) p += noise * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
    const SurfacePath paths[] = {polygonOn(sheet.geometry, square),
                                 polygonOn(sheet.geometry, moved)};
    const Arrangement all = arrange(sheet.geometry, paths);
    expectSound(sheet.geometry, all);
    EXPECT_EQ(all.cellCount(), 2) << noise;
  }
}

TEST(Regions, OfConvexPolygonsAreTheirClippings) {
  const int rounds = longRun() ? 400 : 12;
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    const Sheet sheet(meshOf(tessellatedPlane(tessellation, 400, 5)));
    for (int round = 0; round < rounds; ++round) {
      const uint64_t seed = 100 + static_cast<uint64_t>(round);
      SCOPED_TRACE(std::string(tessellationName(tessellation)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const bool onLattice = round % 3 == 0;
      const bool sheared = tessellation == PlaneTessellation::kStretchedSheared;
      const auto polygon = [&] {
        const Vec2 middle(random.uniform(0.35, 0.65), random.uniform(0.35, 0.65));
        const int count = onLattice ? 4 : 3 + random.index(5);
        const double turn = onLattice ? kPi / 4 : random.uniform(0, 2 * kPi);
        const double size = random.uniform(0.05, 0.25);
        Array<Vec2> corners;
        for (int i = 0; i < count; ++i) {
          Vec2 corner = middle + size * unitVector(turn + 2 * kPi * i / count);
          if (onLattice) corner = (corner * 20).array().round() / 20;
          if (sheared) corner.x() += corner.y();
          corners.push_back(corner);
        }
        return corners;
      };
      const Array<Vec2> a = polygon();
      const Array<Vec2> b = polygon();
      if (polygonArea(a) < 1e-4 || polygonArea(b) < 1e-4) continue;
      const SurfacePath paths[] = {polygonOn(sheet.geometry, a), polygonOn(sheet.geometry, b)};
      const Arrangement all = arrange(sheet.geometry, paths);
      expectSound(sheet.geometry, all);
      expectAreas(sheet.geometry, all, polygonArea(a), polygonArea(b), polygonArea(clipped(a, b)),
                  1e-9);
    }
  }
}

TEST(Regions, HaveTheirPolygonsAsBoundaries) {
  const Sheet sheet(planeGrid(8, 8));
  const SurfacePath paths[] = {polygonOn(sheet.geometry, rectangle(1.3, 1.2, 6.4, 5.1)),
                               polygonOn(sheet.geometry, rectangle(2.1, 2.2, 4.3, 3.4))};
  const Arrangement all = arrange(sheet.geometry, paths);
  const Region ring = enclosed(all, {0, 2}, FillRule::kEvenOdd);
  EXPECT_NEAR(areaOf(all, ring), 5.1 * 3.9 - 2.2 * 1.2, 1e-9) << "both wind alike: a hole";
  EXPECT_NEAR(perimeter(sheet.geometry, all, ring), 2 * (5.1 + 3.9 + 2.2 + 1.2), 1e-9);
  EXPECT_EQ(gaussBonnet(sheet.geometry, all, ring).euler, 0);
  const Region full = enclosed(all, {0, 2}, FillRule::kNonZero);
  EXPECT_NEAR(areaOf(all, full), 5.1 * 3.9, 1e-9) << "wound round twice, and no hole";
  const auto loops = boundaryOf(all, ring);
  ASSERT_EQ(loops.size(), 2U);
  for (const Array<int>& loop : loops) {
    const SurfacePath path = pathOf(sheet.geometry, all, loop);
    EXPECT_TRUE(samePlace(sheet.mesh, path.start(), path.end()));
    EXPECT_NEAR(pathThrough(sheet.mesh, path.points).length(), path.length(), 1e-9);
  }
  const SurfacePath turned[] = {paths[0], reversed(paths[1])};
  const Arrangement other = arrange(sheet.geometry, turned);
  EXPECT_NEAR(areaOf(other, enclosed(other, {0, 2}, FillRule::kNonZero)), 5.1 * 3.9 - 2.2 * 1.2,
              1e-9)
      << "they wind against each other";
}

TEST(Regions, AreTheSmallerSideOrThatOfAPoint) {
  const Sheet sheet(planeGrid(8, 8));
  const SurfacePath paths[] = {polygonOn(sheet.geometry, rectangle(0.5, 0.5, 7.5, 7.5)),
                               polygonOn(sheet.geometry, {{3.3, 0}, {2.6, 8}}, false)};
  const Arrangement all = arrange(sheet.geometry, paths);
  const auto cellOf = [&](double x, double y) {
    return all.cellOfPiece[pieceHolding(sheet.mesh, all, nearestPoint(sheet.mesh, {x, y, 0}))];
  };
  EXPECT_NEAR(areaOf(all, enclosed(all, kFirst, FillRule::kEvenOdd)), 15, 1e-9);
  for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
    EXPECT_NEAR(areaOf(all, enclosed(all, kFirst, rule, cellOf(4.1, 4.2))), 49, 1e-9);
    EXPECT_NEAR(areaOf(all, enclosed(all, kFirst, rule, cellOf(0.1, 4.2))), 15, 1e-9);
    // The path runs from rim to rim.
    EXPECT_NEAR(areaOf(all, enclosed(all, kSecond, rule)), 8 * (3.3 + 2.6) / 2, 1e-9);
    EXPECT_NEAR(areaOf(all, enclosed(all, kSecond, rule, cellOf(7, 4))), 8 * (4.7 + 5.4) / 2, 1e-9);
  }
}

TEST(Regions, OfTwoEqualSidesAreTheLeftOneInAnyNumberingOfFaces) {
  const TriangleMesh grid = planeGrid(4, 4);
  const Array<Triangle> reversed(grid.faces.rbegin(), grid.faces.rend());
  for (const Array<Triangle>& faces : {grid.faces, reversed}) {
    const Sheet sheet(buildMesh(grid.positions, faces));
    for (const double from : {0, 4}) {
      const SurfacePath path = polygonOn(sheet.geometry, {{2, from}, {2, 4 - from}}, false);
      const Arrangement all = arrange(sheet.geometry, std::span(&path, 1));
      for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
        EXPECT_EQ(enclosed(all, kFirst, rule), enclosedBeside(all, kFirst, rule, PathSide::kLeft))
            << "from " << from;
      }
    }
  }
}

TEST(Regions, StayOnTheSideOfAMovingCurve) {
  const Sheet sphere(meshOf(makeShape(Shape::kSphere, 2000)));
  const double whole = surfaceArea(sphere.geometry);
  const auto parallel = [&](double height) {
    Array<SurfacePoint> points;
    for (int i = 0; i < 24; ++i) {
      const Vec2 p = std::sqrt(1 - height * height) * unitVector(2 * kPi * (i + 0.3) / 24);
      points.push_back(nearestPoint(sphere.mesh, {p.x(), p.y(), height}));
    }
    return chain(sphere.geometry, points, true);
  };
  for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
    for (double height = 0.9; height > -0.95; height -= 0.2) {
      const SurfacePath path = parallel(height);
      const Arrangement all = arrange(sphere.geometry, std::span(&path, 1));
      const double left = areaOf(all, enclosedBeside(all, kFirst, rule, PathSide::kLeft));
      EXPECT_NEAR(left, 2 * kPi * (1 - height), 0.02 * whole) << "north of it, at " << height;
      const double right = areaOf(all, enclosedBeside(all, kFirst, rule, PathSide::kRight));
      EXPECT_NEAR(left + right, whole, 1e-9);
    }
  }
  const Sheet sheet(planeGrid(8, 8));
  for (const double x : {0.5, 2.0, 4.0, 6.3, 7.9}) {
    const SurfacePath path = polygonOn(sheet.geometry, {{x, 0}, {x, 8}}, false);
    const Arrangement all = arrange(sheet.geometry, std::span(&path, 1));
    const Region left = enclosedBeside(all, kFirst, FillRule::kEvenOdd, PathSide::kLeft);
    EXPECT_NEAR(areaOf(all, left), 8 * x, 1e-9) << "from rim to rim";
  }
}

/// The first side of an outline is cut by later sides. It ends at a vertex of the mesh, and in some
/// rounds runs along an edge.
TEST(Regions, LieOnASideOfTheirOutlinesFirstPlace) {
  const Sheet square(planeGrid(1, 1));
  const SurfacePath fish = polygonOn(square.geometry, {{.4, .2}, {1, 0}, {.95, .3}, {.4, .05}});
  const Arrangement both = arrange(square.geometry, std::span(&fish, 1));
  // The first and third side meet at (307, 71) / 520, so that the loops have the areas 1207 / 20800
  // and 297 / 20800.
  const auto area = [&](PathSide side) {
    return areaOf(both, enclosedBeside(both, kFirst, FillRule::kEvenOdd, side));
  };
  EXPECT_NEAR(area(PathSide::kLeft), 603.0 / 650, 1e-9);
  EXPECT_NEAR(area(PathSide::kRight), 47.0 / 650, 1e-9);

  const Sheet sheet(planeGrid(3, 3));
  for (uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto place = [&] { return Vec2(random.uniform(0, 3), random.uniform(0, 3)); };
    const Vec2 end(1 + random.index(2), 1 + random.index(2));
    const double along = random.uniform(-.9, .9);
    const Vec2 start = random.index(2) == 0 ? place() : Vec2(end + Vec2(along, 0));
    const SurfacePath path =
        polygonOn(sheet.geometry, {start, end, place(), place(), place(), place(), place()});
    const Arrangement all = arrange(sheet.geometry, std::span(&path, 1));
    const Vec2 way = 1e-4 * (end - start);
    for (const PathSide side : {PathSide::kLeft, PathSide::kRight}) {
      const double across = side == PathSide::kLeft ? 1e-4 : -1e-4;
      const Vec2 beside = start + way + across * Vec2(-way.y(), way.x());
      const int piece =
          pieceHolding(sheet.mesh, all, nearestPoint(sheet.mesh, {beside.x(), beside.y(), 0}));
      EXPECT_EQ(cellBeside(all, kFirst, FillRule::kEvenOdd, side), all.cellOfPiece[piece]);
    }
  }
}

/// A square that starts along the boundary, and one that is the whole boundary.
TEST(Regions, OnASideOfTheBoundaryAreTheFacesOfThatSide) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePath paths[] = {polygonOn(sheet.geometry, rectangle(0, 0, 2, 2)),
                               polygonOn(sheet.geometry, rectangle(0, 0, 4, 4))};
  const Arrangement all = arrange(sheet.geometry, paths);
  const auto area = [&](const PathRange& path, PathSide side) {
    return areaOf(all, enclosedBeside(all, path, FillRule::kEvenOdd, side));
  };
  EXPECT_NEAR(area(kFirst, PathSide::kLeft), 4, 1e-12);
  EXPECT_NEAR(area(kFirst, PathSide::kRight), 12, 1e-12);
  EXPECT_NEAR(area(kSecond, PathSide::kLeft), 16, 1e-12);
  EXPECT_EQ(area(kSecond, PathSide::kRight), 0) << "beyond the boundary there is nothing";
}

/// The other side of the boundary is empty, and the smaller one.
TEST(Regions, OfTheWholeBoundaryAreTheWholeSurfaceOrEmpty) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePath path = polygonOn(sheet.geometry, rectangle(0, 0, 4, 4));
  const Arrangement all = arrange(sheet.geometry, std::span(&path, 1));
  ASSERT_EQ(all.cellCount(), 1);
  for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
    EXPECT_EQ(areaOf(all, enclosed(all, kFirst, rule)), 0);
    EXPECT_NEAR(areaOf(all, enclosed(all, kFirst, rule, 0)), 16, 1e-12);
  }
}

TEST(Regions, AreRefusedForCurvesThatDoNotBound) {
  const Sheet torus(meshOf(makeShape(Shape::kTorus, 2000)));
  const auto round = [&](double longitude) {
    Array<SurfacePoint> points;
    for (const double y : {0.05, 0.3, 0.55, 0.8}) {
      points.push_back(nearestPoint(torus.mesh, conformalTorus({longitude, y * kTorusPeriod})));
    }
    return chain(torus.geometry, points, true);
  };
  const SurfacePath paths[] = {round(0.3), round(1.4), reversed(round(2.1))};
  const Arrangement all = arrange(torus.geometry, paths);
  expectSound(torus.geometry, all);
  EXPECT_EQ(all.cellCount(), 3);
  for (const FillRule rule : {FillRule::kEvenOdd, FillRule::kNonZero}) {
    EXPECT_EQ(codeOf([&] { enclosed(all, kFirst, rule); }), ErrorCode::kBadArgument);
    EXPECT_EQ(codeOf([&] { enclosed(all, {0, 3}, rule); }), ErrorCode::kBadArgument);
    // For two paths around the handle in opposite directions one side is left of both.
    const Region tube = enclosed(all, {1, 2}, rule);
    EXPECT_NEAR(areaOf(all, tube), surfaceArea(torus.geometry) * 0.7 / (2 * kPi), 0.2);
    EXPECT_EQ(gaussBonnet(torus.geometry, all, tube).euler, 0);
    expectGaussBonnet(torus.geometry, all, tube);
  }
  EXPECT_EQ(codeOf([&] { enclosed(all, {0, 2}, FillRule::kNonZero); }), ErrorCode::kBadArgument);
  EXPECT_NO_THROW(enclosed(all, {0, 2}, FillRule::kEvenOdd)) << "by parity they bound";

  const Sheet sheet(planeGrid(8, 8));
  const SurfacePath open[] = {polygonOn(sheet.geometry, {{3.3, 0}, {2.6, 5}}, false)};
  const Arrangement cut = arrange(sheet.geometry, open);
  EXPECT_EQ(cut.cellCount(), 1);
  EXPECT_EQ(codeOf([&] { enclosed(cut, kFirst, FillRule::kEvenOdd); }), ErrorCode::kBadArgument);
}

TEST(Regions, OfPathsThatLeaveTheirFacesAreRefused) {
  const Sheet sheet(planeGrid(3, 3));
  SurfacePath path;
  path.points = {{0, Vec3(0.2, 0.3, 0.5)}, {17, Vec3(0.2, 0.3, 0.5)}};
  path.lengths = {0, 1};
  EXPECT_EQ(codeOf([&] { arrange(sheet.geometry, std::span(&path, 1)); }), ErrorCode::kBadArgument);
}

/// Lines through few places, whose distances are about the one at which points are merged.
TEST(Regions, OfCrowdedLinesFit) {
  const Sheet sheet(planeGrid(1, 1));
  const int rounds = longRun() ? 3000 : 60;
  for (int round = 0; round < rounds; ++round) {
    const uint64_t seed = 1 + static_cast<uint64_t>(round);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double spread = kTogether * std::pow(10, random.uniform(-2, 2));
    Array<Vec2> places;
    for (int i = 0; i < 4; ++i) {
      const bool onSide = random.index(4) == 0;
      places.push_back({onSide ? 0 : random.uniform(), random.uniform()});
    }
    Array<SurfacePath> paths;
    for (int i = 0; i < 12; ++i) {
      Array<SurfacePoint> points;
      for (int k = 0; k < 4; ++k) {
        Vec2 p = places[random.index(4)];
        p += spread * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
        p = p.cwiseMax(0).cwiseMin(1);
        // The mesh's two triangles meet along x = y.
        const bool isLower = p.x() > p.y();
        points.push_back(nearestPoint(sheet.mesh, {isLower ? p.x() : p.y(), p.y(), 0}));
      }
      paths.push_back(chain(sheet.geometry, points, true));
    }
    const Arrangement all = arrange(sheet.geometry, paths);
    expectSound(sheet.geometry, all);
    for (int c = 0; c < all.cellCount(); c += 1 + all.cellCount() / 20) {
      Region one(static_cast<size_t>(all.cellCount()), 0);
      one[c] = 1;
      expectGaussBonnet(sheet.geometry, all, one);
    }
    for (int i = 0; i < paths.count(); ++i) {
      EXPECT_NO_THROW(enclosed(all, {i, 1}, FillRule::kNonZero));
    }
  }
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cases.h"
#include "curves/offset.h"
#include "distance/path_distance.h"
#include "distance/window_distance.h"
#include "generators/flat.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/sphere.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "support.h"

/// Offsets of several distances: the border of all disks round places of a path.
namespace karcher {
namespace {

/// The distance at a part of a path's length.
double distanceAt(const Array<double>& distances, bool closed, double part) {
  const int count = distances.count();
  const int parts = closed ? count : count - 1;
  const int k = std::min(static_cast<int>(part * parts), parts - 1);
  return std::lerp(distances[k], distances[(k + 1) % count], part * parts - k);
}

/// The least value of a convex function on an interval.
template <class Function>
double leastOf(double low, double high, const Function& function) {
  for (int i = 0; i < 200; ++i) {
    const double third = (high - low) / 3;
    (function(low + third) < function(high - third) ? high : low) +=
        function(low + third) < function(high - third) ? -third : third;
  }
  return std::min({function(low), function(high), function((low + high) / 2)});
}

/// The distance by which a place of the plane is outside of all disks round places of a path. The
/// search goes along each stretch between corners and bends of the distance, where that is convex.
double outside(const Vec2& place, const Array<Vec2>& corners, bool closed,
               const Array<double>& distances) {
  Array<Vec2> points = corners;
  if (closed) points.push_back(corners[0]);
  Array<double> lengths{0};
  for (int i = 1; i < points.count(); ++i) {
    lengths.push_back(lengths.back() + (points[i] - points[i - 1]).norm());
  }
  const double total = lengths.back();
  Array<double> stops = lengths;
  const int parts = closed ? distances.count() : distances.count() - 1;
  for (int k = 1; k < parts; ++k) stops.push_back(total * k / parts);
  std::sort(stops.begin(), stops.end());
  double least = kInfinity;
  for (int i = 1; i < stops.count(); ++i) {
    const double middle = (stops[i - 1] + stops[i]) / 2;
    int piece = 1;
    while (piece + 1 < lengths.count() && lengths[piece] < middle) ++piece;
    const auto value = [&](double length) {
      const double part = (length - lengths[piece - 1]) / (lengths[piece] - lengths[piece - 1]);
      const Vec2 on = points[piece - 1] + part * (points[piece] - points[piece - 1]);
      return (place - on).norm() - distanceAt(distances, closed, std::min(length / total, 1.0));
    };
    least = std::min(least, leastOf(stops[i - 1], stops[i], value));
  }
  return least;
}

Vec2 flat(const TriangleMesh& mesh, const SurfacePoint& point) {
  return position(mesh, point).head<2>();
}

void expectOnTheBorder(const TriangleMesh& mesh, const Array<Isoline>& lines,
                       const std::function<double(const SurfacePoint&)>& off, double tolerance) {
  double worst = 0;
  for (const Isoline& line : lines) {
    for (int i = 1; i < line.points.count(); ++i) {
      ASSERT_TRUE(haveCommonFace(mesh, line.points[i - 1], line.points[i]));
      for (const double part : {0.25, 0.5, 0.75, 1.0}) {
        const SurfacePoint at = pointBetween(mesh, line.points[i - 1], line.points[i], part);
        worst = std::max(worst, std::abs(off(at)));
      }
    }
  }
  EXPECT_LT(worst, tolerance);
}

TEST(VariableOffset, TheDistanceOnThePlaneIsThatFromTheDisks) {
  const Sheet sheet(planeGrid(12, 10));
  for (uint64_t seed = 1; seed <= (longRun() ? 200 : 24); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Array<Vec2> corners;
    for (int i = 0; i < 5; ++i) corners.emplace_back(random.uniform(1, 11), random.uniform(1, 9));
    // Paths go through vertices and along edges, too.
    if (seed % 2 == 0) {
      for (Vec2& corner : corners) corner = corner.array().round();
    }
    for (int i = 1; i < corners.count(); ++i) {
      if (corners[i] == corners[i - 1]) corners[i].x() += corners[i].x() < 6 ? 1 : -1;
    }
    const bool closed = seed % 3 == 0 && corners.front() != corners.back();
    // Some distances differ so much that disks hold others.
    Array<double> distances;
    const int count = 2 + random.index(5);
    for (int i = 0; i < count; ++i) distances.push_back(random.uniform(0, seed % 4 == 0 ? 9 : 2));
    const double greatest = *std::max_element(distances.begin(), distances.end());
    const SurfacePath path = polygonOn(sheet.geometry, corners, closed);
    const PathDistance field(sheet.geometry, {&path, 1}, kInfinity, distances);
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint point = randomPlace(sheet.mesh, random);
      const double expected =
          greatest + outside(flat(sheet.mesh, point), corners, closed, distances);
      EXPECT_NEAR(field.at(point).value, expected, 1e-8);
    }
    for (int v = 0; v < sheet.mesh.vertexCount(); ++v) {
      const Vec2 place = sheet.mesh.positions[v].head<2>();
      EXPECT_NEAR(field.atVertex(v), greatest + outside(place, corners, closed, distances), 1e-8);
    }
  }
}

TEST(VariableOffset, OfASegmentIsTheTangentsOfTheDisksAtItsEnds) {
  const Sheet sheet(planeGrid(12, 10));
  const Array<Vec2> corners{{3.2, 4.1}, {8.3, 5.2}};
  const SurfacePath path = polygonOn(sheet.geometry, corners, false);
  const double length = path.length();
  const double pairs[][2] = {{1.5, 0.5}, {0.4, 1.9}, {0.7, 0.7}, {2, 0.1}};
  for (const auto& ends : pairs) {
    const double tilt = std::asin((ends[0] - ends[1]) / length);
    const double tangent = length * std::cos(tilt);
    for (const OffsetSide side : {OffsetSide::kLeft, OffsetSide::kRight}) {
      const auto lines = offsetLines(sheet.geometry, {&path, 1}, ends, side);
      ASSERT_EQ(lines.count(), 1);
      EXPECT_FALSE(lines[0].closed);
      EXPECT_NEAR(lines[0].length, tangent, 1e-6);
    }
    const auto both = offsetLines(sheet.geometry, {&path, 1}, ends, OffsetSide::kBoth);
    ASSERT_EQ(both.count(), 1);
    EXPECT_TRUE(both[0].closed);
    const double arcs = (kPi + 2 * tilt) * ends[0] + (kPi - 2 * tilt) * ends[1];
    EXPECT_NEAR(both[0].length, 2 * tangent + arcs, 1e-3 * arcs);
    expectOnTheBorder(
        sheet.mesh, both,
        [&](const SurfacePoint& point) {
          return outside(flat(sheet.mesh, point), corners, false, {ends[0], ends[1]});
        },
        1e-3 * std::max(std::min(ends[0], ends[1]), kNarrowestOffset * 2));
  }
}

TEST(VariableOffset, ADiskThatContainsTheOthersIsTheOffset) {
  const Sheet sheet(planeGrid(12, 10));
  const SurfacePath path = polygonOn(sheet.geometry, {{5, 5}, {6.5, 5.3}}, false);
  const double ends[] = {3.5, 0.2};
  const auto lines = offsetLines(sheet.geometry, {&path, 1}, ends, OffsetSide::kBoth);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_NEAR(lines[0].length, 2 * kPi * 3.5, 1e-3 * 2 * kPi * 3.5);
}

TEST(VariableOffset, MayEndInAPoint) {
  const Sheet sheet(planeGrid(12, 10));
  const Array<Vec2> corners{{2.2, 4.1}, {6.1, 4.9}, {10.3, 5.2}};
  const SurfacePath path = polygonOn(sheet.geometry, corners, false);
  const Array<double> distances{0, 1.2, 0};
  const auto lines = offsetLines(sheet.geometry, {&path, 1}, distances, OffsetSide::kBoth);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_TRUE(lines[0].closed);
  // The test measures chords in their middle. Elsewhere a chord past a sharp tip may be off by
  // twice as much.
  expectOnTheBorder(
      sheet.mesh, lines,
      [&](const SurfacePoint& point) {
        return outside(flat(sheet.mesh, point), corners, false, distances);
      },
      2e-3 * kNarrowestOffset * 1.2);
}

TEST(VariableOffset, OfEqualDistancesIsTheOffsetOfOneDistance) {
  const Sheet sphere(meshOf(randomSphere(2000, 2)));
  Random random(3);
  Array<SurfacePoint> points;
  for (int i = 0; i < 4; ++i) points.push_back(randomPlace(sphere.mesh, random));
  for (const bool closed : {false, true}) {
    const SurfacePath path = chain(sphere.geometry, points, closed);
    const double same[] = {0.2, 0.2, 0.2};
    for (const OffsetSide side : {OffsetSide::kLeft, OffsetSide::kRight, OffsetSide::kBoth}) {
      const auto one = offsetLines(sphere.geometry, {&path, 1}, 0.2, side);
      const auto several = offsetLines(sphere.geometry, {&path, 1}, same, side);
      ASSERT_EQ(one.count(), several.count());
      for (int i = 0; i < one.count(); ++i) EXPECT_NEAR(one[i].length, several[i].length, 1e-9);
    }
  }
}

TEST(VariableOffset, OnACylinderIsThatOfThePlane) {
  const FlatCylinder cylinder = flatCylinder(24, 4, 7);
  const Sheet sheet(meshOf(cylinder.soup));
  Random random(9);
  const auto unrolled = [&](const SurfacePoint& point) {
    // The place is in the frame of one corner, since x jumps somewhere.
    Vec2 place = Vec2::Zero();
    const Vec2 first = cylinder.unrolled[sheet.mesh.corner(point.face, 0)];
    for (int k = 0; k < 3; ++k) {
      Vec2 corner = cylinder.unrolled[sheet.mesh.corner(point.face, k)];
      const double round = cylinder.circumference;
      corner.x() = first.x() + std::remainder(corner.x() - first.x(), round);
      place += point.bary[k] * corner;
    }
    return place;
  };
  const SurfacePath path = chain(
      sheet.geometry, {randomPlace(sheet.mesh, random), randomPlace(sheet.mesh, random)}, false);
  const Vec2 from = unrolled(path.start());
  Vec2 to = unrolled(path.end());
  to.x() = from.x() + std::remainder(to.x() - from.x(), cylinder.circumference);
  ASSERT_NEAR((to - from).norm(), path.length(), 1e-9);
  const Array<double> ends{0.15, 0.15 + 0.5 * path.length()};
  const PathDistance field(sheet.geometry, {&path, 1}, kInfinity, ends);
  for (int i = 0; i < 300; ++i) {
    const SurfacePoint point = randomPlace(sheet.mesh, random);
    double least = kInfinity;
    for (const double round : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
      const Vec2 place = unrolled(point) + Vec2(round * cylinder.circumference, 0);
      least = std::min(least, outside(place, {from, to}, false, ends));
    }
    EXPECT_NEAR(field.at(point).value, ends[1] + least, 1e-8);
  }
}

TEST(VariableOffset, OfAGreatCircleIsTheEnvelopeOfCaps) {
  SKIP_WHERE_SANITIZED();
  const Sheet sphere(meshOf(icosphere(40)));
  Array<SurfacePoint> points;
  for (int i = 0; i < 360; ++i) {
    const double angle = 2 * kPi * i / 360;
    points.push_back(nearestPoint(sphere.mesh, Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  const SurfacePath path = chain(sphere.geometry, points, true);
  const Array<double> distances{0.2, 0.9};
  const auto lines = offsetLines(sphere.geometry, {&path, 1}, distances, OffsetSide::kLeft);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_TRUE(lines[0].closed);
  // Along half of the equator the distance grows by .7. Geodesics to the border leave it at a
  // constant angle, whose cosine is the growth per length, backwards.
  const double growth = 0.7 / kPi;
  const double rise = std::sqrt(1 - growth * growth);
  for (const SurfacePoint& point : lines[0].points) {
    const Vec3 place = position(sphere.mesh, point).normalized();
    double nearest = kInfinity;
    for (int i = 0; i <= 2000; ++i) {
      const double angle = kPi * i / 2000;
      const double r = 0.2 + growth * angle;
      const Vec3 on(std::cos(angle), std::sin(angle), 0);
      const Vec3 back(std::sin(angle), -std::cos(angle), 0);
      const Vec3 border = std::cos(r) * on + std::sin(r) * (rise * Vec3::UnitZ() + growth * back);
      nearest =
          std::min(nearest, (border - Vec3(place.x(), std::abs(place.y()), place.z())).norm());
    }
    // Where the distance is greatest a cap's arc joins both halves.
    const double cap = std::acos(std::clamp(-place.x(), -1.0, 1.0)) - 0.9;
    EXPECT_LT(std::min(nearest, std::abs(cap)), 3e-3);
  }
}

TEST(VariableOffset, TheDistanceOnMeshesIsTheLeastOfThePathsPoints) {
  const char* names[] = {"sphere, random", "plate with 50 holes", "very rough sheet", "torus"};
  Random random(17);
  for (const char* name : casesOf(names, 2)) {
    const Sheet surface(galleryMesh(name));
    const TriangleMesh& mesh = surface.mesh;
    Array<SurfacePoint> points;
    for (int i = 0; i < 3; ++i) points.push_back(randomPlace(mesh, random));
    const SurfacePath path = chain(surface.geometry, points, false);
    const double length = path.length();
    const Array<double> distances{0.05 * length, 0.2 * length, 0, 0.35 * length};
    const PathDistance field(surface.geometry, {&path, 1}, kInfinity, distances);
    WindowDistance exact(surface.geometry);
    Array<double> least(mesh.positions.size(), kInfinity);
    const double step = length / 150;
    Array<double> samples = path.lengths;
    for (int i = 1; i < 150; ++i) samples.push_back(i * step);
    for (const double at : samples) {
      exact.setSource(pointAlong(mesh, path, at));
      exact.grow(kInfinity);
      const double lack = 0.35 * length - distanceAt(distances, false, std::min(at / length, 1.0));
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        least[v] = std::min(least[v], exact.distance(v) + lack);
      }
    }
    double nearest = 0;
    double farthest = 0;
    double sum = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double longer = least[v] - field.atVertex(v);
      nearest = std::max(nearest, -longer);
      farthest = std::max(farthest, longer);
      sum += longer;
    }
    // A sample lies within half a step of the best place. Both the way and the distance of the
    // offset change by no more than about twice that.
    const double rounding = 1e-9 * surface.geometry.diagonal;
    EXPECT_LT(nearest, rounding) << name;
    EXPECT_LT(farthest, 1.1 * step) << name;
    EXPECT_LT(sum / mesh.vertexCount(), step / 50) << name;
  }
}

TEST(VariableOffset, OfAClosedPathWhoseLastStepIsRoundingIsThatOfTheClosedPath) {
  const Sheet sheet(planeGrid(12, 10));
  const Array<Vec2> corners{{3, 2.5}, {9.3, 3.2}, {6.2, 8.1}};
  const Array<double> distances{0.3, 1.4, 0.7};
  const SurfacePath path = polygonOn(sheet.geometry, corners, true);
  // The path comes back to its start, which lies on an edge, with a weight that is off by rounding.
  const SurfacePoint last = path.points.back();
  const SurfacePoint before = path.points[path.points.count() - 2];
  const int face = commonFace(sheet.mesh, before, last);
  SurfacePoint twin = inFace(sheet.mesh, last, face);
  int corner = 0;
  ASSERT_EQ(twin.bary.minCoeff(&corner), 0);
  twin.bary[corner] = 1e-15;
  Array<SurfacePoint> points = path.points;
  points.back() = twin;
  points.push_back(last);
  const SurfacePath closed = pathThrough(sheet.mesh, points);
  const PathDistance field(sheet.geometry, {&closed, 1}, kInfinity, distances);
  for (int v = 0; v < sheet.mesh.vertexCount(); ++v) {
    const Vec2 place = sheet.mesh.positions[v].head<2>();
    EXPECT_NEAR(field.atVertex(v), 1.4 + outside(place, corners, true, distances), 1e-8);
  }
}

TEST(VariableOffset, RefusesAPathWithoutLength) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePoint vertex = vertexPoint(sheet.mesh, 12);
  const SurfacePath path{{vertex, vertex}, {0, 0}};
  const double widths[] = {0.1, 0.2};
  try {
    offsetLines(sheet.geometry, {&path, 1}, widths, OffsetSide::kBoth);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadArgument);
    EXPECT_STREQ(error.what(), "path 0 has no length");
  }
}

TEST(VariableOffset, RefusesInvalidDistancesAndMiters) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePath path = polygonOn(sheet.geometry, {Vec2(1, 1), Vec2(3, 2)}, false);
  const auto code = [&](const Array<double>& distances, const OffsetCorners& corners) {
    return codeOf([&] {
      offsetLines(sheet.geometry, {&path, 1}, distances, OffsetSide::kBoth, corners);
    });
  };
  EXPECT_EQ(code({1, -0.1}, {}), ErrorCode::kBadArgument);
  EXPECT_EQ(code({0, 0}, {}), ErrorCode::kBadArgument);
  EXPECT_EQ(code({}, {}), ErrorCode::kBadArgument);
  EXPECT_EQ(code({1, std::numeric_limits<double>::quiet_NaN()}, {}), ErrorCode::kBadArgument);
  EXPECT_EQ(code({0.3, 0.2}, {CornerShape::kMiter, 4}), ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

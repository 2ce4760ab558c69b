#include "curves/offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cases.h"
#include "distance/path_distance.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/rough.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

/// Distances from paths, and their isolines.
namespace karcher {
namespace {

double fromSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double part = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - part * (b - a)).norm();
}

double fromPath(const TriangleMesh& mesh, const SurfacePath& path, const Vec3& p) {
  double least = kInfinity;
  for (int i = 1; i < path.points.count(); ++i) {
    least = std::min(
        least, fromSegment(p, position(mesh, path.points[i - 1]), position(mesh, path.points[i])));
  }
  return least;
}

double lengthOf(const Array<Isoline>& lines) {
  double length = 0;
  for (const Isoline& line : lines) length += line.length;
  return length;
}

/// Checks lines: consecutive points share a face, and points and quarters of chords are at the
/// distance.
void expectAtDistance(const Geometry& geometry, const Array<Isoline>& lines,
                      const std::function<double(const SurfacePoint&)>& distance, double expected,
                      double tolerance) {
  const TriangleMesh& mesh = *geometry.mesh;
  double worst = 0;
  for (const Isoline& line : lines) {
    for (int i = 0; i < line.points.count(); ++i) {
      worst = std::max(worst, std::abs(distance(line.points[i]) - expected));
      if (i == 0) continue;
      ASSERT_TRUE(haveCommonFace(mesh, line.points[i - 1], line.points[i]));
      for (int k = 1; k < 4; ++k) {
        const SurfacePoint part = pointBetween(mesh, line.points[i - 1], line.points[i], k / 4.0);
        worst = std::max(worst, std::abs(distance(part) - expected));
      }
    }
    EXPECT_EQ(line.closed, samePlace(mesh, line.points.front(), line.points.back()));
    if (line.closed) continue;
    for (const SurfacePoint& end : {line.points.front(), line.points.back()}) {
      const PointLocation at = locate(mesh, end);
      EXPECT_EQ(at.simplex, Simplex::kEdge);
      EXPECT_LT(mesh.twin[at.halfedge], 0);
    }
  }
  EXPECT_LT(worst, tolerance * expected);
}

TEST(PathDistance, OnThePlaneIsTheEuclideanDistance) {
  const Sheet sheet(planeGrid(12, 10));
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    Array<Vec2> corners;
    for (int i = 0; i < 5; ++i) corners.emplace_back(random.uniform(1, 11), random.uniform(1, 9));
    // The path also passes through vertices and along edges.
    if (run % 2 == 0) {
      for (Vec2& corner : corners) corner = corner.array().round();
    }
    for (int i = 1; i < corners.count(); ++i) {
      if (corners[i] == corners[i - 1]) corners[i].x() += corners[i].x() < 6 ? 1 : -1;
    }
    const SurfacePath path = polygonOn(sheet.geometry, corners, run % 3 == 0);
    const PathDistance field(sheet.geometry, {&path, 1}, kInfinity);
    for (int i = 0; i < 200; ++i) {
      const SurfacePoint point = randomPlace(sheet.mesh, random);
      const double expected = fromPath(sheet.mesh, path, position(sheet.mesh, point));
      EXPECT_NEAR(field.at(point).value, expected, 1e-12) << "run " << run;
    }
  }
}

TEST(PathDistance, OnMeshesIsTheLeastDistanceOfItsPoints) {
  Random random(11);
  const char* names[] = {"sphere, random", "plate with 50 holes",
                         "rough sheet",    "very rough sheet",
                         "torus",          "crumpled sheet, 6 folds"};
  for (const char* name : casesOf(names, 2)) {
    const Sheet surface(galleryMesh(name));
    const TriangleMesh& mesh = surface.mesh;
    Array<SurfacePoint> points;
    for (int i = 0; i < 3; ++i) points.push_back(randomPlace(mesh, random));
    const SurfacePath path = chain(surface.geometry, points, false);
    const PathDistance field(surface.geometry, {&path, 1}, kInfinity);
    WindowDistance exact(surface.geometry);
    Array<double> least(mesh.positions.size(), kInfinity);
    const double step = path.length() / 150;
    Array<double> samples = path.lengths;
    for (int i = 1; i < 150; ++i) samples.push_back(i * step);
    for (const double length : samples) {
      exact.setSource(pointAlong(mesh, path, length));
      exact.grow(kInfinity);
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        least[v] = std::min(least[v], exact.distance(v));
      }
    }
    // A sample lies within half a step of the nearest point, so its path is longer by at most half
    // a step. The step is perpendicular to the path, so the excess is usually of second order. It
    // is step^2 / (8 d) if paths do not bend, and larger beside a vertex around which they bend.
    const bool isConvex = std::string(name) == "sphere, random";
    double nearest = 0;
    double farthest = 0;
    double worst = 0;
    double sum = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double d = field.atVertex(v);
      const double longer = least[v] - d;
      nearest = std::max(nearest, -longer);
      farthest = std::max(farthest, longer);
      sum += longer;
      if (d > step) worst = std::max(worst, longer / (step * step / (8 * d)));
    }
    const double rounding = 1e-9 * surface.geometry.diagonal;
    EXPECT_LT(nearest, rounding) << name;
    EXPECT_LT(farthest, step / 2 + rounding) << name;
    EXPECT_LT(sum / mesh.vertexCount(), step / 100) << name;
    if (isConvex) {
      EXPECT_LT(worst, 1.5) << name;
    }
  }
}

TEST(Offset, OfARectangleOnThePlane) {
  const Sheet sheet(planeGrid(12, 10));
  const SurfacePath path =
      polygonOn(sheet.geometry, {Vec2(3.2, 3.1), Vec2(8.3, 3.1), Vec2(8.3, 7.4), Vec2(3.2, 7.4)});
  const double around = 2 * (5.1 + 4.3);
  const auto distance = [&](const SurfacePoint& point) {
    return fromPath(sheet.mesh, path, position(sheet.mesh, point));
  };
  const double distances[] = {0.4, 0.02, 1.7};
  for (const double d : casesOf(distances, 1)) {
    const auto left = offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kLeft);
    const auto right = offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kRight);
    const auto both = offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kBoth);
    ASSERT_EQ(left.count(), 1);
    ASSERT_EQ(right.count(), 1);
    ASSERT_EQ(both.count(), 2);
    // On the inside the path's corners stay, on the outside they are round.
    EXPECT_NEAR(left[0].length, around - 8 * d, 4e-3 * d);
    EXPECT_NEAR(right[0].length, around + 2 * kPi * d, 4e-3 * d);
    EXPECT_NEAR(lengthOf(both), left[0].length + right[0].length, 1e-9);
    expectAtDistance(sheet.geometry, both, distance, d, 1e-3);
  }
  // Farther inside the offset is empty.
  EXPECT_EQ(offsetLines(sheet.geometry, {&path, 1}, 2.2, OffsetSide::kLeft).count(), 0);
}

TEST(Offset, OfAnOpenPathGoesAroundItsEnds) {
  const Sheet sheet(planeGrid(12, 10));
  const SurfacePath path = polygonOn(sheet.geometry, {Vec2(3, 5), Vec2(8.2, 5)}, false);
  const double d = 0.7;
  const auto both = offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kBoth);
  ASSERT_EQ(both.count(), 1);
  EXPECT_NEAR(both[0].length, 2 * 5.2 + 2 * kPi * d, 1e-3 * 2 * kPi * d);
  for (const OffsetSide side : {OffsetSide::kLeft, OffsetSide::kRight}) {
    const auto lines = offsetLines(sheet.geometry, {&path, 1}, d, side);
    ASSERT_EQ(lines.count(), 1);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_NEAR(lines[0].length, 5.2, 1e-6);
    // The offset runs in the direction of the path, on its side.
    const Vec3 first = position(sheet.mesh, lines[0].points.front());
    const double y = side == OffsetSide::kLeft ? 5 + d : 5 - d;
    EXPECT_LT((first - Vec3(3, y, 0)).norm(), 1e-6);
  }
}

TEST(Offset, OfAPathFromRimToRimEndsThereToo) {
  const Sheet sheet(planeGrid(12, 10));
  // The path is slanted: on one side the shortest paths to the rim lead around its ends.
  const SurfacePath path = polygonOn(sheet.geometry, {Vec2(4, 0), Vec2(6.5, 10)}, false);
  for (const OffsetSide side : {OffsetSide::kLeft, OffsetSide::kRight}) {
    const auto lines = offsetLines(sheet.geometry, {&path, 1}, 1.3, side);
    ASSERT_EQ(lines.count(), 1);
    expectAtDistance(
        sheet.geometry, lines,
        [&](const SurfacePoint& point) {
          return fromPath(sheet.mesh, path, position(sheet.mesh, point));
        },
        1.3, 1e-3);
  }
}

TEST(Offset, OnTheSphereAndTheTorusIsTheParallelCircle) {
  SKIP_WHERE_SANITIZED();
  double last = 0;
  for (const int triangles : {2000, 32'000}) {
    const Sheet sphere(meshOf(relaxedSphere(triangles, 3)));
    Array<SurfacePoint> points;
    for (int i = 0; i < 768; ++i) {
      const double angle = 2 * kPi * i / 768;
      const Vec3 place(std::cos(0.5) * std::cos(angle), std::cos(0.5) * std::sin(angle),
                       std::sin(0.5));
      points.push_back(nearestPoint(sphere.mesh, place));
    }
    const SurfacePath path = chain(sphere.geometry, points, true);
    const auto up = offsetLines(sphere.geometry, {&path, 1}, 0.3, OffsetSide::kLeft);
    ASSERT_EQ(up.count(), 1);
    const double error = std::abs(up[0].length - 2 * kPi * std::cos(0.8));
    if (last > 0) {
      // With sixteen times as many triangles the edges are a quarter as long.
      EXPECT_LT(error, last / 8);
    }
    last = error;
  }
  EXPECT_LT(last, 2e-3);

  const Sheet torus(meshOf(irregularTorus(32'000, 1, 3)));
  Array<SurfacePoint> points;
  for (int i = 0; i < 768; ++i) {
    const double angle = 2 * kPi * i / 768;
    points.push_back(nearestPoint(
        torus.mesh, (kTorusMajor + kTorusMinor) * Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  // Beside the outermost circle the offsets are circles at the angle d / minor on both sides.
  const SurfacePath path = chain(torus.geometry, points, true);
  const double d = 0.8 * kTorusMinor;
  const auto both = offsetLines(torus.geometry, {&path, 1}, d, OffsetSide::kBoth);
  ASSERT_EQ(both.count(), 2);
  const double expected = 4 * kPi * (kTorusMajor + kTorusMinor * std::cos(0.8));
  EXPECT_NEAR(lengthOf(both), expected, 1e-3 * expected);
}

TEST(Offset, KeepsItsDistanceOnRoughSurfaces) {
  Random random(23);
  const char* names[] = {"rough sheet", "very rough sheet",         "torus, stretched 8:1",
                         "knot",        "crumpled sheet, 20 folds", "sphere, random"};
  for (const char* name : casesOf(names, 2)) {
    const Sheet surface(galleryMesh(name));
    Array<SurfacePoint> points;
    for (int i = 0; i < 4; ++i) points.push_back(randomPlace(surface.mesh, random));
    const SurfacePath path = chain(surface.geometry, points, true);
    for (const double part : {0.5, 3.0, 8.0}) {
      const double d = part * surface.geometry.meanEdge;
      const auto lines = offsetLines(surface.geometry, {&path, 1}, d, OffsetSide::kBoth);
      const PathDistance field(surface.geometry, {&path, 1}, kInfinity);
      SCOPED_TRACE(std::string(name) + ", " + std::to_string(part));
      // A path may come so near to the whole surface that no point is as far away as `d`.
      double farthest = 0;
      for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        farthest = std::max(farthest, field.at(vertexPoint(surface.mesh, v)).value);
      }
      if (farthest > d) {
        EXPECT_GT(lines.count(), 0);
      }
      expectAtDistance(
          surface.geometry, lines, [&](const SurfacePoint& point) { return field.at(point).value; },
          d, 1e-3);
    }
  }
}

/// A closed chain through four random places of a crumpled sheet.
SurfacePath chainOn(const Geometry& geometry, uint64_t seed) {
  Random random(seed);
  Array<SurfacePoint> points;
  for (int i = 0; i < 4; ++i) points.push_back(randomPlace(*geometry.mesh, random));
  return chain(geometry, points, true);
}

TEST(Offset, KeepsItsDistanceAtTheTipsOfNarrowGaps) {
  const uint64_t seeds[] = {3, 5, 11, 20, 74, 83, 93};
  for (const uint64_t seed : casesOf(seeds, 2)) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Sheet sheet(meshOf(crumpledSheet(300, 20, seed)));
    const SurfacePath path = chainOn(sheet.geometry, seed);
    const PathDistance field(sheet.geometry, {&path, 1}, kInfinity);
    for (const double part : {0.3, 0.5, 1.0}) {
      const double d = part * sheet.geometry.meanEdge;
      const auto lines = offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kBoth);
      EXPECT_GT(lines.count(), 0);
      expectAtDistance(
          sheet.geometry, lines, [&](const SurfacePoint& point) { return field.at(point).value; },
          d, 1e-3);
    }
  }
}

// The corners of a piece of a face may be collinear up to rounding. Then halves of its two longest
// sides have each other for sides, and halving in turn would not end.
TEST(Offset, EndsWherePiecesOfFacesAreCollinear) {
  for (const uint64_t seed : {8u, 17u, 26u}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Sheet sheet(meshOf(crumpledSheet(12, 8, seed)));
    const SurfacePath path = chainOn(sheet.geometry, seed);
    for (const double part : {0.05, 0.2}) {
      const double d = part * sheet.geometry.meanEdge;
      EXPECT_GT(offsetLines(sheet.geometry, {&path, 1}, d, OffsetSide::kBoth).count(), 0);
    }
  }
}

TEST(PathDistance, OfAPathWithPointsBesideEachOtherOnTwoSidesOfAnEdge) {
  const Sheet sheet(planeGrid(1, 1));
  const int h = sheet.mesh.twin[0] >= 0 ? 0 : sheet.mesh.twin[1] >= 0 ? 1 : 2;
  const SurfacePoint crossing = edgePoint(h, 0.4);
  const auto inwards = [&](const SurfacePoint& point, double part) {
    const Vec3 bary = (1 - part) * point.bary + Vec3::Constant(part / 3);
    return SurfacePoint{point.face, bary};
  };
  const SurfacePoint across = edgePoint(sheet.mesh.twin[h], 0.6);
  const SurfacePath path{
      {inwards(crossing, 0.5), inwards(crossing, 1e-14), crossing, inwards(across, 0.5)}, {}};
  const PathDistance field(sheet.geometry, std::span(&path, 1), 1);
  EXPECT_NEAR(field.at(across).value, 0, 1e-12);
}

TEST(PathDistance, PassesACapWhoseApexLiesOnAnEdgeUpToRounding) {
  // Face 0 4 6 is a cap, 5e-12 high. The path ends at its neighbors.
  const TriangleSoup soup{
      {{0, 0, 0},
       {1, 0, 0},
       {-0.009221595712006092, 1, 0.19776670937426388},
       {0.36798916943371296, -1, -0.091680376091972},
       {0.3696887441893434, -0.9973060283863359, -0.09143339176125016},
       {0.9991424392809239, -0.0013568700745806748, -0.00012439835874549835},
       {0.3673586553740309, -0.9982729017218506, -0.09152203507228346}},
      {{0, 1, 2}, {1, 4, 5}, {1, 0, 4}, {3, 4, 6}, {4, 3, 5}, {3, 1, 5}, {4, 0, 6}, {0, 3, 6}}};
  const Sheet sheet(meshOf(soup));
  const SurfacePath path =
      pathThrough(sheet.mesh, {vertexPoint(sheet.mesh, 3), vertexPoint(sheet.mesh, 5)});
  const PathDistance field(sheet.geometry, {&path, 1}, kInfinity);
  WindowDistance exact(sheet.geometry);
  exact.setSource(path.end());
  exact.grow(kInfinity);
  for (int v = 0; v < sheet.mesh.vertexCount(); ++v) {
    EXPECT_LE(field.atVertex(v), exact.distance(v) * (1 + 1e-12)) << "vertex " << v;
  }
}

TEST(Offset, RefusesInvalidPathsAndDistances) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePath path = polygonOn(sheet.geometry, {Vec2(1, 1), Vec2(3, 2)}, false);
  const auto code = [&](const SurfacePath& one, double distance) {
    return codeOf([&] { offsetLines(sheet.geometry, {&one, 1}, distance, OffsetSide::kBoth); });
  };
  for (const double bad : {0.0, -1.0, kInfinity}) {
    EXPECT_EQ(code(path, bad), ErrorCode::kBadArgument);
  }
  EXPECT_EQ(code({{path.points[0]}, {0}}, 1), ErrorCode::kBadArgument);
  EXPECT_EQ(code({{vertexPoint(sheet.mesh, 0), vertexPoint(sheet.mesh, 24)}, {0, 1}}, 1),
            ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

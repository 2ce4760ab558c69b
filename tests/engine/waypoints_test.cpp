#include "distance/waypoints.h"

#include <gtest/gtest.h>

#include "generators/flat.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "intrinsic/straighten.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// The largest distance between two paths at equal parts of their lengths.
double gapBetween(const TriangleMesh& mesh, const SurfacePath& a, const SurfacePath& b) {
  double gap = 0;
  for (int i = 0; i <= 200; ++i) {
    const Vec3 p = position(mesh, pointAlong(mesh, a, a.length() * i / 200));
    const Vec3 q = position(mesh, pointAlong(mesh, b, b.length() * i / 200));
    gap = std::max(gap, (p - q).norm());
  }
  return gap;
}

SurfacePoint onTube(const TriangleMesh& mesh, double angle, double height) {
  return nearestPoint(mesh, Vec3(std::cos(angle), std::sin(angle), height));
}

TEST(Waypoints, AreAbsentOnTheFastPath) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kTorus, 3000));
  const Geometry geometry = buildGeometry(mesh);
  Random random(11);
  FindPathWorkspace workspace;
  SurfacePath path;
  for (int i = 0; i < 40; ++i) {
    const SurfacePoint from = randomPlace(mesh, random);
    const SurfacePoint to = randomPlace(mesh, random);
    ASSERT_TRUE(findPath(geometry, from, to, workspace, path));
    EXPECT_TRUE(waypointsOf(geometry, path, workspace).empty());
    SurfacePath again;
    ASSERT_TRUE(findPathBy(geometry, from, {}, to, workspace, again));
    EXPECT_EQ(gapBetween(mesh, path, again), 0);
  }
}

TEST(Waypoints, FixTheWindingsOfAPathAroundATube) {
  const FlatCylinder tube = flatCylinder(24, 3, 5);
  const TriangleMesh mesh = meshOf(tube.soup);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  SurfacePath path;
  for (const double end : {3.6, 5.9, 8.0, 14.5}) {
    ASSERT_TRUE(
        findPath(geometry, onTube(mesh, 0.1, 0.5), onTube(mesh, 0.4, 0.6), workspace, path));
    const int steps = 60;
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      ASSERT_TRUE(moveEnd(geometry, onTube(mesh, 0.4 + part * (end - 0.4), 0.6 + part), path,
                          workspace.strip));
    }
    const Array<SurfacePoint> waypoints = waypointsOf(geometry, path, workspace);
    EXPECT_GT(waypoints.count(), 0) << end;
    EXPECT_LE(waypoints.count(), 7) << end;
    SurfacePath again;
    ASSERT_TRUE(findPathBy(geometry, path.start(), waypoints, path.end(), workspace, again));
    // The lines are straight on the unrolled tube: equal up to rounding.
    EXPECT_LT(gapBetween(mesh, path, again), 1e-9) << end;
    // In the opposite direction around it the path is the same.
    Array<SurfacePoint> turned(waypoints.rbegin(), waypoints.rend());
    SurfacePath back;
    ASSERT_TRUE(findPathBy(geometry, path.end(), turned, path.start(), workspace, back));
    EXPECT_LT(gapBetween(mesh, reversed(back), again), 1e-12) << end;
  }
}

TEST(Waypoints, FindDrawnPathsAgainOnCurvedSurfaces) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kKnot, 6000));
  const Geometry geometry = buildGeometry(mesh);
  Random random(5);
  FindPathWorkspace workspace;
  int drawn = 0;
  for (int i = 0; i < 30; ++i) {
    SurfacePath path;
    const SurfacePoint from = randomPlace(mesh, random);
    ASSERT_TRUE(findPath(geometry, from, randomPlace(mesh, random), workspace, path));
    // The end follows another path, as in a drag.
    SurfacePath way;
    ASSERT_TRUE(findPath(geometry, path.end(), randomPlace(mesh, random), workspace, way));
    bool goesOn = true;
    for (int k = 1; k <= 60 && goesOn; ++k) {
      const SurfacePoint place = pointAlong(mesh, way, way.length() * k / 60);
      goesOn = moveEnd(geometry, place, path, workspace.strip);
    }
    if (!goesOn) continue;
    const Array<SurfacePoint> waypoints = waypointsOf(geometry, path, workspace);
    drawn += !waypoints.empty();
    SurfacePath again;
    ASSERT_TRUE(findPathBy(geometry, path.start(), waypoints, path.end(), workspace, again));
    EXPECT_LT(gapBetween(mesh, path, again), 1e-3 * path.length()) << i;
  }
  EXPECT_GT(drawn, 5);
}

TEST(Waypoints, OnEdgesFromFaceToFaceAreThePathItself) {
  const FlatCylinder tube = flatCylinder(24, 3, 5);
  const TriangleMesh mesh = meshOf(tube.soup);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  SurfacePath path;
  ASSERT_TRUE(findPath(geometry, onTube(mesh, 0.1, 0.5), onTube(mesh, 1.9, 0.6), workspace, path));
  // The path bends at every second edge, unlike any straightened path.
  Array<SurfacePoint> bent(path.points.begin() + 1, path.points.end() - 1);
  ASSERT_GT(bent.count(), 4);
  for (int i = 0; i < bent.count(); i += 2) {
    const PointLocation location = locate(mesh, bent[i]);
    ASSERT_EQ(location.simplex, Simplex::kEdge);
    bent[i] = edgePoint(location.halfedge, 0.5 * bent[i].bary[cornerOf(location.halfedge)]);
  }
  SurfacePath found;
  ASSERT_TRUE(findPathBy(geometry, path.start(), bent, path.end(), workspace, found));
  ASSERT_EQ(found.points.count(), bent.count() + 2);
  EXPECT_GT(found.length(), path.length() * (1 + 1e-3));
  for (int i = 0; i < bent.count(); ++i) EXPECT_EQ(found.points[i + 1].bary, bent[i].bary);
  // Such a path consists of its own waypoints, since fewer do not restore it.
  EXPECT_EQ(waypointsOf(geometry, found, workspace).count(), bent.count());
  // A single point off the edges makes the path straighten.
  bent[3] = SurfacePoint{bent[3].face, Vec3(0.4, 0.3, 0.3)};
  ASSERT_TRUE(findPathBy(geometry, path.start(), bent, path.end(), workspace, found));
  EXPECT_LT(found.length(), path.length() * (1 + 1e-9));
}

TEST(Waypoints, OnAnotherComponentAreRefused) {
  TriangleSoup soup = flatCylinder(12, 1, 5).soup;
  const int vertices = soup.positions.count();
  const Array<Vec3> first = soup.positions;
  for (const Vec3& place : first) soup.positions.push_back(place + Vec3(5, 0, 0));
  const auto triangles = soup.triangles;
  for (auto triangle : triangles) {
    for (int& vertex : triangle) vertex += vertices;
    soup.triangles.push_back(triangle);
  }
  const TriangleMesh mesh = meshOf(soup);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  SurfacePath path;
  const SurfacePoint near = onTube(mesh, 0.3, 0.5);
  const SurfacePoint far = nearestPoint(mesh, Vec3(6, 0, 0.5));
  EXPECT_FALSE(findPathBy(geometry, near, {far}, onTube(mesh, 1, 0.5), workspace, path));
  EXPECT_TRUE(path.points.empty());
}

}  // namespace
}  // namespace karcher

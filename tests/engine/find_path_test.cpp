#include "distance/find_path.h"

#include <gtest/gtest.h>

#include "distance/shortest_path.h"
#include "distance_meshes.h"
#include "generators/plane.h"
#include "generators/rough.h"
#include "intrinsic/straightest.h"
#include "support.h"

namespace karcher {
namespace {

void expectSamePath(const SurfacePath& a, const SurfacePath& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (int i = 0; i < a.points.count(); ++i) {
    EXPECT_EQ(a.points[i].face, b.points[i].face);
    EXPECT_EQ(a.points[i].bary, b.points[i].bary);
  }
}

void expectEnds(const SurfacePath& path, const SurfacePoint& from, const SurfacePoint& to) {
  EXPECT_EQ(path.start().face, from.face);
  EXPECT_EQ(path.start().bary, from.bary);
  EXPECT_EQ(path.end().face, to.face);
  EXPECT_EQ(path.end().bary, to.bary);
}

/// Compares paths between random places, in both directions, with the shortest. `most` is the
/// largest relative excess.
void expectShort(const TriangleMesh& mesh, int pairs, uint64_t seed, double most) {
  const Geometry geometry = buildGeometry(mesh);
  Random random(seed);
  FindPathWorkspace workspace;
  SurfacePath path;
  SurfacePath back;
  int within = 0;
  for (int i = 0; i < pairs; ++i) {
    const SurfacePoint from = randomPlace(mesh, random);
    const SurfacePoint to = randomPlace(mesh, random);
    ASSERT_TRUE(findPath(geometry, from, to, workspace, path));
    ASSERT_TRUE(findPath(geometry, to, from, workspace, back));
    expectEnds(path, from, to);
    expectSamePath(reversed(back), path);
    EXPECT_EQ(path.lengths, pathThrough(mesh, path.points).lengths);
    for (int k = 1; k < path.points.count(); ++k) {
      EXPECT_TRUE(haveCommonFace(mesh, path.points[k - 1], path.points[k]));
    }
    const double exact = shortestPath(geometry, from, to).length();
    EXPECT_GE(path.length(), exact * (1 - 1e-12));
    EXPECT_LE(path.length(), exact * (1 + most));
    within += path.length() <= exact * (1 + 1e-3) + 1e-15;
  }
  EXPECT_GE(within, 0.97 * pairs);
}

TEST(FindPath, IsTheStraightLineInThePlane) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const MeasuredMesh plane(tessellatedPlane(tessellation, 1500, 3));
    Random random(5);
    FindPathWorkspace workspace;
    SurfacePath path;
    for (int i = 0; i < 40; ++i) {
      const SurfacePoint from = randomPlace(plane.mesh, random);
      const SurfacePoint to = randomPlace(plane.mesh, random);
      ASSERT_TRUE(findPath(plane.geometry, from, to, workspace, path));
      expectEnds(path, from, to);
      EXPECT_NEAR(path.length(), (position(plane.mesh, to) - position(plane.mesh, from)).norm(),
                  1e-12 * plane.geometry.diagonal);
    }
  }
}

TEST(FindPath, IsTheSameWhereverTheSurfaceLies) {
  SKIP_WHERE_SANITIZED();
  const MeasuredMesh bunny(roughened(bunnyMesh(), 3, 6));
  TriangleMesh moved = bunny.mesh;
  for (Vec3& at : moved.positions) at = Vec3(-at.x(), -at.y(), at.z()) + Vec3(3, -2, 5);
  const Geometry geometry = buildGeometry(moved);
  Random random(7);
  FindPathWorkspace workspace;
  SurfacePath path;
  SurfacePath again;
  for (int i = 0; i < 200; ++i) {
    // Half of the pairs join vertices, which have the same weights on both meshes.
    const auto place = [&] {
      return i % 2 == 0 ? randomPlace(bunny.mesh, random)
                        : vertexPoint(bunny.mesh, random.index(bunny.mesh.vertexCount()));
    };
    const SurfacePoint from = place();
    const SurfacePoint to = place();
    ASSERT_TRUE(findPath(bunny.geometry, from, to, workspace, path));
    ASSERT_TRUE(findPath(geometry, from, to, workspace, again));
    EXPECT_NEAR(again.length(), path.length(), 1e-12 * geometry.diagonal) << "pair " << i;
  }
}

// The search promises paths at most a fiftieth longer than the shortest.
TEST(FindPath, IsShortOnTheBunny) { expectShort(bunnyMesh(), 100, 1, 0.02); }

TEST(FindPath, IsShortOnATorus) {
  expectShort(meshOf(makeShape(Shape::kTorus, 3000)), 100, 2, 0.02);
}

TEST(FindPath, IsShortBesideABoundary) { expectShort(lShape(8), 60, 3, 1e-12); }

TEST(FindPath, IsShortOnARoughSurface) {
  expectShort(meshOf(roughened(meshOf(makeShape(Shape::kOpenSheet, 1000)), 2, 5)), 60, 4, 0.02);
}

TEST(FindPath, IsFoundPieceByPieceBetweenFarPoints) {
  // The points are 250 mean edges apart: beyond the range of the thorough search.
  const MeasuredMesh sheet(roughened(planeGrid(60, 20), 3, 5));
  const SurfacePoint from = nearestPoint(sheet.mesh, Vec3(0.5, 1.2, 0));
  const SurfacePoint to = nearestPoint(sheet.mesh, Vec3(59.3, 17.7, 0));
  FindPathWorkspace workspace;
  SurfacePath path;
  SurfacePath back;
  ASSERT_TRUE(findPath(sheet.geometry, from, to, workspace, path));
  ASSERT_TRUE(findPath(sheet.geometry, to, from, workspace, back));
  ASSERT_GT((position(sheet.mesh, to) - position(sheet.mesh, from)).norm(),
            100 * sheet.geometry.meanEdge);
  expectSamePath(reversed(back), path);
  const double exact = shortestPath(sheet.geometry, from, to).length();
  EXPECT_GE(path.length(), exact * (1 - 1e-12));
  EXPECT_LE(path.length(), exact * 1.01);
  ASSERT_TRUE(findPath(sheet.geometry, from, to, workspace, path, {.certified = true}));
  EXPECT_NEAR(path.length(), exact, 1e-10 * exact);
  expectEnds(path, from, to);
}

TEST(FindPath, EndsWhereItStarts) {
  const MeasuredMesh torus(makeShape(Shape::kTorus, 1000));
  FindPathWorkspace workspace;
  SurfacePath path;
  const SurfacePoint p{4, Vec3(0.2, 0.5, 0.3)};
  ASSERT_TRUE(findPath(torus.geometry, p, p, workspace, path));
  EXPECT_EQ(path.length(), 0);
  EXPECT_EQ(path.points.size(), 2u);
}

TEST(FindPath, IsNotFoundBetweenComponents) {
  const MeasuredMesh both(together(planeGrid(3, 3), planeGrid(3, 3), Vec3(10, 0, 0)));
  FindPathWorkspace workspace;
  SurfacePath path = pathThrough(both.mesh, {vertexPoint(both.mesh, 3)});
  EXPECT_FALSE(findPath(both.geometry, vertexPoint(both.mesh, 0), vertexPoint(both.mesh, 20),
                        workspace, path));
  EXPECT_EQ(path.points.size(), 1u);
}

TEST(FindPath, JoinsTheEndsOfWalksOfNoLength) {
  const TriangleMesh mesh = planeGrid(4, 4);
  const Geometry geometry = buildGeometry(mesh);
  const int vertex = 12;
  FindPathWorkspace workspace;
  for (const double length : {1e-13, 1e-17, 1e-200, 5e-324}) {
    for (int i = 0; i < 7; ++i) {
      for (int j = 0; j < 7; ++j) {
        SurfacePath path;
        ASSERT_TRUE(findPath(
            geometry, traceFromVertex(geometry, vertex, 0.9 * i, length).path.end(),
            traceFromVertex(geometry, vertex, 0.9 * j, length).path.end(), workspace, path));
        EXPECT_LT(path.length(), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace karcher

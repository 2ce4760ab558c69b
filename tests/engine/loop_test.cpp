#include <gtest/gtest.h>

#include "generators/plane.h"
#include "generators/sphere.h"
#include "mesh/loop_subdivision.h"
#include "mesh/shapes.h"
#include "mesh/split_triangles.h"
#include "support.h"

namespace karcher {
namespace {

TEST(LoopSubdivision, KeepsTheTopology) {
  for (const Shape shape : kShapes) {
    const TriangleMesh coarse = meshOf(makeShape(shape, 500));
    const TriangleMesh fine = meshOf(loopSubdivision(coarse));
    EXPECT_EQ(fine.faceCount(), 4 * coarse.faceCount());
    const Topology before = topology(coarse);
    const Topology after = topology(fine);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.boundaryLoops, before.boundaryLoops);
    EXPECT_EQ(after.genus, before.genus);
  }
}

/// Box splines reproduce linear functions: a regular plane does not change, except at the corners
/// of its boundary.
TEST(LoopSubdivision, LeavesARegularPlaneInPlace) {
  const TriangleMesh plane = meshOf(tessellatedPlane(PlaneTessellation::kRegularGrid, 200, 1));
  const TriangleSoup fine = loopSubdivision(plane);
  for (int v = 0; v < plane.vertexCount(); ++v) {
    const Vec3& p = plane.positions[v];
    const bool corner = (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1);
    if (!corner) {
      EXPECT_NEAR((fine.positions[v] - p).norm(), 0, 1e-15);
    }
  }
  for (const Vec3& p : fine.positions) EXPECT_EQ(p.z(), 0);
}

/*      2         The boundary is a closed cubic B-spline: midpoints, and 1/8, 6/8, 1/8 at the
       / \        old vertices.
      0---1   */
TEST(LoopSubdivision, FollowsACubicSplineAlongTheBoundary) {
  const TriangleMesh mesh = buildMesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}});
  const TriangleSoup fine = loopSubdivision(mesh);
  const Array<Vec3> expected = {{1, 1, 0}, {6, 1, 0}, {1, 6, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  EXPECT_TRUE(fine.positions == expected);
  const Array<Triangle> triangles = {{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}};
  EXPECT_TRUE(fine.triangles == triangles);
}

TEST(LoopSubdivision, WeighsAnInteriorVertexByItsValence) {
  // A pyramid over a square whose apex 0 has valence 4: beta = (5/8 - (3/8)^2) / 4 = 31/256.
  const TriangleMesh mesh = buildMesh({{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
  const TriangleSoup fine = loopSubdivision(mesh);
  EXPECT_NEAR((fine.positions[0] - Vec3(0, 0, 1 - 4 * 31.0 / 256)).norm(), 0, 1e-15);
  // An edge vertex: 3/8 of its ends and 1/8 of the two opposite corners.
  const Vec3 edge =
      0.375 * (Vec3(0, 0, 1) + Vec3(0, 1, 0)) + 0.125 * (Vec3(1, 0, 0) + Vec3(-1, 0, 0));
  bool found = false;
  for (const Vec3& p : fine.positions) found = found || (p - edge).norm() < 1e-15;
  EXPECT_TRUE(found);
}

/// Weights that sum to 1 commute with affine maps.
TEST(LoopSubdivision, CommutesWithAffineMaps) {
  Eigen::Matrix3d linear;
  linear << 1, 2, 0, -1, 0.5, 3, 0, 1, 1;
  const auto map = [&](const Vec3& p) { return Vec3(linear * p + Vec3(3, -1, 2)); };
  TriangleMesh mesh = meshOf(randomSphere(200, 1));
  const TriangleSoup fine = loopSubdivision(mesh);
  for (Vec3& p : mesh.positions) p = map(p);
  const TriangleSoup mapped = loopSubdivision(mesh);
  for (int v = 0; v < fine.positions.count(); ++v) {
    EXPECT_NEAR((map(fine.positions[v]) - mapped.positions[v]).norm(), 0, 1e-13);
  }
}

TEST(SplitTriangles, DividesEdgesAndFacesEvenly) {
  const TriangleMesh mesh = meshOf(randomSphere(100, 1));
  for (const int parts : {1, 2, 3, 6}) {
    const TriangleSoup soup = splitTriangles(mesh, parts);
    const TriangleMesh fine = meshOf(soup);
    ASSERT_EQ(fine.faceCount(), mesh.faceCount() * parts * parts);
    EXPECT_EQ(topology(fine).genus, 0);
    EXPECT_EQ(topology(fine).boundaryLoops, 0);
    for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(soup.positions[v], mesh.positions[v]);
    for (int f = 0; f < fine.faceCount(); ++f) {
      // The parts of a face are consecutive, with equal areas and directions.
      const auto areaVector = [](const TriangleMesh& m, int face) {
        const Vec3& a = m.positions[m.corner(face, 0)];
        return Vec3((m.positions[m.corner(face, 1)] - a).cross(m.positions[m.corner(face, 2)] - a));
      };
      const Vec3 whole = areaVector(mesh, f / (parts * parts));
      EXPECT_NEAR((parts * parts * areaVector(fine, f) - whole).norm(), 0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace karcher

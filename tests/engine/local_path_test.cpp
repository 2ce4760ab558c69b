#include "intrinsic/local_path.h"

#include <gtest/gtest.h>

#include "distance_meshes.h"
#include "generators/plane.h"
#include "intrinsic/straightest.h"
#include "support.h"

namespace karcher {
namespace {

struct Path : SurfacePath {
  bool found = false;
};

Path joined(const MeasuredMesh& surface, const SurfacePoint& from, const SurfacePoint& to,
            const LocalPathOptions& options = {}) {
  StripWorkspace workspace;
  Path path;
  path.points.push_back(from);
  path.found = appendLocalPath(surface.geometry, from, to, workspace, path.points, options);
  measure(surface.mesh, path);
  return path;
}

void expectJoined(const MeasuredMesh& surface, const Path& path) {
  for (int i = 1; i < path.points.count(); ++i) {
    EXPECT_TRUE(haveCommonFace(surface.mesh, path.points[i - 1], path.points[i]));
  }
}

TEST(LocalPath, IsTheStraightLineInThePlane) {
  const MeasuredMesh surface(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 300, 5));
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const SurfacePoint p = randomPlace(surface.mesh, random);
    const SurfacePoint q = randomPlace(surface.mesh, random);
    const Path path = joined(surface, p, q);
    ASSERT_TRUE(path.found);
    expectJoined(surface, path);
    const double euclid = (position(surface.mesh, q) - position(surface.mesh, p)).norm();
    EXPECT_NEAR(path.length(), euclid, 1e-11);
  }
}

TEST(LocalPath, IsStraightThroughTheVerticesOfARegularGrid) {
  const MeasuredMesh surface(planeGrid(6, 6));
  for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
    for (int w = 0; w < surface.mesh.vertexCount(); ++w) {
      const Path path = joined(surface, vertexPoint(surface.mesh, v), vertexPoint(surface.mesh, w));
      ASSERT_TRUE(path.found);
      expectJoined(surface, path);
      const double euclid = (surface.mesh.positions[v] - surface.mesh.positions[w]).norm();
      EXPECT_NEAR(path.length(), euclid, 1e-12);
    }
  }
}

TEST(LocalPath, FollowsAStraightestGeodesicThatIsShort) {
  const MeasuredMesh surface(icosphere(8));
  Random random(11);
  int same = 0;
  for (int i = 0; i < 300; ++i) {
    SurfacePoint p = randomPlace(surface.mesh, random);
    p.bary = (p.bary + Vec3::Constant(0.1)) / 1.3;
    const double walked = random.uniform(0.01, 0.3);
    const StraightestPath straight =
        traceStraightest(surface.geometry, p, walked * unitVector(random.uniform(-kPi, kPi)));
    const Path path = joined(surface, p, straight.path.end());
    ASSERT_TRUE(path.found);
    expectJoined(surface, path);
    // Another geodesic may pass on the other side of a vertex; as the vertices' curvature is small
    // its length is nearly the same.
    EXPECT_NEAR(path.length(), walked, 0.01 * walked);
    if (std::abs(path.length() - walked) < 1e-9) ++same;
  }
  EXPECT_GT(same, 240);
}

TEST(LocalPath, HasAtLeastHalfATurnOnBothSidesOfItsVertices) {
  const MeasuredMesh surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh;
  Random random(3);
  int vertices = 0;
  for (int i = 0; i < 200; ++i) {
    const SurfacePoint p = randomPlace(mesh, random);
    const SurfacePoint q = randomPlace(mesh, random);
    const Path path = joined(surface, p, q);
    ASSERT_TRUE(path.found);
    expectJoined(surface, path);
    for (int k = 1; k + 1 < path.points.count(); ++k) {
      const PointLocation at = locate(mesh, path.points[k]);
      if (at.simplex != Simplex::kVertex) continue;
      ++vertices;
      const auto directionTo = [&](const SurfacePoint& neighbour) {
        const PointLocation location = locate(mesh, neighbour);
        int h = mesh.outgoing[at.vertex];
        while (!liesInFace(mesh, location, faceOf(h))) h = rotateLeft(mesh, h);
        const SurfacePoint there = inFace(mesh, neighbour, faceOf(h));
        return directionAtTail(surface.geometry, h,
                               pointInFace(surface.geometry, there) -
                                   cornerInFace(surface.geometry, faceOf(h), cornerOf(h)));
      };
      const double turn =
          std::abs(directionTo(path.points[k + 1]) - directionTo(path.points[k - 1]));
      EXPECT_GT(turn, kPi - 1e-6);
      EXPECT_GT(surface.geometry.totalAngle[at.vertex] - turn, kPi - 1e-6);
    }
  }
  EXPECT_GT(vertices, 0) << "no path passed a vertex: the test says nothing";
}

TEST(LocalPath, GoesAroundAReentrantCorner) {
  const MeasuredMesh surface(lShape(2));
  const SurfacePoint p = nearestPoint(surface.mesh, Vec3(1.7, 3.6, 0));
  const SurfacePoint q = nearestPoint(surface.mesh, Vec3(3.8, 1.9, 0));
  const Path path = joined(surface, p, q);
  ASSERT_TRUE(path.found);
  expectJoined(surface, path);
  EXPECT_NEAR(path.length(), std::hypot(0.3, 1.6) + std::hypot(1.8, 0.1), 1e-12);
}

TEST(LocalPath, SaysWhenThePointsAreTooFarApart) {
  const MeasuredMesh surface(planeGrid(30, 30));
  const SurfacePoint p = vertexPoint(surface.mesh, 0);
  const SurfacePoint q = vertexPoint(surface.mesh, surface.mesh.vertexCount() - 1);
  LocalPathOptions options;
  options.maxFaces = 20;
  const Path path = joined(surface, p, q, options);
  EXPECT_FALSE(path.found);
  EXPECT_EQ(path.points.size(), 1u);
  EXPECT_EQ(path.length(), 0);
}

TEST(LocalPath, OfAPointToItselfHasNoLength) {
  const MeasuredMesh surface(icosphere(2));
  const SurfacePoint p{4, Vec3(0.2, 0.5, 0.3)};
  const Path path = joined(surface, p, p);
  ASSERT_TRUE(path.found);
  EXPECT_EQ(path.length(), 0);
  EXPECT_EQ(path.points.size(), 2u);
}

}  // namespace
}  // namespace karcher

#include "mesh/surface_point.h"

#include <gtest/gtest.h>

#include <string>

#include "generators/random.h"
#include "generators/sphere.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

std::string errorOf(const TriangleMesh& mesh, int face, const Vec3& bary) {
  try {
    checkedPoint(mesh, face, bary);
  } catch (const Error& error) {
    return std::string(errorCodeName(error.code())) + ": " + error.what();
  }
  return "";
}

TEST(CheckedPoint, NamesWhatIsWrong) {
  const TriangleMesh mesh = planeGrid(2, 2);
  EXPECT_EQ(errorOf(mesh, 8, Vec3(1, 0, 0)),
            "badIndex: there is no face 8: the mesh has 8 faces, numbered from 0");
  EXPECT_EQ(errorOf(mesh, -1, Vec3(1, 0, 0)).substr(0, 9), "badIndex:");
  EXPECT_EQ(errorOf(mesh, 3, Vec3(0.5, std::nan(""), 0.5)).substr(0, 10), "notFinite:");
  EXPECT_EQ(
      errorOf(mesh, 3, Vec3(0.5, 0.6, -0.1)),
      "badPoint: the point (0.5, 0.6, -0.1) in face 3 lies outside it: the weights must be at "
      "least 0 and sum to 1");
  EXPECT_EQ(errorOf(mesh, 3, Vec3(0.5, 0.5, 0.5)).substr(0, 9), "badPoint:");
}

TEST(CheckedPoint, TakesTheRoundingOfARaycast) {
  const TriangleMesh mesh = planeGrid(2, 2);
  const SurfacePoint p = checkedPoint(mesh, 3, Vec3(0.6, 0.4 + 5e-7, -5e-7));
  EXPECT_EQ(p.bary[2], 0);
  EXPECT_NEAR(p.bary.sum(), 1, 1e-15);
  EXPECT_EQ(locate(mesh, p).simplex, Simplex::kEdge);
  const SurfacePoint corner = checkedPoint(mesh, 3, Vec3(1e-13, 1, 1e-14));
  EXPECT_EQ(corner.bary, Vec3(0, 1, 0));
}

TEST(Locate, DistinguishesFacesEdgesAndVertices) {
  const TriangleMesh mesh = planeGrid(2, 2);
  EXPECT_EQ(locate(mesh, {5, Vec3(0.2, 0.3, 0.5)}).simplex, Simplex::kFace);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const PointLocation onEdge = locate(mesh, edgePoint(h, 0.3));
    EXPECT_EQ(onEdge.simplex, Simplex::kEdge);
    EXPECT_EQ(onEdge.halfedge, h);
    const PointLocation atVertex = locate(mesh, edgePoint(h, 0));
    EXPECT_EQ(atVertex.simplex, Simplex::kVertex);
    EXPECT_EQ(atVertex.vertex, mesh.tail(h));
  }
}

TEST(Position, FollowsTheEdge) {
  const TriangleMesh mesh = planeGrid(2, 2);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const Vec3 a = mesh.positions[mesh.tail(h)];
    const Vec3 b = mesh.positions[mesh.head(h)];
    EXPECT_TRUE(position(mesh, edgePoint(h, 0.25)).isApprox(0.75 * a + 0.25 * b, 1e-15));
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(position(mesh, vertexPoint(mesh, v)), mesh.positions[v]);
  }
  EXPECT_THROW(vertexPoint(mesh, mesh.vertexCount()), Error);
}

TEST(InFace, IsTheSamePlaceFromEveryFaceAround) {
  const TriangleSoup soup = randomSphere(200, 1);
  const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const SurfacePoint onEdge = edgePoint(h, 0.3);
    const SurfacePoint across = inFace(mesh, onEdge, faceOf(mesh.twin[h]));
    EXPECT_EQ(across.face, faceOf(mesh.twin[h]));
    EXPECT_TRUE(position(mesh, across).isApprox(position(mesh, onEdge), 1e-14));
    EXPECT_EQ(inFace(mesh, onEdge, faceOf(h)).bary, onEdge.bary);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    for (const int h : outgoingHalfedges(mesh, v)) {
      const SurfacePoint p = inFace(mesh, vertexPoint(mesh, v), faceOf(h));
      EXPECT_EQ(p.face, faceOf(h));
      EXPECT_EQ(position(mesh, p), mesh.positions[v]);
    }
  }
}

TEST(InFace, RefusesAFaceThatDoesNotHoldThePoint) {
  const TriangleMesh mesh = planeGrid(3, 1);
  EXPECT_THROW(inFace(mesh, {0, Vec3(0.2, 0.3, 0.5)}, 1), Error);
  EXPECT_THROW(inFace(mesh, edgePoint(0, 0.5), 5), Error);
  EXPECT_THROW(inFace(mesh, vertexPoint(mesh, 0), 5), Error);
}

TEST(NearestPoint, IsNoFartherThanAnyOtherPoint) {
  const TriangleSoup soup = makeShape(Shape::kOpenSheet, 500);
  const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Vec3 q(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1));
    const SurfacePoint nearest = nearestPoint(mesh, q);
    EXPECT_GE(nearest.bary.minCoeff(), 0);
    EXPECT_NEAR(nearest.bary.sum(), 1, 1e-14);
    const double distance = (position(mesh, nearest) - q).norm();
    for (int k = 0; k < 2000; ++k) {
      const double s = std::sqrt(random.uniform());
      const double t = random.uniform();
      const SurfacePoint other{random.index(mesh.faceCount()), Vec3(1 - s, s * (1 - t), s * t)};
      EXPECT_LE(distance, (position(mesh, other) - q).norm() + 1e-12);
    }
  }
}

TEST(NearestPoint, OfAPointOnTheMeshIsThatPoint) {
  const TriangleSoup soup = randomSphere(300, 2);
  const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (const Vec3& bary : {Vec3(0.2, 0.3, 0.5), Vec3(0.4, 0.6, 0), Vec3(0, 0, 1)}) {
      const Vec3 q = position(mesh, {f, bary});
      EXPECT_NEAR((position(mesh, nearestPoint(mesh, q)) - q).norm(), 0, 1e-14);
    }
  }
}

}  // namespace
}  // namespace karcher

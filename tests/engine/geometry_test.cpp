#include "intrinsic/geometry.h"

#include <gtest/gtest.h>

#include "generators/flat.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/sphere.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

TEST(Geometry, MeasuresARightTriangle) {
  // 2 (0, 3)
  // | .
  // 0 --- 1 (4, 0)
  const TriangleMesh mesh = buildMesh({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 1, 2}});
  const Geometry geometry = buildGeometry(mesh);
  EXPECT_DOUBLE_EQ(geometry.edgeLength[0], 4);
  EXPECT_DOUBLE_EQ(geometry.edgeLength[1], 5);
  EXPECT_DOUBLE_EQ(geometry.edgeLength[2], 3);
  EXPECT_DOUBLE_EQ(geometry.cornerAngle[0], kPi / 2);
  EXPECT_DOUBLE_EQ(geometry.cornerAngle[1], std::atan2(3, 4));
  EXPECT_DOUBLE_EQ(geometry.cornerAngle[2], std::atan2(4, 3));
  EXPECT_TRUE(geometry.apex[0].isApprox(Vec2(0, 3), 1e-15));
  EXPECT_DOUBLE_EQ(doubleArea(geometry, 0), 12);
  EXPECT_DOUBLE_EQ(geometry.meanEdge, 4);
  EXPECT_DOUBLE_EQ(geometry.diagonal, 5);
}

TEST(Geometry, AnglesOfAFaceSumToPi) {
  for (const TriangleMesh& mesh :
       {meshOf(jitteredUvSphere(2000, 1)),
        meshOf(tessellatedPlane(PlaneTessellation::kStretchedSheared, 2000, 1))}) {
    const Geometry geometry = buildGeometry(mesh);
    for (int f = 0; f < mesh.faceCount(); ++f) {
      const double sum = geometry.cornerAngle[3 * f] + geometry.cornerAngle[3 * f + 1] +
                         geometry.cornerAngle[3 * f + 2];
      EXPECT_NEAR(sum, kPi, 1e-12);
    }
  }
}

/// Angle deficits add up to 2 pi times the Euler characteristic.
TEST(Geometry, ObeysGaussAndBonnet) {
  const auto totalCurvature = [](const TriangleMesh& mesh) {
    const Geometry geometry = buildGeometry(mesh);
    double sum = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      sum += (mesh.onBoundary[v] ? 1 : 2) * kPi - geometry.totalAngle[v];
    }
    return sum / (2 * kPi);
  };
  EXPECT_NEAR(totalCurvature(meshOf(makeShape(Shape::kSphere, 500))), 2, 1e-11);
  EXPECT_NEAR(totalCurvature(meshOf(makeShape(Shape::kTorus, 500))), 0, 1e-11);
  EXPECT_NEAR(totalCurvature(meshOf(makeShape(Shape::kKnot, 500))), 0, 1e-11);
  EXPECT_NEAR(totalCurvature(meshOf(makeShape(Shape::kGenus3, 500))), -4, 1e-11);
  EXPECT_NEAR(totalCurvature(meshOf(makeShape(Shape::kOpenSheet, 500))), 1, 1e-11);
  EXPECT_NEAR(totalCurvature(meshOf(flatCylinder(12, 2, 1).soup)), 0, 1e-11);
}

TEST(Geometry, CumulatesAnglesCounterclockwise) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kOpenSheet, 500));
  const Geometry geometry = buildGeometry(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(geometry.cumulatedAngle[mesh.outgoing[v]], 0);
    double angle = 0;
    for (const int h : outgoingHalfedges(mesh, v)) {
      EXPECT_NEAR(geometry.cumulatedAngle[h], angle, 1e-14);
      angle += geometry.cornerAngle[h];
    }
    EXPECT_NEAR(geometry.totalAngle[v], angle, 1e-14);
    EXPECT_NEAR(geometry.angleScale[v], mesh.onBoundary[v] ? 1 : 2 * kPi / angle, 1e-14);
  }
}

/// On the plane a constant field is parallel: transported from any vertex, even on the boundary,
/// into any of its faces it is the same vector in space.
TEST(Connection, KeepsAConstantFieldConstantOnThePlane) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    const TriangleMesh mesh = meshOf(tessellatedPlane(tessellation, 400, 1));
    const Geometry geometry = buildGeometry(mesh);
    const Vec3 constant(0.6, -0.8, 0);
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      const int v = mesh.tail(h);
      const Vec3 axis = mesh.positions[mesh.head(mesh.outgoing[v])] - mesh.positions[v];
      const double angle =
          angleOf(Vec2(constant.x(), constant.y())) - std::atan2(axis.y(), axis.x());
      const Vec2 inFrame = rotate(geometry.vertexToFace[h], unitVector(angle));
      EXPECT_NEAR((toSpace(geometry, faceOf(h), inFrame) - constant).norm(), 0, 1e-12);
    }
  }
}

/// The direction from a vertex to a face's centroid is the same in both frames.
TEST(Connection, AgreesOnTheDirectionToTheCentroid) {
  const TriangleMesh mesh = meshOf(randomSphere(300, 1));
  const Geometry geometry = buildGeometry(mesh);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int f = faceOf(h);
    Vec3 centroid = Vec3::Zero();
    for (const int v : mesh.faces[f]) centroid += mesh.positions[v] / 3;
    const Vec3 toCentroid = centroid - mesh.positions[mesh.tail(h)];
    const Vec3 edge = mesh.positions[mesh.head(h)] - mesh.positions[mesh.tail(h)];
    const double inCorner = std::atan2(edge.cross(toCentroid).norm(), edge.dot(toCentroid));
    const double direction =
        geometry.angleScale[mesh.tail(h)] * (geometry.cumulatedAngle[h] + inCorner);
    const Vec2 inFace = rotate(geometry.vertexToFace[h], unitVector(direction));
    EXPECT_NEAR((toSpace(geometry, f, inFace) - toCentroid.normalized()).norm(), 0, 1e-12);
  }
}

/// Transported around a vertex through its faces, a vector turns by the vertex's angle deficit.
TEST(AcrossEdge, TurnsAroundAVertexByItsCurvature) {
  for (const TriangleMesh& mesh :
       {meshOf(randomSphere(300, 1)), meshOf(makeShape(Shape::kGenus3, 500)),
        meshOf(flatCone(16, 4, 1).soup)}) {
    const Geometry geometry = buildGeometry(mesh);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (mesh.onBoundary[v]) continue;
      Vec2 vector(1, 0);
      for (const int h : outgoingHalfedges(mesh, v)) {
        vector = acrossEdge(geometry, previous(h), vector);
      }
      const Vec2 expected = unitVector(2 * kPi - geometry.totalAngle[v]);
      EXPECT_NEAR((vector - expected).norm(), 0, 1e-11);
    }
  }
}

TEST(AcrossEdge, IsUndoneByTheTwinAndKeepsTheEdge) {
  const TriangleMesh mesh = meshOf(randomSphere(300, 1));
  const Geometry geometry = buildGeometry(mesh);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const Vec2 vector(0.3, -2);
    const Vec2 there = acrossEdge(geometry, h, vector);
    EXPECT_NEAR(there.norm(), vector.norm(), 1e-13);
    EXPECT_NEAR((acrossEdge(geometry, mesh.twin[h], there) - vector).norm(), 0, 1e-13);
    const Vec2 edge = acrossEdge(geometry, h, halfedgeInFace(geometry, h));
    EXPECT_NEAR((edge + halfedgeInFace(geometry, mesh.twin[h])).norm(), 0, 1e-13);
  }
}

TEST(FaceFrame, IsAnIsometryOfTheFacesPlane) {
  const TriangleMesh mesh = meshOf(randomSphere(300, 1));
  const Geometry geometry = buildGeometry(mesh);
  Random random(1);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = mesh.positions[mesh.head(3 * f + k)] - mesh.positions[mesh.tail(3 * f + k)];
      EXPECT_NEAR((toSpace(geometry, f, halfedgeInFace(geometry, 3 * f + k)) - edge).norm(), 0,
                  1e-14);
      EXPECT_NEAR((toFace(geometry, f, edge) - halfedgeInFace(geometry, 3 * f + k)).norm(), 0,
                  1e-14);
    }
    const Vec3 normal = toSpace(geometry, f, {1, 0}).cross(toSpace(geometry, f, {0, 1}));
    EXPECT_NEAR(normal.norm(), 1, 1e-13);
    EXPECT_NEAR(toFace(geometry, f, normal).norm(), 0, 1e-13);

    const SurfacePoint p = {f, Vec3(0.2, 0.5, 0.3)};
    const Vec2 x = pointInFace(geometry, p);
    EXPECT_NEAR((barycentric(geometry, f, x) - p.bary).norm(), 0, 1e-13);
    const Vec3 fromCorner = position(mesh, p) - mesh.positions[mesh.corner(f, 0)];
    EXPECT_NEAR((toSpace(geometry, f, x) - fromCorner).norm(), 0, 1e-14);
  }
}

TEST(CornerOfDirection, FindsTheCornerThatADirectionWasTakenFrom) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kOpenSheet, 500));
  const Geometry geometry = buildGeometry(mesh);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int v = mesh.tail(h);
    const double angle = 0.3 * geometry.cornerAngle[h];
    const Vec2 vector = rotate(unitVector(angle), halfedgeInFace(geometry, h));
    const double direction = directionAtTail(geometry, h, vector);
    // At interior vertices directions wrap around.
    for (const int turns : {0, 1, -1}) {
      if (turns != 0 && mesh.onBoundary[v]) continue;
      const CornerDirection corner =
          cornerOfDirection(geometry, v, direction + turns * geometry.totalAngle[v]);
      EXPECT_EQ(corner.halfedge, h);
      EXPECT_NEAR(corner.angle, angle, 1e-12);
    }
    if (mesh.onBoundary[v]) {
      EXPECT_EQ(cornerOfDirection(geometry, v, -0.1).halfedge, -1);
      EXPECT_EQ(cornerOfDirection(geometry, v, geometry.totalAngle[v] + 0.1).halfedge, -1);
    }
  }
}

}  // namespace
}  // namespace karcher

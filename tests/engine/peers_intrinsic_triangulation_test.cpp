#include <gtest/gtest.h>

#include "generators/plane.h"
#include "peers/intrinsic_triangulation.h"
#include "support.h"

namespace karcher {
namespace {

double totalArea(const IntrinsicTriangulation& triangulation) {
  double area = 0;
  for (int f = 0; f < triangulation.faceCount(); ++f) area += doubleArea(triangulation, f) / 2;
  return area;
}

TEST(IntrinsicTriangulation, OfAMeshHasItsAnglesAndVectors) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const IntrinsicTriangulation triangulation = meshTriangulation(geometry);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    EXPECT_NEAR(cornerAngle(triangulation, h), geometry.cornerAngle[h], 1e-6);
    const double opposite = geometry.cornerAngle[previous(h)];
    EXPECT_NEAR(oppositeCotangent(triangulation, h), 1 / std::tan(opposite), 1e-8);
    EXPECT_EQ(vectorAtHead(triangulation, h), vectorAtTail(triangulation, mesh.twin[h]));
  }
}

TEST(IntrinsicTriangulation, FlipsKeepTheSurface) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  IntrinsicTriangulation triangulation = meshTriangulation(geometry);
  const double area = totalArea(triangulation);
  EXPECT_GT(makeDelaunay(triangulation), 0);
  EXPECT_NEAR(totalArea(triangulation), area, 1e-12 * area);
  Array<double> around(geometry.totalAngle.size(), 0);
  for (int h = 0; h < triangulation.tail.count(); ++h) {
    const int twin = triangulation.twin[h];
    ASSERT_EQ(triangulation.twin[twin], h);
    EXPECT_EQ(triangulation.tail[twin], triangulation.head(h));
    EXPECT_EQ(triangulation.length[twin], triangulation.length[h]);
    EXPECT_GT(oppositeCotangent(triangulation, h) + oppositeCotangent(triangulation, twin), -1e-8);
    around[triangulation.tail[h]] += cornerAngle(triangulation, h);
    // The next half-edge around the tail is ahead by the angle of the corner.
    const int v = triangulation.tail[h];
    const int left = triangulation.twin[previous(h)];
    const double turn = triangulation.direction[left] - triangulation.direction[h];
    const double error = turn - cornerAngle(triangulation, h);
    EXPECT_NEAR(std::remainder(error, geometry.totalAngle[v]), 0, 1e-9);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_NEAR(around[v], geometry.totalAngle[v], 1e-9);
  }
}

TEST(IntrinsicTriangulation, DelaunayOnThePlaneKeepsEdgesStraight) {
  // In the plane a flipped edge still runs from its tail to its head.
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kStretchedRandom, 400, 5));
  const Geometry geometry = buildGeometry(mesh);
  IntrinsicTriangulation triangulation = meshTriangulation(geometry);
  EXPECT_GT(makeDelaunay(triangulation), 0);
  EXPECT_EQ(makeDelaunay(triangulation), 0);
  for (int h = 0; h < triangulation.tail.count(); ++h) {
    const int v = triangulation.tail[h];
    const int first = mesh.outgoing[v];
    const Vec3 along = mesh.positions[triangulation.head(h)] - mesh.positions[v];
    EXPECT_NEAR(triangulation.length[h], along.norm(), 1e-12);
    const Vec3 xAxis = mesh.positions[mesh.head(first)] - mesh.positions[v];
    const double angle = std::atan2(xAxis.cross(along).z(), xAxis.dot(along));
    EXPECT_NEAR(std::remainder(triangulation.direction[h] - angle, 2 * kPi), 0, 1e-9);
  }
}

}  // namespace
}  // namespace karcher

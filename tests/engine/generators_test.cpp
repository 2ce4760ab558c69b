#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "generators/delaunay.h"
#include "generators/flat.h"
#include "generators/marching_tetrahedra.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/smooth_surface.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/geometry.h"
#include "support.h"

namespace karcher {
namespace {

double totalArea(const TriangleSoup& soup) {
  double area = 0;
  for (const Triangle& t : soup.triangles) {
    const Vec3& a = soup.positions[t[0]];
    area += (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).norm() / 2;
  }
  return area;
}

TEST(Delaunay, CirclesOfTrianglesAreEmpty) {
  Random random(7);
  Array<Vec2> points;
  for (int i = 0; i < 200; ++i) points.emplace_back(random.uniform(), random.uniform());
  const Array<Triangle> triangles = delaunay(points);
  for (const Triangle& t : triangles) {
    const Vec2 u = points[t[1]] - points[t[0]];
    const Vec2 v = points[t[2]] - points[t[0]];
    ASSERT_GT(cross(u, v), 0);
    const Vec2 offset = Vec2(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                             u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                        (2 * cross(u, v));
    const Vec2 center = points[t[0]] + offset;
    for (const Vec2& p : points) EXPECT_GE((p - center).norm(), offset.norm() * (1 - 1e-9));
  }
}

TEST(Delaunay, SphereHullHasEveryPointBelowEachFace) {
  const TriangleSoup sphere = randomSphere(400, 3);
  for (const Triangle& t : sphere.triangles) {
    const Vec3& a = sphere.positions[t[0]];
    const Vec3 normal = (sphere.positions[t[1]] - a).cross(sphere.positions[t[2]] - a);
    for (const Vec3& p : sphere.positions) EXPECT_LE(normal.dot(p - a), 1e-12);
  }
}

TEST(PlaneTessellations, CoverTheSquareOnce) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const TriangleSoup soup = tessellatedPlane(tessellation, 2000, 1);
    EXPECT_NEAR(totalArea(soup), 1, 1e-12);
    EXPECT_NEAR(static_cast<double>(soup.triangles.size()), 2000, 100);
    const TriangleMesh mesh = meshOf(soup);
    const Topology t = topology(mesh);
    EXPECT_EQ(t.components, 1);
    EXPECT_EQ(t.boundaryLoops, 1);
    for (const Triangle& f : mesh.faces) {
      const Vec3& a = mesh.positions[f[0]];
      ASSERT_GT((mesh.positions[f[1]] - a).cross(mesh.positions[f[2]] - a).z(), 0);
    }
  }
}

TEST(FlatSurfaces, UnrollWithTheirEdgeLengths) {
  const FlatCylinder cylinder = flatCylinder(40, 2, 1);
  const FlatCone cone = flatCone(40, 4, 1);
  for (const TriangleSoup* soup : {&cylinder.soup, &cone.soup}) {
    const TriangleMesh mesh = meshOf(*soup);
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      const int a = mesh.tail(h);
      const int b = mesh.head(h);
      const double unrolled =
          soup == &cone.soup
              ? coneDistance(cone, cone.unrolled[a], cone.unrolled[b])
              : cylinderDistance(cylinder, cylinder.unrolled[a], cylinder.unrolled[b]);
      EXPECT_NEAR(unrolled, (mesh.positions[a] - mesh.positions[b]).norm(), 1e-13);
    }
  }
  EXPECT_EQ(topology(meshOf(cylinder.soup)).boundaryLoops, 2);
  EXPECT_EQ(topology(meshOf(cone.soup)).boundaryLoops, 1);
}

TEST(FlatSurfaces, AreFlatButForTheApex) {
  const TriangleMesh cylinder = meshOf(flatCylinder(30, 2, 2).soup);
  const TriangleMesh cone = meshOf(flatCone(30, 4, 2).soup);
  for (const TriangleMesh* mesh : {&cylinder, &cone}) {
    const Geometry geometry = buildGeometry(*mesh);
    for (int v = 0; v < mesh->vertexCount(); ++v) {
      if (mesh->onBoundary[v]) continue;
      const double expected = mesh == &cone && v == 0 ? 4 : 2 * kPi;
      EXPECT_NEAR(geometry.totalAngle[v], expected, 1e-12);
    }
  }
}

void expectClosed(const TriangleMesh& mesh, int genus) {
  const Topology t = topology(mesh);
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.boundaryLoops, 0);
  EXPECT_EQ(t.genus, genus);
}

TEST(Spheres, AreClosedOnTheSphereAndFaceOutwards) {
  for (const TriangleSoup& soup : {randomSphere(2000, 1), relaxedSphere(2000, 1),
                                   jitteredUvSphere(2000, 1), marchedSphere(2000)}) {
    expectClosed(meshOf(soup), 0);
    EXPECT_NEAR(static_cast<double>(soup.triangles.size()), 2000, 200);
    double volume = 0;
    for (const Triangle& t : soup.triangles) {
      volume += soup.positions[t[0]].cross(soup.positions[t[1]]).dot(soup.positions[t[2]]) / 6;
    }
    // The hull lies inside the sphere; with 2000 triangles its volume is about a per cent smaller.
    EXPECT_LT(volume, 4 * kPi / 3);
    EXPECT_GT(volume, 0.98 * 4 * kPi / 3);
    for (const Vec3& p : soup.positions) EXPECT_NEAR(p.norm(), 1, 1e-14);
  }
}

/// Random points in [-1, 1]^3.
Vec3 randomInCube(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// A random tangent vector of length up to `most`.
Vec3 randomTangent(const SmoothSurface& surface, const Vec3& p, double most, Random& random) {
  const Vec3 way = surface.normal(p).cross(randomInCube(random));
  return most * random.uniform() * way.normalized();
}

TEST(SmoothSurfaces, HaveTheSpheresMapsWhereAnEllipsoidIsOne) {
  const SmoothSurface sphere = smoothSphere();
  const SmoothSurface ellipsoid = smoothEllipsoid(Vec3(1, 1, 1));
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE("seed 6, case " + std::to_string(i));
    const Vec3 p = sphere.project(randomInCube(random));
    EXPECT_NEAR((ellipsoid.normal(p) - p).norm(), 0, 1e-14);
    const Vec3 v = randomTangent(sphere, p, 1, random);
    const Vec3 q = sphere.exp(p, v);
    EXPECT_NEAR((ellipsoid.exp(p, v) - q).norm(), 0, 1e-9);
    EXPECT_NEAR((ellipsoid.log(p, q) - v).norm(), 0, 1e-9);
  }
}

TEST(SmoothSurfaces, HaveMapsThatUndoEachOtherBothWays) {
  struct Named {
    const char* name;
    SmoothSurface surface;
  };
  for (const auto& [name, surface] :
       {Named{"ellipsoid", smoothEllipsoid(Vec3(1.4, 1, 0.7))}, Named{"saddle", smoothSaddle(0.5)},
        Named{"torus", smoothTorus(kTorusMajor, kTorusMinor)}}) {
    Random random(7);
    for (int i = 0; i < 20; ++i) {
      SCOPED_TRACE(std::string(name) + ", seed 7, case " + std::to_string(i));
      const Vec3 p = surface.project(randomInCube(random));
      const Vec3 v = randomTangent(surface, p, 0.4, random);
      const Vec3 q = surface.exp(p, v);
      EXPECT_NEAR((surface.project(q) - q).norm(), 0, 1e-12);
      EXPECT_NEAR((surface.log(p, q) - v).norm(), 0, 1e-8);
      EXPECT_NEAR(surface.log(q, p).norm(), v.norm(), 1e-8);
    }
  }
}

TEST(Tori, AreClosedOnTheTorus) {
  for (const double stretch : {1.0, 8.0}) {
    const TriangleSoup soup = irregularTorus(4000, stretch, 1);
    expectClosed(meshOf(soup), 1);
    EXPECT_EQ(soup.triangles.size(), 4000u);
    for (const Vec3& p : soup.positions) EXPECT_NEAR((closestOnTorus(p) - p).norm(), 0, 1e-14);
    // The triangles of the stretched one are chords of longer arcs.
    EXPECT_NEAR(totalArea(soup), 4 * kPi * kPi * kTorusMajor * kTorusMinor, stretch > 1 ? 1 : 0.1);
  }
}

/// The root mean square of the edges' extents along the circle of centers, divided by that across
/// it.
double meanStretch(const TriangleSoup& soup) {
  double along = 0;
  double across = 0;
  for (const Triangle& t : soup.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 edge = soup.positions[t[(k + 1) % 3]] - soup.positions[t[k]];
      const Vec3 middle = soup.positions[t[(k + 1) % 3]] + soup.positions[t[k]];
      const double part = Vec3(-middle.y(), middle.x(), 0).normalized().dot(edge);
      along += part * part;
      across += edge.squaredNorm() - part * part;
    }
  }
  return std::sqrt(along / across);
}

TEST(Tori, AreStretchedAsAsked) {
  // The random directions of 12,000 edges cause an error of about a per cent.
  EXPECT_NEAR(meanStretch(irregularTorus(8000, 1, 1)), 1, 0.03);
  EXPECT_NEAR(meanStretch(irregularTorus(8000, 8, 1)), 8, 0.24);
}

TEST(Generators, AreTheSameForTheSameSeed) {
  const TriangleSoup a = relaxedSphere(500, 11);
  const TriangleSoup b = relaxedSphere(500, 11);
  EXPECT_TRUE(a.triangles == b.triangles);
  EXPECT_TRUE(a.positions == b.positions);
  EXPECT_FALSE(a.positions == relaxedSphere(500, 12).positions);
}

}  // namespace
}  // namespace karcher

#include "mesh/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "mesh/error.h"
#include "mesh/triangle_mesh.h"
#include "support.h"

namespace karcher {
namespace {

Vec3 areaVector(const TriangleMesh& mesh, int f) {
  const Vec3& a = mesh.positions[mesh.corner(f, 0)];
  return (mesh.positions[mesh.corner(f, 1)] - a).cross(mesh.positions[mesh.corner(f, 2)] - a) / 2;
}

double enclosedVolume(const TriangleMesh& mesh) {
  double volume = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    volume += mesh.positions[mesh.corner(f, 0)].dot(areaVector(mesh, f)) / 3;
  }
  return volume;
}

double smallestAngle(const TriangleMesh& mesh) {
  double smallest = kPi;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Vec3& a = mesh.positions[mesh.corner(f, k)];
      const Vec3 u = mesh.positions[mesh.corner(f, (k + 1) % 3)] - a;
      const Vec3 v = mesh.positions[mesh.corner(f, (k + 2) % 3)] - a;
      smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return smallest;
}

TEST(Shapes, HaveTheGivenNumberOfTriangles) {
  for (const Shape shape : kShapes) {
    for (const int triangles : {500, 801, 2000, 5000, 30000}) {
      SCOPED_TRACE(std::string(shapeName(shape)) + " " + std::to_string(triangles));
      const double ratio =
          static_cast<double>(makeShape(shape, triangles).triangles.size()) / triangles;
      const double slack = shape == Shape::kGenus3 ? 0.5 : triangles < 2000 ? 0.12 : 0.05;
      EXPECT_LE(ratio, 1 + slack);
      EXPECT_GE(ratio, 1 / (1 + slack));
    }
  }
}

TEST(Shapes, HaveTheirTopologyAtEverySize) {
  for (const int triangles : {500, 3000, 20000}) {
    for (const Shape shape : kShapes) {
      SCOPED_TRACE(std::string(shapeName(shape)) + " " + std::to_string(triangles));
      const Topology t = topology(meshOf(makeShape(shape, triangles)));
      EXPECT_EQ(t.components, 1);
      EXPECT_EQ(t.boundaryLoops, shape == Shape::kOpenSheet ? 1 : 0);
      const int genus = shape == Shape::kGenus3                           ? 3
                        : shape == Shape::kTorus || shape == Shape::kKnot ? 1
                                                                          : 0;
      EXPECT_EQ(t.genus, genus);
    }
  }
}

TEST(Shapes, HaveWellShapedTriangles) {
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(shapeName(shape));
    for (const int triangles : {500, 3000, 20000}) {
      EXPECT_GT(smallestAngle(meshOf(makeShape(shape, triangles))) * 180 / kPi, 22);
    }
  }
}

/// Neighbouring faces of a fine smooth surface are nearly parallel, without folds and creases.
TEST(Shapes, AreSmooth) {
  for (const Shape shape : kShapes) {
    SCOPED_TRACE(shapeName(shape));
    const TriangleMesh mesh = meshOf(makeShape(shape, 30000));
    double least = 1;
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      if (mesh.twin[h] < 0) continue;
      const Vec3 a = areaVector(mesh, faceOf(h)).normalized();
      const Vec3 b = areaVector(mesh, faceOf(mesh.twin[h])).normalized();
      least = std::min(least, a.dot(b));
    }
    EXPECT_GT(least, std::cos(15 * kPi / 180));
  }
}

TEST(Shapes, EncloseTheVolumeOfTheSmoothSurface) {
  const auto volume = [](Shape shape) { return enclosedVolume(meshOf(makeShape(shape, 30000))); };
  EXPECT_NEAR(volume(Shape::kSphere), 4 * kPi / 3, 0.005);
  EXPECT_NEAR(volume(Shape::kTorus), 2 * kPi * kPi * kTorusMajor * kTorusMinor * kTorusMinor, 0.01);
  // A tube's volume is its cross section times the length of its axis (Pappus), here 9.6087.
  EXPECT_NEAR(volume(Shape::kKnot), kPi * 0.15 * 0.15 * 9.6087, 0.005);
  EXPECT_GT(volume(Shape::kGenus3), 0);
}

TEST(Shapes, LieOnTheirSurfaces) {
  for (const Vec3& p : makeShape(Shape::kSphere, 5000).positions) EXPECT_NEAR(p.norm(), 1, 1e-14);
  for (const Vec3& p : makeShape(Shape::kTorus, 5000).positions) {
    const double tube = std::hypot(std::hypot(p.x(), p.y()) - kTorusMajor, p.z());
    EXPECT_NEAR(tube, kTorusMinor, 1e-14);
  }
}

/// The map to the torus is conformal, with the distance from the axis as its factor: checked by
/// central differences.
TEST(ConformalTorus, KeepsAngles) {
  constexpr double kStep = 1e-5;
  for (const double y : {0.0, 0.3, 1.0, 2.0, 2.7}) {
    const auto difference = [&](const Vec2& d) {
      return Vec3(
          (conformalTorus(Vec2(0.7, y) + kStep * d) - conformalTorus(Vec2(0.7, y) - kStep * d)) /
          (2 * kStep));
    };
    const Vec3 alongX = difference({1, 0});
    const Vec3 alongY = difference({0, 1});
    EXPECT_NEAR(alongX.dot(alongY), 0, 1e-8);
    const double scale = conformalTorus({0, y}).x();
    EXPECT_NEAR(alongX.norm(), scale, 1e-8);
    EXPECT_NEAR(alongY.norm(), scale, 1e-8);
  }
  EXPECT_NEAR((conformalTorus(Vec2(1, 0.4)) - conformalTorus(Vec2(1, 0.4 + kTorusPeriod))).norm(),
              0, 1e-14);
}

TEST(Shapes, RefuseCountsOutOfRange) {
  for (const int triangles : {-1, 0, 499, 1'000'001}) {
    try {
      makeShape(Shape::kTorus, triangles);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadArgument);
      EXPECT_EQ(error.what(),
                "a shape has 500 to 1000000 triangles, not " + std::to_string(triangles));
    }
  }
}

}  // namespace
}  // namespace karcher

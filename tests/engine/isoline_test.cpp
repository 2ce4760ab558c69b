#include "curves/isoline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "distance/shortest_path.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// Checks lines: consecutive points share a face, and closed lines are closed.
void expectSound(const TriangleMesh& mesh, const Array<Isoline>& lines, double meanEdge) {
  for (const Isoline& line : lines) {
    double length = 0;
    for (int i = 1; i < line.points.count(); ++i) {
      const Vec3 step = position(mesh, line.points[i]) - position(mesh, line.points[i - 1]);
      // Where two arcs meet their ends differ by rounding and may lie in different faces.
      if (step.norm() > 1e-6 * meanEdge) {
        EXPECT_TRUE(haveCommonFace(mesh, line.points[i - 1], line.points[i]));
      }
      length += step.norm();
    }
    EXPECT_NEAR(length, line.length, 0.01 * line.length);
    const Vec3 ends = position(mesh, line.points.back()) - position(mesh, line.points.front());
    if (line.closed) {
      EXPECT_LT(ends.norm(), 1e-6 * meanEdge);
    }
  }
}

TEST(Isoline, TheExactIsolineOfThePlaneIsTheCircle) {
  const TriangleMesh mesh = planeGrid(24, 20);
  const Geometry geometry = buildGeometry(mesh);
  // The source lies in a face, on an edge and at a vertex; circles are within a face or wider.
  for (const Vec3& center : {Vec3(11.3, 9.8, 0), Vec3(11.5, 9, 0), Vec3(12, 10, 0)}) {
    for (const double radius : {0.05, 0.7, 2.6, 8.9}) {
      const Array<Isoline> lines = exactIsolines(geometry, nearestPoint(mesh, center), radius);
      ASSERT_EQ(lines.count(), 1);
      EXPECT_TRUE(lines[0].closed);
      EXPECT_NEAR(lines[0].length, 2 * kPi * radius, 1e-7);
      for (const SurfacePoint& point : lines[0].points) {
        // The tolerance is the rounding of images across at most a hundred edges.
        EXPECT_NEAR((position(mesh, point) - center).norm(), radius, 1e-12);
      }
      expectSound(mesh, lines, geometry.meanEdge);
    }
  }
}

TEST(Isoline, EndsAtTheBoundaryAndTurnsAroundItsCorners) {
  // Behind the inner corner the circle continues around the corner.
  const TriangleMesh mesh = gridWithCorner();
  const Geometry geometry = buildGeometry(mesh);
  const Vec3 center(2, 10, 0);
  const double toCorner = std::sqrt(4.0 + 36);
  const double radius = 8;
  const Array<Isoline> lines = exactIsolines(geometry, nearestPoint(mesh, center), radius);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_FALSE(lines[0].closed);
  int bent = 0;
  for (const SurfacePoint& point : lines[0].points) {
    const Vec3 x = position(mesh, point);
    // These points lie behind the line from the center through the corner (4, 4).
    const bool behind = cross(Vec2(2, -6), Vec2(x.x() - 2, x.y() - 10)) > 0;
    bent += behind;
    const double way = behind ? toCorner + (x - Vec3(4, 4, 0)).norm() : (x - center).norm();
    EXPECT_NEAR(way, radius, 1e-11);
  }
  EXPECT_GT(bent, 2);
}

TEST(Isoline, ExactIsolinesLieAtTheirDistanceOnEveryShape) {
  const uint64_t seed = 11;
  SCOPED_TRACE("seed 11");
  Random random(seed);
  for (const Shape shape : kShapes) {
    const TriangleMesh mesh = importMesh(makeShape(shape, 1000)).mesh;
    const Geometry geometry = buildGeometry(mesh);
    for (const double part : {0.05, 0.15, 0.3, 0.5}) {
      const SurfacePoint source{random.index(mesh.faceCount()), Vec3(0.2, 0.3, 0.5)};
      const double radius = part * geometry.diagonal;
      const Array<Isoline> lines = exactIsolines(geometry, source, radius);
      SCOPED_TRACE(std::string(shapeName(shape)) + ", " + std::to_string(part));
      expectSound(mesh, lines, geometry.meanEdge);
      for (const Isoline& line : lines) {
        EXPECT_TRUE(line.closed || shape == Shape::kOpenSheet);
        for (int i = 0; i < line.points.count(); i += 7) {
          EXPECT_NEAR(shortestPath(geometry, source, line.points[i]).length(), radius,
                      1e-8 * geometry.diagonal);
        }
      }
    }
  }
}

TEST(Isoline, PathsToPointsBesideExactIsolinesHaveTheirLength) {
  // From this source many paths pass a vertex so closely that only rounding decides whether they
  // turn there.
  const TriangleMesh mesh = importMesh(makeShape(Shape::kTorus, 2000)).mesh;
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint source =
      nearestPoint(mesh, Vec3(0.0731300322085814, -0.6585955530363606, 0.2150883328756446));
  const double radius = 1.6;
  const Array<Isoline> lines = exactIsolines(geometry, source, radius);
  EXPECT_EQ(lines.count(), 2);
  for (const Isoline& line : lines) {
    for (int i = 0; i < line.points.count(); i += 5) {
      const SurfacePoint& on = line.points[i];
      const SurfacePoint beside{on.face, (1 - 1e-7) * on.bary + Vec3::Constant(1e-7 / 3)};
      const double moved = (position(mesh, beside) - position(mesh, on)).norm();
      const double length = shortestPath(geometry, source, beside).length();
      EXPECT_NEAR(length, radius, moved + 1e-8 * geometry.diagonal);
      EXPECT_NEAR(shortestPath(geometry, beside, source).length(), length, 1e-9 * length);
    }
  }
}

TEST(Isoline, FarExactIsolinesAreClosedOnAClosedSurface) {
  // Far from the source many arcs graze edges and rays, where rounding moves their ends the most.
  const uint64_t seed = 12;
  SCOPED_TRACE("seed 12");
  Random random(seed);
  for (const Shape shape : {Shape::kKnot, Shape::kGenus3}) {
    const TriangleMesh mesh = importMesh(makeShape(shape, 20'000)).mesh;
    const Geometry geometry = buildGeometry(mesh);
    for (const double part : {0.4, 0.6}) {
      const SurfacePoint source{random.index(mesh.faceCount()), Vec3(0.3, 0.3, 0.4)};
      SCOPED_TRACE(std::string(shapeName(shape)) + ", " + std::to_string(part));
      const double radius = part * geometry.diagonal;
      double length = 0;
      for (const Isoline& line : exactIsolines(geometry, source, radius)) {
        EXPECT_TRUE(line.closed);
        length += line.length;
      }
      WindowDistance distance(geometry);
      distance.setSource(source);
      distance.grow(kInfinity);
      Array<double> distances;
      for (int v = 0; v < mesh.vertexCount(); ++v) distances.push_back(distance.distance(v));
      double linear = 0;
      for (const Isoline& line : linearIsolines(mesh, distances, radius)) {
        linear += line.length;
      }
      // The linear ones cut the corners where fronts meet.
      EXPECT_NEAR(length, linear, 0.05 * length);
    }
  }
}

TEST(Isoline, AroundTheTipOfANeedleIsAsLongAsItsAngle) {
  // Every face is narrower than the accuracy of arcs' ends where they graze an edge.
  const double height = 1e4;
  const TriangleSoup needle = wheel(5'000, 0, height);
  const TriangleMesh mesh = buildMesh(needle.positions, needle.triangles);
  const Geometry geometry = buildGeometry(mesh);
  const double radius = 0.3 * height;
  const Array<Isoline> lines = exactIsolines(geometry, vertexPoint(mesh, 0), radius);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_TRUE(lines[0].closed);
  EXPECT_NEAR(lines[0].length, radius * geometry.totalAngle[0], 1e-6 * lines[0].length);
}

TEST(Isoline, ExactIsolinesLeaveNoFragments) {
  // The surface has saddle vertices, where paths bend and one corner may be nearest for whole
  // faces.
  const TriangleMesh mesh = importMesh(makeShape(Shape::kGenus3, 1000)).mesh;
  const Geometry geometry = buildGeometry(mesh);
  for (int i = 0; i < 40; ++i) {
    const SurfacePoint source{i * 7919 % mesh.faceCount(), Vec3(0.3, 0.3, 0.4)};
    for (const double part : {0.1, 0.2, 0.3, 0.4}) {
      SCOPED_TRACE("face " + std::to_string(source.face) + ", " + std::to_string(part));
      for (const Isoline& line : exactIsolines(geometry, source, part * geometry.diagonal)) {
        EXPECT_TRUE(line.closed);
      }
    }
  }
}

TEST(Isoline, LinearIsolinesOfALinearFunctionAreStraight) {
  const TriangleMesh mesh = planeGrid(6, 5);
  Array<double> values;
  for (const Vec3& p : mesh.positions) values.push_back(p.x() + 0.1 * p.y());
  const Array<Isoline> lines = linearIsolines(mesh, values, 2.5);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_FALSE(lines[0].closed);
  EXPECT_NEAR(lines[0].length, 5 * std::sqrt(1.01), 1e-12);
  for (const SurfacePoint& point : lines[0].points) {
    const Vec3 x = position(mesh, point);
    EXPECT_NEAR(x.x() + 0.1 * x.y(), 2.5, 1e-12);
  }
}

TEST(Isoline, LinearIsolinesAreClosedOnAClosedSurface) {
  const TriangleMesh mesh = importMesh(icosphere(8)).mesh;
  Array<double> values;
  for (const Vec3& p : mesh.positions) values.push_back(std::abs(p.z()));
  const Array<Isoline> lines = linearIsolines(mesh, values, 0.55);
  ASSERT_EQ(lines.count(), 2);
  for (const Isoline& line : lines) EXPECT_TRUE(line.closed);
  expectSound(mesh, lines, 0.1);
}

TEST(Isoline, LinearIsolinesHaveSmallerValuesOnTheirLeft) {
  const TriangleMesh mesh = planeGrid(12, 12);
  const Vec3 center(5.3, 6.2, 0);
  Array<double> values;
  for (const Vec3& p : mesh.positions) values.push_back((p - center).norm());
  // Around the center lines run counterclockwise, also those that end on the boundary.
  for (const double radius : {0.7, 3.1, 6.8}) {
    const Array<Isoline> lines = linearIsolines(mesh, values, radius);
    ASSERT_FALSE(lines.empty());
    for (const Isoline& line : lines) {
      double turned = 0;
      for (int i = 1; i < line.points.count(); ++i) {
        const Vec3 a = position(mesh, line.points[i - 1]) - center;
        const Vec3 b = position(mesh, line.points[i]) - center;
        turned += a.x() * b.y() - a.y() * b.x();
      }
      EXPECT_GT(turned, 0) << radius;
    }
  }
}

TEST(Isoline, RefusesInvalidDistances) {
  const TriangleMesh mesh = planeGrid(3, 3);
  const Geometry geometry = buildGeometry(mesh);
  for (const double radius : {0.0, -1.0, std::nan(""), kInfinity}) {
    EXPECT_EQ(codeOf([&] {
                exactIsolines(geometry, {0, {1, 0, 0}}, radius);
              }),
              ErrorCode::kBadArgument);
  }
}

TEST(Isoline, LinearIsolinesRefuseInvalidLevels) {
  const TriangleMesh mesh = planeGrid(3, 3);
  const Array<double> values(static_cast<size_t>(mesh.vertexCount()), 1.0);
  for (const double radius : {0.0, -1.0, std::nan(""), kInfinity}) {
    EXPECT_EQ(codeOf([&] { linearIsolines(mesh, values, radius); }), ErrorCode::kBadArgument);
  }
}

TEST(Isoline, LinearIsolinesOfLength0AreLeftOut) {
  // Two vertices lie below the level by rounding only, one of them on the boundary.
  const TriangleMesh mesh = planeGrid(6, 6);
  for (const double below : {1e-16, 1e-13}) {
    Array<double> values(static_cast<size_t>(mesh.vertexCount()), 2.0);
    for (const int v : {3, 24}) values[v] = 1 - below;
    EXPECT_TRUE(linearIsolines(mesh, values, 1).empty());
    values[24] = 0.5;
    EXPECT_EQ(linearIsolines(mesh, values, 1).count(), 1);
  }
}

}  // namespace
}  // namespace karcher

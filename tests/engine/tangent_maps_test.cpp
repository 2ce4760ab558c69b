#include "distance/tangent_maps.h"

#include <gtest/gtest.h>

#include "generators/random.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

SurfacePoint somewhere(const TriangleMesh& mesh, Random& random) {
  const double u = random.uniform(0, 1);
  const double v = random.uniform(0, 1 - u);
  return {static_cast<int>(random.uniform(0, mesh.faceCount())), Vec3(1 - u - v, u, v)};
}

TEST(TangentMaps, OnThePlaneAreDifferencesAndSums) {
  const TriangleMesh mesh = planeGrid(9, 7);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const uint64_t seed = 20261122;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint from = somewhere(mesh, random);
    const SurfacePoint to = somewhere(mesh, random);
    const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const LogMapped log =
        logMap(geometry, from, to, tangentFromSpace(geometry, to, way), workspace);
    const Vec3 vector = tangentToSpace(geometry, from, log.vector);
    EXPECT_LT((position(mesh, from) + vector - position(mesh, to)).norm(), 1e-12);
    EXPECT_LT((tangentToSpace(geometry, from, log.direction) - way).norm(), 1e-11);
    const ExpMapped exp = expMap(geometry, from, log.vector, log.direction);
    EXPECT_LT((position(mesh, exp.point) - position(mesh, to)).norm(), 1e-12);
    EXPECT_LT((tangentToSpace(geometry, exp.point, exp.direction) - way).norm(), 1e-11);
    EXPECT_LT(exp.remaining, 1e-12);
  }
}

TEST(TangentMaps, CarryAVectorAroundACornerOfTheBoundary) {
  // The path bends around the vertex (4, 4) on a plane: vectors do not change.
  const TriangleMesh mesh = gridWithCorner();
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint from = nearestPoint(mesh, Vec3(2.3, 10.1, 0));
  const SurfacePoint to = nearestPoint(mesh, Vec3(11.2, 1.4, 0));
  FindPathWorkspace workspace;
  const SurfacePath path = pathBetween(geometry, from, to, workspace);
  const Vec3 way(0.3, -0.8, 0);
  const Vec2 carried = transportAlong(geometry, path, tangentFromSpace(geometry, from, way));
  EXPECT_LT((tangentToSpace(geometry, to, carried) - way).norm(), 1e-12);
}

TEST(TangentMaps, TransportKeepsLengthsAndAnglesAndComesBack) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kKnot, 4000));
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const uint64_t seed = 20261123;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 50; ++i) {
    const SurfacePoint from = somewhere(mesh, random);
    const SurfacePoint to = somewhere(mesh, random);
    const SurfacePath path = pathBetween(geometry, from, to, workspace);
    const Vec2 a(random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec2 b(random.uniform(-1, 1), random.uniform(-1, 1));
    const Vec2 there = transportAlong(geometry, path, a);
    EXPECT_NEAR(there.dot(transportAlong(geometry, path, b)), a.dot(b), 1e-12);
    const Vec2 back = transportAlong(geometry, reversed(path), there);
    EXPECT_LT((back - a).norm(), 1e-9);
  }
}

TEST(TangentMaps, AVectorInTheFrameOfAVertexGoesToSpaceAndBack) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kSphere, 500));
  const Geometry geometry = buildGeometry(mesh);
  const Vec2 vector(0.3, -0.4);
  for (int f = 0; f < mesh.faceCount(); f += 7) {
    for (int k = 0; k < 3; ++k) {
      SurfacePoint point{f, Vec3::Zero()};
      point.bary[k] = 1;
      const Vec3 space = tangentToSpace(geometry, point, vector);
      EXPECT_NEAR(space.norm(), 0.5, 1e-14);
      EXPECT_LT((tangentFromSpace(geometry, point, space) - vector).norm(), 1e-14);
    }
  }
}

TEST(TangentMaps, MirrorOnThePlaneReflects) {
  const TriangleMesh mesh = planeGrid(10, 10);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const SurfacePath line = pathBetween(geometry, nearestPoint(mesh, Vec3(5, 0, 0)),
                                       nearestPoint(mesh, Vec3(5, 10, 0)), workspace);
  Random random(20261124);
  for (int i = 0; i < 50; ++i) {
    const SurfacePoint point = somewhere(mesh, random);
    const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const ExpMapped image =
        mirrored(geometry, line, point, tangentFromSpace(geometry, point, way), workspace);
    const Vec3 here = position(mesh, point);
    EXPECT_LT((position(mesh, image.point) - Vec3(10 - here.x(), here.y(), 0)).norm(), 1e-9);
    const Vec3 reflected = tangentToSpace(geometry, image.point, image.direction);
    EXPECT_LT((reflected - Vec3(-way.x(), way.y(), 0)).norm(), 1e-9);
  }
}

TEST(TangentMaps, MirrorHasPointsOfALinesEndsAndOfThePerpendicularsThere) {
  const TriangleMesh mesh = planeGrid(10, 10);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const uint64_t seed = 20261127;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const auto place = [&] { return Vec3(random.uniform(3, 7), random.uniform(3, 7), 0); };
  for (int i = 0; i < 40; ++i) {
    const Vec3 ends[] = {place(), place()};
    const SurfacePath line =
        pathBetween(geometry, nearestPoint(mesh, ends[0]), nearestPoint(mesh, ends[1]), workspace);
    const Vec3 across = (ends[1] - ends[0]).normalized().cross(Vec3::UnitZ());
    for (const Vec3& end : ends) {
      for (const double far : {0.0, 0.4, 2.5}) {
        const SurfacePoint point = nearestPoint(mesh, end + far * across);
        const ExpMapped image = mirrored(geometry, line, point, Vec2::Zero(), workspace);
        EXPECT_LT((position(mesh, image.point) - (end - far * across)).norm(), 1e-9);
      }
    }
  }
}

TEST(TangentMaps, NoPerpendicularLeadsFromBeyondALinesEnd) {
  const TriangleMesh mesh = planeGrid(10, 10);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const SurfacePath line = pathBetween(geometry, nearestPoint(mesh, Vec3(5, 5, 0)),
                                       nearestPoint(mesh, Vec3(5, 8, 0)), workspace);
  const auto mirror = [&](const Vec3& place) {
    mirrored(geometry, line, nearestPoint(mesh, place), Vec2::Zero(), workspace);
  };
  EXPECT_EQ(codeOf([&] { mirror(Vec3(6, 2, 0)); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { mirror(Vec3(6, 9.5, 0)); }), ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

#include "distance/tangent_maps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "distance/shortest_path.h"
#include "distance/source_vectors.h"
#include "generators/flat.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "mesh/split_triangles.h"
#include "rcm/field_options.h"
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

TEST(TangentMaps, OnThePlaneCarryDirectionsToAndFromEdgesAndVertices) {
  const TriangleMesh mesh = gridWithCorner();
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const uint64_t seed = 20261130;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int straight = 0;
  for (int i = 0; i < 400; ++i) {
    const SurfacePoint from = randomPlace(mesh, random);
    const SurfacePoint to = randomPlace(mesh, random);
    const Vec3 way = position(mesh, to) - position(mesh, from);
    const Vec3 carried(random.uniform(-1, 1), random.uniform(-1, 1), 0);
    const LogMapped log =
        logMap(geometry, from, to, tangentFromSpace(geometry, to, carried), workspace);
    EXPECT_LT((tangentToSpace(geometry, from, log.direction) - carried).norm(), 1e-11);
    // The other paths turn at the corner of the boundary.
    if (log.vector.norm() > way.norm() + 1e-9 || way.norm() == 0) continue;
    ++straight;
    EXPECT_LT((tangentToSpace(geometry, from, log.vector) - way).norm(), 1e-11);
    const ExpMapped exp = expMap(geometry, from, log.vector, log.direction);
    EXPECT_LT((position(mesh, exp.point) - position(mesh, to)).norm() + exp.remaining, 1e-11);
    EXPECT_LT((tangentToSpace(geometry, exp.point, exp.direction) - carried).norm(), 1e-11);
    SurfacePath path = expAlong(geometry, from, log.vector);
    measure(mesh, path);
    const Vec2 along = transportAlong(geometry, path, log.direction);
    EXPECT_LT((tangentToSpace(geometry, path.end(), along) - carried).norm(), 1e-11);
  }
  EXPECT_GT(straight, 200);
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

/// A fan of triangles around vertex 0, each cut into 9. Vertex i is at the angle `step` i around
/// the axis, at the height `lift` cos(2 `step` i).
TriangleMesh fanAround(int rays, double step, double lift, bool isOpen) {
  TriangleSoup fan;
  fan.positions.push_back(Vec3::Zero());
  for (int i = 0; i < rays; ++i) {
    const Vec2 ray = unitVector(step * i);
    fan.positions.push_back(Vec3(ray.x(), ray.y(), lift * std::cos(2 * step * i)));
    if (!isOpen || i + 1 < rays) fan.triangles.push_back({0, i + 1, (i + 1) % rays + 1});
  }
  return meshOf(splitTriangles(meshOf(fan), 3));
}

/// The distance of a point of a fan from vertex 0, and its direction there.
struct OnFan {
  double radius;
  double direction;
};
OnFan onFan(const Geometry& geometry, const SurfacePoint& point) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Vec3 place = position(mesh, point);
  OnFan result{place.norm(), 0};
  double least = kInfinity;
  for (const int h : outgoingHalfedges(mesh, 0)) {
    const Vec3& right = mesh.positions[mesh.head(h)];
    const Vec3& left = mesh.positions[mesh.tail(previous(h))];
    const auto angleFrom = [&](const Vec3& ray) {
      return std::atan2(ray.cross(place).norm(), ray.dot(place));
    };
    const double excess = angleFrom(right) + angleFrom(left) - geometry.cornerAngle[h];
    if (excess >= least) continue;
    least = excess;
    result.direction = geometry.cumulatedAngle[h] + angleFrom(right);
  }
  return result;
}

/// The difference of two directions at one place, which may be given in different faces.
double differenceAt(const Geometry& geometry, const SurfacePoint& a, const Vec2& atA,
                    const SurfacePoint& b, const Vec2& atB) {
  const PointLocation place = locate(*geometry.mesh, a);
  if (place.simplex != locate(*geometry.mesh, b).simplex) return kInfinity;
  const bool isSame = a.face == b.face || place.simplex != Simplex::kEdge;
  return ((isSame ? atA : acrossEdge(geometry, place.halfedge, atA)) - atB).norm();
}

TEST(TangentMaps, AroundCornersConesAndSaddlesAreInverseToEachOther) {
  const TriangleMesh fans[] = {fanAround(4, kPi / 6, 0, true),
                               fanAround(9, 1.5 * kPi / 8, 0, true),
                               fanAround(11, 0.19 * kPi, 0, true),
                               fanAround(7, kPi / 6, 0.4, true),
                               fanAround(8, kPi / 4, 0, false),
                               fanAround(16, kPi / 8, 0.9, false),
                               meshOf(splitTriangles(meshOf(flatCone(5, 4, 6).soup), 3))};
  const uint64_t seed = 20261201;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const TriangleMesh& mesh : fans) {
    const Geometry geometry = buildGeometry(mesh);
    const double total = geometry.totalAngle[0];
    SCOPED_TRACE("a total angle of " + std::to_string(total));
    FindPathWorkspace workspace;
    const SurfacePoint apex = vertexPoint(mesh, 0);
    const auto expectInverse = [&](const SurfacePoint& from, const SurfacePoint& to) {
      const Vec2 carried = unitVector(random.uniform(0, 2 * kPi));
      const LogMapped log = logMap(geometry, from, to, carried, workspace);
      const ExpMapped exp = expMap(geometry, from, log.vector, log.direction);
      EXPECT_LT((position(mesh, exp.point) - position(mesh, to)).norm() + exp.remaining, 1e-11);
      EXPECT_LT(differenceAt(geometry, exp.point, exp.direction, to, carried), 1e-9);
      return log.vector;
    };
    for (int i = 0; i < 60; ++i) {
      const SurfacePoint p = randomPlace(mesh, random);
      const SurfacePoint q = randomPlace(mesh, random);
      const OnFan ofP = onFan(geometry, p);
      const OnFan ofQ = onFan(geometry, q);
      if (ofP.radius == 0 || ofQ.radius == 0) continue;
      const Vec2 fromApex = ofP.radius * unitVector(geometry.angleScale[0] * ofP.direction);
      EXPECT_LT((expectInverse(apex, p) - fromApex).norm(), 1e-12);
      EXPECT_NEAR(expectInverse(p, apex).norm(), ofP.radius, 1e-12);
      double apart = std::abs(ofP.direction - ofQ.direction);
      if (!mesh.onBoundary[0]) apart = std::min(apart, total - apart);
      // A path around the apex turns there, which the exp map does not.
      if (apart > kPi - 1e-3) continue;
      const double squared =
          square(ofP.radius) + square(ofQ.radius) - 2 * ofP.radius * ofQ.radius * std::cos(apart);
      EXPECT_NEAR(expectInverse(p, q).norm(), std::sqrt(std::max(0.0, squared)), 1e-7);
    }
  }
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

/// Compares the log vectors of all vertices with the first directions of exact shortest paths, for
/// flat surfaces.
void expectVectorsOfShortestPaths(Surface& surface, const SurfacePoint& source, Solver solver,
                                  double tolerance) {
  const Geometry& geometry = surface.geometry();
  const TriangleMesh& mesh = surface.mesh();
  const auto distance = makeDistanceSolver(surface, {Method::kKarcher, solver, 6});
  distance->setSource(source);
  distance->grow(kInfinity);
  SourceVectors vectors(geometry);
  vectors.setSource(source);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const SurfacePath path = shortestPath(geometry, source, vertexPoint(mesh, v));
    const Vec2 log = logAlong(geometry, path);
    EXPECT_LT((vectors.at(*distance, v) - log).norm(), tolerance * (1 + log.norm()))
        << "vertex " << v << " at " << mesh.positions[v].transpose();
  }
}

TEST(SourceVectors, WithinARadiusAreThoseWithoutIt) {
  // The grid is so oblique that the last edge on a path may end far beyond the radius.
  Array<Vec3> positions;
  for (int j = 0; j <= 12; ++j) {
    for (int i = 0; i <= 12; ++i) positions.emplace_back(i + 3 * j, j, 0);
  }
  const TriangleMesh mesh = buildMesh(positions, planeGrid(12, 12).faces);
  Surface surface(mesh);
  const SurfacePoint source{156, Vec3(0.3, 0.3, 0.4)};
  const double radius = 2.5;
  for (const Solver solver : {Solver::kFast, Solver::kExact}) {
    const auto distance = makeDistanceSolver(surface, {Method::kKarcher, solver, 6});
    distance->setSource(source);
    distance->grow(radius);
    SourceVectors vectors(surface.geometry());
    vectors.setSource(source);
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (distance->distance(v) > radius) continue;
      ++count;
      const Vec2 way =
          toFace(surface.geometry(), source.face, mesh.positions[v] - position(mesh, source));
      EXPECT_LT((vectors.at(*distance, v) - way).norm(), 1e-9) << "vertex " << v;
    }
    EXPECT_GT(count, 10);
  }
}

TEST(SourceVectors, BehindATurnHaveTheDirectionOfTheTurn) {
  Array<Triangle> faces;
  const TriangleMesh grid = planeGrid(24, 24);
  for (const Triangle& face : grid.faces) {
    Vec3 middle = Vec3::Zero();
    for (const int v : face) middle += grid.positions[v] / 3;
    const bool isHole = middle.x() > 8 && middle.x() < 12 && middle.y() > 9 && middle.y() < 11;
    if (!isHole) faces.push_back(face);
  }
  // The hole's inner vertices have no faces.
  Array<Vec3> positions;
  Array<int> number(grid.positions.size(), -1);
  for (Triangle& face : faces) {
    for (int& v : face) {
      if (number[v] < 0) {
        number[v] = positions.count();
        positions.push_back(grid.positions[v]);
      }
      v = number[v];
    }
  }
  Surface surface(buildMesh(positions, faces));
  const SurfacePoint source = nearestPoint(surface.mesh(), Vec3(9.3, 3.2, 0));
  const auto distance = makeDistanceSolver(surface, {Method::kKarcher, Solver::kExact, 6});
  distance->setSource(source);
  distance->grow(kInfinity);
  SourceVectors vectors(surface.geometry());
  vectors.setSource(source);
  const Vec2& vector = vectors.at(*distance, number[11 + 25 * 20]);
  const Vec2 turn = toFace(surface.geometry(), source.face, Vec3(8 - 9.3, 9 - 3.2, 0));
  EXPECT_LT((vector.normalized() - turn.normalized()).norm(), 1e-9);
  const uint64_t seed = 20261127;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 3; ++i) {
    const SurfacePoint place = somewhere(surface.mesh(), random);
    expectVectorsOfShortestPaths(surface, place, Solver::kExact, 1e-9);
  }
}

/// A tube of triangles that are congruent to (0, 0), (1, 0), (1 + shear, 1), so that it is flat.
/// The rows have `count` edges. Each row is turned against the previous one.
TriangleMesh obliqueTube(int count, int rows, double shear) {
  const double half = std::sin(kPi / count);
  const double radius = 0.5 / half;
  const double turn = std::asin((1 + 2 * shear) * half) - kPi / count;
  const double rise = std::sqrt(square(shear) + 1 - square(2 * radius * std::sin(turn / 2)));
  Array<Vec3> positions;
  Array<Triangle> faces;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < count; ++i) {
      const Vec2 place = radius * unitVector(2 * kPi * i / count + j * turn);
      positions.emplace_back(place.x(), place.y(), j * rise);
      if (j == rows) continue;
      const int a = count * j + i;
      const int b = count * j + (i + 1) % count;
      faces.emplace_back(a, b, b + count);
      faces.emplace_back(a, b + count, a + count);
    }
  }
  return buildMesh(positions, faces);
}

TEST(SourceVectors, OnATubeAndAConeAreThoseOfShortestPaths) {
  Surface tube(obliqueTube(20, 24, 0.3));
  Surface cone(meshOf(flatCone(16, 4, 6).soup));
  const uint64_t seed = 20261128;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (Surface* surface : {&tube, &cone}) {
    for (int i = 0; i < 2; ++i) {
      const SurfacePoint source = somewhere(surface->mesh(), random);
      for (const Solver solver : {Solver::kExact, Solver::kFast}) {
        expectVectorsOfShortestPaths(*surface, source, solver, 1e-9);
      }
    }
  }
}

TEST(SourceVectors, AtAVertexAreThoseOfShortestPaths) {
  Surface cone(meshOf(splitTriangles(meshOf(flatCone(5, 4, 6).soup), 4)));
  const Array<double>& scale = cone.geometry().angleScale;
  const int tip = static_cast<int>(std::max_element(scale.begin(), scale.end()) - scale.begin());
  EXPECT_GT(scale[tip], 1.1);
  for (const Solver solver : {Solver::kExact, Solver::kFast}) {
    expectVectorsOfShortestPaths(cone, vertexPoint(cone.mesh(), tip), solver, 1e-9);
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

TEST(TangentMaps, LogVectorsBesideAVertexAreDifferences) {
  // The path's first step, across a corner, is as short as the point is near to the vertex.
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const uint64_t seed = 20261130;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double near : {1e-10, 1e-9, 1e-7, 1e-4}) {
    for (int i = 0; i < 40; ++i) {
      const int face = static_cast<int>(random.uniform(0, mesh.faceCount()));
      const double u = near * random.uniform(0, 1);
      const double v = near * random.uniform(0, 1);
      const SurfacePoint from = checkedPoint(mesh, face, Vec3(1 - u - v, u, v));
      const SurfacePoint to = somewhere(mesh, random);
      const Vec3 vector = position(mesh, to) - position(mesh, from);
      const LogMapped log = logMap(geometry, from, to, Vec2::Zero(), workspace);
      EXPECT_LT((tangentToSpace(geometry, from, log.vector) - vector).norm(), 1e-13) << near;
      const LogMapped back = logMap(geometry, to, from, Vec2::Zero(), workspace);
      EXPECT_LT((tangentToSpace(geometry, to, back.vector) + vector).norm(), 1e-13) << near;
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

TEST(TangentMaps, MirrorInALineThroughVerticesReflects) {
  // The foot of the perpendicular from a vertex is a vertex, too.
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const SurfacePath line = pathBetween(geometry, nearestPoint(mesh, Vec3(0, 0, 0)),
                                       nearestPoint(mesh, Vec3(8, 8, 0)), workspace);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 here = mesh.positions[v];
    const ExpMapped image =
        mirrored(geometry, line, nearestPoint(mesh, here), Vec2::Zero(), workspace);
    EXPECT_LT((position(mesh, image.point) - Vec3(here.y(), here.x(), 0)).norm(), 1e-12)
        << here.transpose();
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

TEST(TangentMaps, MirrorInALineThatClosesOrOverlapsItself) {
  const FlatCylinder tube = flatCylinder(20, 2, 3);
  const TriangleMesh mesh = meshOf(tube.soup);
  const Geometry geometry = buildGeometry(mesh);
  FindPathWorkspace workspace;
  const auto place = [&](double angle, double height) {
    return nearestPoint(mesh, Vec3(std::cos(angle), std::sin(angle), height));
  };
  const uint64_t seed = 20261129;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double overlap : {0.0, 0.3}) {
    SCOPED_TRACE("overlap " + std::to_string(overlap));
    // The line begins and ends on lines of the prism's side, or in the midst of a side.
    Array<SurfacePoint> stops;
    for (int i = 0; i <= 20; ++i) stops.push_back(place(2 * kPi * i / 20, 1));
    if (overlap > 0) stops.push_back(place(overlap, 1));
    const SurfacePath line = chain(geometry, stops, false);
    for (int i = 0; i < 40; ++i) {
      // The first points are beside the ends.
      const double angle = i < 20 ? random.uniform(-0.2, 0.5) : random.uniform(0, 2 * kPi);
      const SurfacePoint point = place(angle, random.uniform(0.6, 1.4));
      const Vec3 wanted = [&] {
        Vec3 at = position(mesh, point);
        at.z() = 2 - at.z();
        return at;
      }();
      const ExpMapped image = mirrored(geometry, line, point, Vec2::Zero(), workspace);
      EXPECT_LT((position(mesh, image.point) - wanted).norm(), 1e-9) << "angle " << angle;
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

#include "intrinsic/straightest.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "distance/tangent_maps.h"
#include "distance_meshes.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "intrinsic/tangent.h"
#include "mesh/error.h"
#include "support.h"

namespace karcher {
namespace {

/// A cube's corner seen from outside: three unit squares, each cut in two, around vertex 0, whose
/// total angle is 3 pi / 2.
TriangleMesh cubeCorner() {
  return buildMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, -1}, {1, 0, -1}},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
}

TEST(Straightest, IsAStraightLineInThePlane) {
  const TriangleMesh mesh = planeGrid(7, 5);
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 20260101;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const auto somewhere = [&] {
    const double x = random.uniform(0.2, 6.8);
    return Vec3(x, random.uniform(0.2, 4.8), 0);
  };
  for (int i = 0; i < (longRun() ? 100'000 : 200); ++i) {
    const Vec3 a = somewhere();
    const Vec3 b = somewhere();
    const SurfacePoint start = nearestPoint(mesh, a);
    const StraightestPath path =
        traceStraightest(geometry, start, toFace(geometry, start.face, b - a));
    EXPECT_EQ(path.stop, TraceStop::kComplete);
    EXPECT_LT((position(mesh, path.path.end()) - b).norm(), 1e-13);
  }
}

TEST(Straightest, GoesThroughTheVerticesOfAGrid) {
  const TriangleMesh mesh = planeGrid(6, 6);
  const Geometry geometry = buildGeometry(mesh);
  for (const Vec3& step : {Vec3(4, 4, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(4, 2, 0)}) {
    const SurfacePoint start = nearestPoint(mesh, Vec3(1, 1, 0));
    const StraightestPath path =
        traceStraightest(geometry, start, toFace(geometry, start.face, step));
    EXPECT_EQ(path.stop, TraceStop::kComplete);
    EXPECT_LT((position(mesh, path.path.end()) - Vec3(1, 1, 0) - step).norm(), 1e-13);
  }
}

TEST(Straightest, HalvesTheTotalAngleAtAVertex) {
  const TriangleMesh mesh = cubeCorner();
  const Geometry geometry = buildGeometry(mesh);
  // Vertex 0 is interior: the path follows the x edge into it and leaves at 3 pi / 4, along the
  // diagonal of the opposite square.
  const SurfacePoint start = nearestPoint(mesh, Vec3(0.5, 0, 0));
  const StraightestPath path =
      traceStraightest(geometry, start, toFace(geometry, start.face, Vec3(-1, 0, 0)));
  const double along = 0.5 / std::sqrt(2.0);
  EXPECT_EQ(path.stop, TraceStop::kComplete);
  EXPECT_LT((position(mesh, path.path.end()) - Vec3(0, along, -along)).norm(), 1e-14);
}

TEST(Straightest, StopsAtTheBoundaryWithTheLengthLeft) {
  const TriangleMesh mesh = planeGrid(3, 3);
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint start = nearestPoint(mesh, Vec3(1.3, 1.4, 0));
  const StraightestPath path =
      traceStraightest(geometry, start, toFace(geometry, start.face, Vec3(5, 0, 0)));
  EXPECT_EQ(path.stop, TraceStop::kBoundary);
  EXPECT_NEAR(path.remaining, 5 - 1.7, 1e-13);
  EXPECT_LT((position(mesh, path.path.end()) - Vec3(3, 1.4, 0)).norm(), 1e-13);

  const StraightestPath off = traceFromVertex(geometry, 0, 3.0, 1);
  EXPECT_EQ(off.stop, TraceStop::kBoundary);
  EXPECT_EQ(off.remaining, 1);
}

TEST(Straightest, StopsAtTheLimitWithTheLengthLeft) {
  const MeasuredMesh sphere(icosphere(3));
  const StraightestPath path = traceStraightest(sphere.geometry, {0, Vec3(0.2, 0.3, 0.5)},
                                                Vec2(1000, 0), {.maxCrossings = 50});
  EXPECT_EQ(path.stop, TraceStop::kLimit);
  EXPECT_GT(path.remaining, 900);
  EXPECT_STREQ(traceStopName(path.stop), "limit");
}

TEST(Straightest, ASearchAroundATipEnds) {
  // The cone is 1 wide and 1e5 high: a straight line past the tip winds around it a hundred
  // thousand times.
  const TriangleSoup soup = wheel(13, 0, 1e5);
  const MeasuredMesh cone(buildMesh(soup.positions, soup.triangles));
  const int most = mostCrossingsOfSearch(cone.mesh);
  EXPECT_LT(most, 20'000);
  const SurfacePoint start{2, Vec3(0.3, 0.4, 0.3)};
  const Vec2 toTip = cornerInFace(cone.geometry, 2, 0) - pointInFace(cone.geometry, start);
  const StraightestPath path = traceStraightest(
      cone.geometry, start, rotate(unitVector(1e-6), toTip * 1.5), {.maxCrossings = most});
  EXPECT_EQ(path.stop, TraceStop::kLimit);
  EXPECT_GT(path.remaining, 0);

  // The search's limit does not stop a path across a plane.
  const TriangleMesh plane = planeGrid(40, 40);
  const Geometry flat = buildGeometry(plane);
  const StraightestPath across =
      traceStraightest(flat, nearestPoint(plane, Vec3(0.3, 0.1, 0)), Vec2(39, 38.5),
                       {.maxCrossings = mostCrossingsOfSearch(plane)});
  EXPECT_NE(across.stop, TraceStop::kLimit);
}

TEST(Straightest, FollowsAStraightBoundary) {
  const TriangleMesh mesh = planeGrid(4, 2);
  const Geometry geometry = buildGeometry(mesh);
  const StraightestPath path = traceFromVertex(geometry, 0, 0, 3.5);
  EXPECT_EQ(path.stop, TraceStop::kComplete);
  EXPECT_LT((position(mesh, path.path.end()) - Vec3(3.5, 0, 0)).norm(), 1e-13);
}

/// A flat mesh rotated about the origin, and then about the x axis.
TriangleMesh turned(const TriangleMesh& mesh, double angle, double lift) {
  Array<Vec3> positions;
  for (const Vec3& p : mesh.positions) {
    const Vec2 q = rotate(unitVector(angle), Vec2(p.x(), p.y()));
    positions.push_back(Vec3(q.x(), std::cos(lift) * q.y(), std::sin(lift) * q.y()));
  }
  return buildMesh(positions, mesh.faces);
}

TEST(Straightest, GoesAlongAStraightRimFromEveryVertexAndFace) {
  for (const double angle : {0.0, 0.3, 1.7}) {
    for (const double lift : {0.0, 0.7}) {
      const MeasuredMesh square(turned(planeGrid(6, 6), angle, lift));
      const TriangleMesh& mesh = square.mesh;
      FindPathWorkspace workspace;
      const auto onRim = [](int i, int j) { return i == 0 || j == 0 || i == 6 || j == 6; };
      for (int h = 0; h < mesh.halfedgeCount(); ++h) {
        const int a = mesh.tail(h);
        const int i = a % 7;
        const int j = a / 7;
        if (!onRim(i, j)) continue;
        for (int k = 0; k < 4; ++k) {
          const int to[] = {7 * j, 7 * j + 6, i,
                            42 + i};  // the ends of the vertex's row and column
          const int b = to[k];
          const bool isRow = k < 2;
          if (a == b || (isRow ? j % 6 != 0 : i % 6 != 0)) continue;
          const Vec3 way = mesh.positions[b] - mesh.positions[a];
          const SurfacePoint start = edgePoint(h, 0);
          const StraightestPath path =
              traceStraightest(square.geometry, start, toFace(square.geometry, start.face, way));
          // The path may end at a corner of the square, where rounding decides how much remains.
          EXPECT_LT(path.remaining, 1e-12) << "vertex " << a << " to " << b;
          EXPECT_LT((position(mesh, path.path.end()) - mesh.positions[b]).norm(), 1e-12);
          const SurfacePoint end = vertexPoint(mesh, b);
          const LogMapped log = logMap(square.geometry, start, end, Vec2(1, 0), workspace);
          const ExpMapped exp = expMap(square.geometry, start, log.vector, Vec2(1, 0));
          EXPECT_LT((position(mesh, exp.point) - mesh.positions[b]).norm(), 1e-12);
        }
      }
    }
  }
}

TEST(Straightest, GoesAlongShortRimsOfLongNeedles) {
  // Coordinates of the far corner's size round more than the rim's steps.
  const uint64_t seed = 20261127;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int turn = 0; turn < 3; ++turn) {
    const TriangleMesh mesh =
        buildMesh({{1e4, 0, 0}, {0, 0.05, 0}, {0, 0, 0}}, {{turn, (turn + 1) % 3, (turn + 2) % 3}});
    const Geometry geometry = buildGeometry(mesh);
    int rim = 0;  // the half-edge between the two near corners
    while (mesh.tail(rim) != 1) ++rim;
    for (int i = 0; i < 100; ++i) {
      SurfacePath path;
      path.points = {edgePoint(rim, random.uniform(0, 1)), edgePoint(rim, random.uniform(0, 1))};
      measure(mesh, path);
      const SurfacePoint end = expAlong(geometry, path.start(), logAlong(geometry, path)).end();
      EXPECT_LT((position(mesh, end) - position(mesh, path.end())).norm(), 1e-8 * path.length());
    }
  }
}

TEST(Straightest, LeavesAReentrantCornerInEveryDirection) {
  const MeasuredMesh corner(turned(lShape(2), 0.3, 0.4));
  const TriangleMesh& mesh = corner.mesh;
  // The rows have the corner's place, and the two axes from it.
  const TriangleMesh flat = lShape(2);
  int v = 0;
  while ((flat.positions[v] - Vec3(2, 2, 0)).norm() > 0) ++v;
  const auto placeOf = [&](const Vec3& p) -> Vec3 {
    const SurfacePoint point = nearestPoint(flat, p);
    return position(mesh, point);
  };
  for (const int h : outgoingHalfedges(mesh, v)) {
    for (int degrees = 90; degrees <= 360; ++degrees) {
      const Vec2 way = 0.7 * unitVector(degrees * kPi / 180);
      const Vec3 end = placeOf(Vec3(2 + way.x(), 2 + way.y(), 0));
      const SurfacePoint start = edgePoint(h, 0);
      const StraightestPath path = traceStraightest(
          corner.geometry, start,
          toFace(corner.geometry, start.face, end - mesh.positions[v]).normalized() * 0.7);
      EXPECT_EQ(path.stop, TraceStop::kComplete) << degrees << " degrees";
      EXPECT_LT((position(mesh, path.path.end()) - end).norm(), 1e-12) << degrees << " degrees";
    }
  }
}

TEST(Straightest, ConsecutivePointsShareAFaceAndAddUpToTheLength) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 33;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < (longRun() ? 20'000 : 100); ++i) {
    const SurfacePoint start = randomPlace(mesh, random);
    const Vec2 vector = random.uniform(0, 20) * unitVector(random.uniform(0, 2 * kPi));
    const StraightestPath path = traceStraightest(geometry, start, vector);
    double length = path.remaining;
    for (int k = 1; k < path.path.points.count(); ++k) {
      const SurfacePoint before = inFace(mesh, path.path.points[k - 1], path.path.points[k].face);
      length += (position(mesh, path.path.points[k]) - position(mesh, before)).norm();
    }
    ASSERT_NEAR(length, vector.norm(), 1e-10);
    if (path.stop == TraceStop::kComplete) {
      ASSERT_EQ(path.remaining, 0);
    }
  }
}

TEST(Straightest, RefusesAVectorThatIsNotFinite) {
  const TriangleMesh mesh = planeGrid(2, 2);
  const Geometry geometry = buildGeometry(mesh);
  EXPECT_THROW(traceStraightest(geometry, {0, Vec3(0.3, 0.3, 0.4)}, Vec2(std::nan(""), 1)), Error);
}

TEST(Straightest, AgreesWithGeometryCentralOnTheBunny) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  std::ifstream file = testData("bunny_straightest.txt");
  std::string line;
  int count = 0;
  double worst = 0;
  while (std::getline(file, line)) {
    if (line.front() == '#') continue;
    std::istringstream in(line);
    int face = 0;
    int endFace = 0;
    Vec3 bary, vector, endBary;
    in >> face >> bary[0] >> bary[1] >> bary[2] >> vector[0] >> vector[1] >> vector[2] >> endFace >>
        endBary[0] >> endBary[1] >> endBary[2];
    ASSERT_TRUE(in);
    const SurfacePoint start = checkedPoint(mesh, face, bary);
    const StraightestPath path = traceStraightest(geometry, start, toFace(geometry, face, vector));
    const Vec3 expected = position(mesh, {endFace, endBary});
    worst = std::max(worst, (position(mesh, path.path.end()) - expected).norm());
    ++count;
  }
  EXPECT_EQ(count, 200);
  // The reference has 12 digits; the rounding of a path's start is amplified by the spread of
  // geodesics.
  EXPECT_LT(worst / geometry.meanEdge, 1e-6);
  std::printf("straightest geodesics on the bunny: worst end %.1e mean edges off\n",
              worst / geometry.meanEdge);
}

}  // namespace
}  // namespace karcher

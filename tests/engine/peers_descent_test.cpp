#include <gtest/gtest.h>

#include "generators/plane.h"
#include "generators/random.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "peers/descent.h"
#include "support.h"

namespace karcher {
namespace {

Array<double> distancesInSpace(const TriangleMesh& mesh, const Vec3& from) {
  Array<double> distances;
  for (const Vec3& p : mesh.positions) distances.push_back((p - from).norm());
  return distances;
}

double valueAt(const TriangleMesh& mesh, const Array<double>& values, const SurfacePoint& p) {
  double value = 0;
  for (int k = 0; k < 3; ++k) value += p.bary[k] * values[mesh.corner(p.face, k)];
  return value;
}

TEST(Descent, FollowsAStraightLineWhereDistancesAreLinear) {
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 600, 4));
  const Geometry geometry = buildGeometry(mesh);
  Random random(9);
  for (int i = 0; i < 50; ++i) {
    const Vec3 a(random.uniform(0.05, 0.95), random.uniform(0.05, 0.95), 0);
    const Vec3 b(random.uniform(0.05, 0.95), random.uniform(0.05, 0.95), 0);
    Array<double> heights;
    for (const Vec3& p : mesh.positions) heights.push_back((p - a).dot((b - a).normalized()));
    const DescentPath path =
        descendDistance(geometry, heights, nearestPoint(mesh, a), nearestPoint(mesh, b));
    ASSERT_EQ(path.stop, DescentStop::kArrived);
    EXPECT_NEAR(path.length, (b - a).norm(), 1e-12);
    const Array<double> weights{0.3, 0.7};
    const SearchEnd center = descentCenterOfMass(geometry, path, weights);
    EXPECT_EQ(center.status, Status::kConverged);
    EXPECT_LT((position(mesh, center.point) - (0.3 * a + 0.7 * b)).norm(), 1e-12);
  }
}

TEST(Descent, ComesDownToTheSourceOnTheBunny) {
  // Distances along edges have their only minimum at the source, which is a vertex.
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint source = vertexPoint(mesh, 700);
  Array<double> distances(mesh.positions.size(), kInfinity);
  distances[700] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      const double through = distances[mesh.tail(h)] + geometry.edgeLength[h];
      if (through >= distances[mesh.head(h)]) continue;
      distances[mesh.head(h)] = through;
      changed = true;
    }
  }
  Random random(12);
  for (int i = 0; i < 300; ++i) {
    const int h = random.index(mesh.halfedgeCount());
    const SurfacePoint start = i % 3 == 0   ? edgePoint(h, 0)
                               : i % 3 == 1 ? edgePoint(h, random.uniform(0.1, 0.9))
                                            : SurfacePoint{faceOf(h), Vec3(0.2, 0.3, 0.5)};
    const DescentPath path = descendDistance(geometry, distances, source, start);
    ASSERT_EQ(path.stop, DescentStop::kArrived) << "seed 12, case " << i;
    for (int k = 1; k < path.points.count(); ++k) {
      EXPECT_LT(valueAt(mesh, distances, path.points[k]),
                valueAt(mesh, distances, path.points[k - 1]));
      EXPECT_TRUE(liesInFace(mesh, locate(mesh, path.points[k - 1]), path.points[k].face) ||
                  liesInFace(mesh, locate(mesh, path.points[k]), path.points[k - 1].face));
    }
  }
}

TEST(Descent, ConvergesToTheShortestPathOnThePlane) {
  const Vec3 source(0.21, 0.33, 0);
  const Vec3 start(0.86, 0.71, 0);
  Array<double> excesses;
  for (const int triangles : {200, 20000}) {
    const TriangleMesh mesh =
        meshOf(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, triangles, 6));
    const Geometry geometry = buildGeometry(mesh);
    const DescentPath path = descendDistance(geometry, distancesInSpace(mesh, source),
                                             nearestPoint(mesh, source), nearestPoint(mesh, start));
    ASSERT_EQ(path.stop, DescentStop::kArrived);
    const double excess = path.length / (start - source).norm() - 1;
    EXPECT_GE(excess, -1e-12);
    excesses.push_back(excess);
  }
  EXPECT_LT(excesses[1], std::min(excesses[0], 1e-3));
}

/// The steepest descent among many directions at a vertex, in all faces around it.
double steepestAround(const TriangleMesh& mesh, const Array<double>& values, int vertex) {
  constexpr int kDirections = 200;
  double steepest = 0;
  for (const int h : outgoingHalfedges(mesh, vertex)) {
    const Vec3& here = mesh.positions[vertex];
    const Vec3 a = mesh.positions[mesh.head(h)] - here;
    const Vec3 b = mesh.positions[mesh.opposite(h)] - here;
    const double alongA = values[mesh.head(h)] - values[vertex];
    const double alongB = values[mesh.opposite(h)] - values[vertex];
    for (int k = 0; k <= kDirections; ++k) {
      const double part = static_cast<double>(k) / kDirections;
      const double fall = -((1 - part) * alongA + part * alongB);
      steepest = std::max(steepest, fall / ((1 - part) * a + part * b).norm());
    }
  }
  return steepest;
}

TEST(Descent, LeavesAVertexByTheSteepestWay) {
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 300, 3));
  const Geometry geometry = buildGeometry(mesh);
  Random random(15);
  int left = 0;
  for (int i = 0; i < 300; ++i) {
    Array<double> values;
    for (int v = 0; v < mesh.vertexCount(); ++v) values.push_back(random.uniform(0, 1));
    const int vertex = random.index(mesh.vertexCount());
    const SurfacePoint far = vertexPoint(mesh, (vertex + mesh.vertexCount() / 2) % 100);
    const DescentPath path = descendDistance(geometry, values, far, vertexPoint(mesh, vertex));
    if (path.points.count() < 2 || liesInFace(mesh, locate(mesh, far), path.points[1].face)) {
      continue;
    }
    ++left;
    const double fall = values[vertex] - valueAt(mesh, values, path.points[1]);
    const double length = (position(mesh, path.points[1]) - mesh.positions[vertex]).norm();
    EXPECT_GE(fall / length, (1 - 1e-12) * steepestAround(mesh, values, vertex))
        << "seed 15, case " << i;
  }
  EXPECT_GE(left, 200);
}

TEST(Descent, ReportsWhereItIsStuck) {
  const TriangleMesh mesh = planeGrid(6, 6);
  const Geometry geometry = buildGeometry(mesh);
  // The distances' minimum is not at the source.
  const DescentPath path =
      descendDistance(geometry, distancesInSpace(mesh, {1, 1, 0}),
                      nearestPoint(mesh, {5.2, 4.9, 0}), nearestPoint(mesh, {2.3, 2.6, 0}));
  EXPECT_EQ(path.stop, DescentStop::kStuck);
  EXPECT_LT((position(mesh, path.points.back()) - Vec3(1, 1, 0)).norm(), 1e-12);
  const SearchEnd center = descentCenterOfMass(geometry, path, Array<double>{0.5, 0.5});
  EXPECT_EQ(center.status, Status::kNoProgress);
}

TEST(Descent, ReadsNoDistancesOfOtherComponents) {
  // A square with the path on its diagonal, and a triangle beside it that no distance reaches.
  const TriangleMesh mesh =
      buildMesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                {{0, 1, 3}, {1, 2, 3}, {4, 5, 6}});
  const Geometry geometry = buildGeometry(mesh);
  const double h = std::sqrt(2) / 2;
  // Linear distances along the diagonal from vertex 0.
  Array<double> distances{0, h, 2 * h, h, kInfinity, kInfinity, kInfinity};
  const SurfacePoint source = vertexPoint(mesh, 0);
  const SurfacePoint start = vertexPoint(mesh, 2);
  const DescentPath path = descendDistance(geometry, distances, source, start);
  ASSERT_EQ(path.stop, DescentStop::kArrived);
  EXPECT_NEAR(path.length, std::sqrt(2), 1e-12);
  distances[3] = kInfinity;
  EXPECT_THROW(descendDistance(geometry, distances, source, start), Error);
  distances[3] = std::nan("");
  EXPECT_THROW(descendDistance(geometry, distances, source, start), Error);
}

TEST(Descent, RefusesInvalidWeightsAndDistances) {
  const TriangleMesh mesh = planeGrid(3, 3);
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint a = nearestPoint(mesh, {0.3, 0.2, 0});
  const SurfacePoint b = nearestPoint(mesh, {2.3, 2.6, 0});
  const Array<double> distances = distancesInSpace(mesh, {0.3, 0.2, 0});
  const DescentPath path = descendDistance(geometry, distances, a, b);
  for (const Array<double>& weights : {Array<double>{1}, {0.2, 0.3, 0.5}, {1.5, -0.5}, {1, 1}}) {
    EXPECT_THROW(descentCenterOfMass(geometry, path, weights), Error);
  }
  EXPECT_THROW(descendDistance(geometry, {1, 2}, a, b), Error);
  EXPECT_THROW(descendDistance(geometry, Array<double>(16, kInfinity), a, b), Error);
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "distance/shortest_path.h"
#include "distance/tangent_maps.h"
#include "distance/window_distance.h"
#include "distance_meshes.h"
#include "generators/gallery.h"
#include "generators/renumbered.h"
#include "random_surfaces.h"
#include "support.h"

/// Shortest paths, and log and exp maps along them, on small random meshes: lattices with saddles,
/// rims and rough sheets. The tests use only properties that hold on every surface.
namespace karcher {
namespace {

double lengthOfPoints(const TriangleMesh& mesh, const SurfacePath& path) {
  double length = 0;
  for (int i = 1; i < path.points.count(); ++i) {
    length += (position(mesh, path.points[i]) - position(mesh, path.points[i - 1])).norm();
  }
  return length;
}

double distanceByWindows(const Geometry& geometry, const SurfacePoint& from, int to) {
  WindowDistance distance(geometry);
  distance.setSource(from);
  distance.grow(kInfinity);
  return distance.distance(to);
}

TEST(RandomPaths, HaveOneLengthBothWaysScaledAndTurned) {
  Checks checks;
  const int count = longRun() ? 3000 : 60;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(7000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleSoup soup = randomSurface(random);
    const MeasuredMesh surface(soup);
    const double scale = std::pow(10, random.uniform(-6, 6));
    const MeasuredMesh moved(carried(soup, scale, random));
    for (int k = 0; k < 10; ++k) {
      const SurfacePoint from = randomPlace(surface.mesh, random);
      const int vertex = random.index(surface.mesh.vertexCount());
      const SurfacePoint to = vertexPoint(surface.mesh, vertex);
      const SurfacePath path = shortestPath(surface.geometry, from, to);
      const double tolerance = 1e-9 * (path.length() + surface.geometry.meanEdge);
      EXPECT_NEAR(lengthOfPoints(surface.mesh, path), path.length(), tolerance);
      EXPECT_NEAR(distanceByWindows(surface.geometry, from, vertex), path.length(), tolerance);
      EXPECT_NEAR(shortestPath(surface.geometry, to, from).length(), path.length(), tolerance);
      EXPECT_NEAR(shortestPath(moved.geometry, from, to).length() / scale, path.length(),
                  tolerance);
      const SurfacePoint other = randomPlace(surface.mesh, random);
      checks.count += 5;
      EXPECT_LE(path.length(), shortestPath(surface.geometry, from, other).length() +
                                   shortestPath(surface.geometry, other, to).length() + tolerance);
    }
  }
}

/// The distances along edges to each vertex.
Array<double> distancesAlongEdges(const Geometry& geometry, int from) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<double> distance(static_cast<size_t>(mesh.vertexCount()), kInfinity);
  distance[from] = 0;
  // A path of edges has fewer edges than there are vertices.
  bool changes = true;
  for (int round = 0; round < mesh.vertexCount() && changes; ++round) {
    changes = false;
    for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
      const double length = geometry.edgeLength[h];
      double& tail = distance[mesh.tail(h)];
      double& head = distance[mesh.head(h)];
      changes = changes || tail + length < head || head + length < tail;
      head = std::min(head, tail + length);
      tail = std::min(tail, head + length);
    }
  }
  return distance;
}

TEST(RandomPaths, LieBetweenTheChordAndTheEdgesHoweverTheMeshIsNumbered) {
  Checks checks;
  const int count = longRun() ? 3000 : 60;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(8000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeasuredMesh surface(randomSurface(random));
    const Renumbered other = renumbered(surface.mesh, seed);
    const MeasuredMesh numberedAnew(other.mesh);
    const int source = random.index(surface.mesh.vertexCount());
    const Array<double> alongEdges = distancesAlongEdges(surface.geometry, source);
    const SurfacePoint from = vertexPoint(surface.mesh, source);
    for (int k = 0; k < 10; ++k) {
      const int vertex = random.index(surface.mesh.vertexCount());
      const SurfacePoint to = vertexPoint(surface.mesh, vertex);
      const double length = shortestPath(surface.geometry, from, to).length();
      const double tolerance = 1e-9 * (length + surface.geometry.meanEdge);
      const double chord = (position(surface.mesh, from) - position(surface.mesh, to)).norm();
      EXPECT_GE(length, chord - tolerance);
      EXPECT_LE(length, alongEdges[vertex] + tolerance);
      checks.count += 3;
      const SurfacePoint place = randomPlace(surface.mesh, random);
      const double toPlace = shortestPath(surface.geometry, from, place).length();
      EXPECT_NEAR(shortestPath(numberedAnew.geometry, other.at(from), other.at(place)).length(),
                  toPlace, 1e-9 * (toPlace + surface.geometry.meanEdge));
    }
  }
}

TEST(RandomPaths, TransportKeepsLengthsAndAnglesAndIsUndoneOnTheWayBack) {
  Checks checks;
  const int count = longRun() ? 3000 : 60;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(6000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeasuredMesh surface(randomSurface(random));
    FindPathWorkspace workspace;
    for (int k = 0; k < 20; ++k) {
      const SurfacePoint from = randomPlace(surface.mesh, random);
      const SurfacePoint to = randomPlace(surface.mesh, random);
      SurfacePath path = pathBetween(surface.geometry, from, to, workspace);
      const Vec2 u = random.uniform(0.5, 2) * unitVector(random.uniform(0, 7));
      const Vec2 v = random.uniform(0.5, 2) * unitVector(random.uniform(0, 7));
      const Vec2 there = transportAlong(surface.geometry, path, u);
      const Vec2 beside = transportAlong(surface.geometry, path, v);
      EXPECT_NEAR(there.norm(), u.norm(), 1e-12);
      EXPECT_NEAR(there.dot(beside), u.dot(v), 1e-12);
      checks.count += 3;
      std::reverse(path.points.begin(), path.points.end());
      measure(surface.mesh, path);
      EXPECT_LT((transportAlong(surface.geometry, path, there) - u).norm(), 1e-9);
    }
  }
}

TEST(RandomPaths, AtAVertexOfTenThousandFacesAreTheSameBothWays) {
  Checks checks;
  constexpr uint64_t kSeed = 5000;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  const MeasuredMesh surface(wheel(10'000, 0, 0.3));
  for (int k = 0; k < (longRun() ? 100 : 3); ++k) {
    const SurfacePoint from = randomPlace(surface.mesh, random);
    const SurfacePoint to = randomPlace(surface.mesh, random);
    const SurfacePath path = shortestPath(surface.geometry, from, to);
    const double chord = (position(surface.mesh, from) - position(surface.mesh, to)).norm();
    checks.count += 3;
    EXPECT_GE(path.length(), chord - 1e-9);
    EXPECT_NEAR(lengthOfPoints(surface.mesh, path), path.length(), 1e-9);
    EXPECT_NEAR(shortestPath(surface.geometry, to, from).length(), path.length(), 1e-9);
  }
}

TEST(RandomPaths, ExpAlongAnEdgeOfSliversIsItsOtherEnd) {
  Checks checks;
  const int count = longRun() ? 3000 : 100;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(4000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeasuredMesh surface(slivers(random));
    const TriangleMesh& mesh = surface.mesh;
    for (int h = 0; h < 3 * mesh.faceCount(); ++h) {
      // Beyond a full turn a vector does not determine a direction.
      if (mesh.onBoundary[mesh.tail(h)] &&
          surface.geometry.totalAngle[mesh.tail(h)] > 2 * kPi - 1e-6) {
        continue;
      }
      ++checks.count;
      SurfacePath edge;
      edge.points = {edgePoint(h, 0), edgePoint(h, 1)};
      measure(mesh, edge);
      const SurfacePath walk =
          expAlong(surface.geometry, edge.start(), logAlong(surface.geometry, edge));
      ASSERT_LT(walk.points.count(), 50) << "half-edge " << h;
      EXPECT_LT((position(mesh, walk.end()) - position(mesh, edge.end())).norm(),
                1e-8 * surface.geometry.diagonal)
          << "half-edge " << h;
    }
  }
}

/// Whether a path passes a vertex, where the straight direction is not unique.
bool passesVertex(const TriangleMesh& mesh, const SurfacePath& path) {
  for (int i = 1; i + 1 < path.points.count(); ++i) {
    if (path.points[i].bary.maxCoeff() > 1 - 1e-6 &&
        !samePlace(mesh, path.points[i], path.start()) &&
        !samePlace(mesh, path.points[i], path.end())) {
      return true;
    }
  }
  return false;
}

TEST(RandomPaths, ExpOfLogIsThePointAlsoOnRims) {
  const int count = longRun() ? 3000 : 60;
  Checks checks;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(9000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const MeasuredMesh surface(randomSurface(random));
    const TriangleMesh& mesh = surface.mesh;
    FindPathWorkspace workspace;
    Array<int> rim;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (mesh.onBoundary[v]) rim.push_back(v);
    }
    for (int k = 0; k < 20; ++k) {
      const bool fromRim = !rim.empty() && random.index(2) == 0;
      const SurfacePoint from =
          fromRim ? vertexPoint(mesh, rim[random.index(rim.count())]) : randomPlace(mesh, random);
      const SurfacePoint to = randomPlace(mesh, random);
      const SurfacePath path = pathBetween(surface.geometry, from, to, workspace);
      if (passesVertex(mesh, path)) continue;
      // Beyond a full turn a vector does not determine a direction.
      const PointLocation at = locate(mesh, from);
      if (at.simplex == Simplex::kVertex && mesh.onBoundary[at.vertex] &&
          surface.geometry.totalAngle[at.vertex] > 2 * kPi - 1e-6) {
        continue;
      }
      ++checks.count;
      const SurfacePoint end =
          expAlong(surface.geometry, from, logAlong(surface.geometry, path)).end();
      EXPECT_LT((position(mesh, end) - position(mesh, to)).norm(),
                1e-8 * (path.length() + surface.geometry.meanEdge));
    }
  }
  EXPECT_GT(checks.count, 5 * count);
}

}  // namespace
}  // namespace karcher

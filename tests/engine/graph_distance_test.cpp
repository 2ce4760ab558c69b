#include "distance/graph_distance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "mesh/error.h"
#include "support.h"

namespace karcher {
namespace {

GraphDistance solved(const Geometry& geometry, const RingGraph& graph, const SurfacePoint& source) {
  GraphDistance solver(geometry, graph);
  solver.setSource(source);
  solver.grow(kInfinity);
  return solver;
}

TEST(RingGraph, OfThePlaneJoinsTheWholeRingByStraightLines) {
  const TriangleMesh mesh = planeGrid(14, 14);
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 3);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    for (int64_t arc = graph.start[v]; arc < graph.start[v + 1]; ++arc) {
      const Vec3 step = mesh.positions[graph.target[arc]] - mesh.positions[v];
      EXPECT_NEAR(graph.length[arc], step.norm(), 1e-12);
    }
  }
  // Edges run along x, y and the diagonal x = y: the 3-ring of an inner vertex has 36 vertices. In
  // each of the three directions, only the first vertex is in sight.
  const int middle = 7 + 15 * 7;
  EXPECT_EQ(graph.start[middle + 1] - graph.start[middle], 36);
}

TEST(RingGraph, BuiltInSlicesIsTheSame) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph whole = buildRingGraph(geometry, 4);
  RingGraphBuilder builder(geometry, 4);
  int slices = 0;
  while (!builder.advance(100)) ++slices;
  EXPECT_EQ(slices, mesh.vertexCount() / 100);
  EXPECT_EQ(builder.progress(), 1);
  const RingGraph sliced = builder.take();
  EXPECT_EQ(whole.target, sliced.target);
  EXPECT_EQ(whole.length, sliced.length);
}

TEST(RingGraph, IsSymmetric) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 2);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    for (int64_t arc = graph.start[v]; arc < graph.start[v + 1]; ++arc) {
      const int w = graph.target[arc];
      double back = kInfinity;
      for (int64_t other = graph.start[w]; other < graph.start[w + 1]; ++other) {
        if (graph.target[other] == v) back = graph.length[other];
      }
      // A line that leaves one end's ring may stay inside the other's.
      if (back != kInfinity) {
        EXPECT_NEAR(back, graph.length[arc], 1e-2 * geometry.meanEdge);
      }
    }
  }
}

TEST(RingGraph, ArcsMakeUpExactDistancesInsideTheRing) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 6);
  constexpr int kSmallerRing = 4;
  GraphDistance byArcs(geometry, graph);
  WindowDistance exact(geometry);
  int compared = 0;
  for (int v = 0; v < mesh.vertexCount(); v += 97) {
    byArcs.setSource(vertexPoint(mesh, v));
    byArcs.grow(kInfinity);
    exact.setSource(vertexPoint(mesh, v));
    exact.grow(kInfinity);
    // Paths nearer than everything outside a smaller ring stay inside this one.
    Array<uint8_t> inside(mesh.positions.size(), 0);
    inside[v] = 1;
    for (int ring = 0; ring < kSmallerRing; ++ring) {
      const Array<uint8_t> before = inside;
      for (int h = 0; h < mesh.halfedgeCount(); ++h) {
        if (before[mesh.tail(h)] || before[mesh.head(h)]) {
          inside[mesh.tail(h)] = inside[mesh.head(h)] = 1;
        }
      }
    }
    double radius = kInfinity;
    for (int w = 0; w < mesh.vertexCount(); ++w) {
      if (!inside[w]) radius = std::min(radius, exact.distance(w));
    }
    for (int w = 0; w < mesh.vertexCount(); ++w) {
      EXPECT_GE(byArcs.distance(w), exact.distance(w) * (1 - 1e-12));
      if (exact.distance(w) >= radius) continue;
      EXPECT_NEAR(byArcs.distance(w), exact.distance(w), 1e-9 * radius);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(RingGraph, GrowsLinearlyAtAVertexOfManyEdges) {
  // All vertices lie in each other's rings through the middle: 1e8 arcs.
  const TriangleMesh mesh = galleryMesh("disk, valence 10000");
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 6);
  EXPECT_LT(graph.target.size(), 20 * mesh.positions.size());
  GraphDistance solver(geometry, graph);
  solver.setSource(vertexPoint(mesh, 77));
  solver.grow(kInfinity);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double straight = (mesh.positions[v] - mesh.positions[77]).norm();
    EXPECT_GE(solver.distance(v), straight * (1 - 1e-9));
    // The path goes around the rim or across the middle.
    EXPECT_LE(solver.distance(v), straight * 1.25);
  }
}

TEST(RingGraph, RefusesOtherNumbersOfRings) {
  const TriangleMesh mesh = planeGrid(2, 2);
  const Geometry geometry = buildGeometry(mesh);
  EXPECT_THROW(buildRingGraph(geometry, 0), Error);
  EXPECT_THROW(buildRingGraph(geometry, 11), Error);
}

TEST(GraphDistance, OnThePlaneIsNeverBelowTheTruthAndLittleAbove) {
  const TriangleMesh mesh = planeGrid(20, 16);
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 6);
  for (const Vec3& p : {Vec3(7.3, 8.2, 0), Vec3(7.5, 8.5, 0), Vec3(7, 8.5, 0), Vec3(7, 8, 0),
                        Vec3(0.3, 0.1, 0), Vec3(20, 16, 0)}) {
    const SurfacePoint source = nearestPoint(mesh, p);
    const bool atVertex = locate(mesh, source).simplex == Simplex::kVertex;
    const GraphDistance solver = solved(geometry, graph, source);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double truth = (mesh.positions[v] - p).norm();
      EXPECT_GE(solver.distance(v), truth - 1e-12);
      // Paths from a source inside a face turn at the second vertex around it, a detour of up to a
      // quarter of an edge.
      EXPECT_LE(solver.distance(v), 1.03 * truth + (atVertex ? 1e-12 : 0.25));
    }
  }
}

TEST(GraphDistance, PointsBackTowardsTheSource) {
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 6);
  const Vec3 p(3.3, 4.1, 0);
  const GraphDistance solver = solved(geometry, graph, nearestPoint(mesh, p));
  for (const int v : {3 + 9 * 3, 4 + 9 * 4, 5 + 9 * 4, 3 + 9 * 5}) {
    const CornerDirection corner = cornerOfDirection(geometry, v, solver.direction(v));
    const Vec2 edge = halfedgeInFace(geometry, corner.halfedge);
    const Vec3 direction =
        toSpace(geometry, faceOf(corner.halfedge), rotate(unitVector(corner.angle), edge));
    const Vec3 expected = p - mesh.positions[v];
    EXPECT_NEAR(direction.normalized().dot(expected.normalized()), 1, 1e-9);
  }
}

TEST(GraphDistance, ResumedIsTheSameAndStopsAtItsRadius) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const RingGraph graph = buildRingGraph(geometry, 4);
  const SurfacePoint source{500, Vec3(0.2, 0.5, 0.3)};
  const GraphDistance whole = solved(geometry, graph, source);
  GraphDistance resumed(geometry, graph);
  resumed.setSource({3, Vec3(1, 0, 0)});
  resumed.grow(5);
  resumed.setSource(source);
  for (const double radius : {0.5, 1.0, 3.0}) {
    resumed.grow(radius);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_EQ(resumed.isFinal(v), whole.distance(v) <= resumed.reached());
      if (whole.distance(v) <= radius) {
        EXPECT_EQ(resumed.distance(v), whole.distance(v));
      }
    }
  }
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "generators/flat.h"
#include "generators/plane.h"
#include "generators/sphere.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "mesh/triangle_mesh.h"
#include "support.h"

namespace karcher {
namespace {

std::string errorOf(const Array<Vec3>& positions, const Array<Triangle>& faces) {
  try {
    buildMesh(positions, faces);
  } catch (const Error& error) {
    return std::string(errorCodeName(error.code())) + ": " + error.what();
  }
  return "";
}

/*  3 --- 2
    | \ 1 |
    | 0 \ |
    0 --- 1   */
const Array<Vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(BuildMesh, JoinsTheHalfedgesOfASquare) {
  const TriangleMesh mesh = buildMesh(kSquare, {{0, 1, 3}, {2, 3, 1}});
  // Half-edge 1 runs 1 -> 3 in face 0, half-edge 4 runs 3 -> 1 in face 1.
  const Array<int> twins = {-1, 4, -1, -1, 1, -1};
  EXPECT_TRUE(mesh.twin == twins);
  // The boundary leaves 0 by 0 -> 1, 1 by 1 -> 2, 2 by 2 -> 3 and 3 by 3 -> 0.
  const Array<int> outgoing = {0, 5, 3, 2};
  EXPECT_TRUE(mesh.outgoing == outgoing);
  EXPECT_EQ(mesh.tail(1), 1);
  EXPECT_EQ(mesh.head(1), 3);
  EXPECT_EQ(mesh.opposite(1), 0);
  EXPECT_EQ(rotateLeft(mesh, 5), 1);
  EXPECT_EQ(rotateLeft(mesh, 1), -1);
}

/// Checks the invariants of every mesh: twins match, and a turn from `outgoing` visits each corner
/// of the vertex once.
void expectSound(const TriangleMesh& mesh) {
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int t = mesh.twin[h];
    if (t < 0) {
      EXPECT_EQ(mesh.outgoing[mesh.tail(h)], h);
      EXPECT_TRUE(mesh.onBoundary[mesh.tail(h)] && mesh.onBoundary[mesh.head(h)]);
      continue;
    }
    EXPECT_EQ(mesh.twin[t], h);
    EXPECT_EQ(mesh.tail(t), mesh.head(h));
    EXPECT_EQ(mesh.head(t), mesh.tail(h));
  }
  int corners = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    std::set<int> seen;
    int h = mesh.outgoing[v];
    while (h >= 0 && seen.insert(h).second) {
      EXPECT_EQ(mesh.tail(h), v);
      h = rotateLeft(mesh, h);
    }
    EXPECT_EQ(h >= 0, !mesh.onBoundary[v]);
    corners += static_cast<int>(seen.size());
  }
  EXPECT_EQ(corners, mesh.halfedgeCount());
}

TEST(BuildMesh, IsSoundOnClosedAndOpenSurfaces) {
  for (const Shape shape : kShapes) expectSound(meshOf(makeShape(shape, 600)));
  expectSound(meshOf(flatCylinder(12, 2, 1).soup));
  expectSound(meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 300, 1)));
}

TEST(BuildMesh, RefusesFacesThatFormNoSurface) {
  EXPECT_EQ(errorOf(kSquare, {}), "badFile: the mesh has no faces");
  EXPECT_EQ(errorOf(kSquare, {{0, 1, 3}, {2, 3, 4}}),
            "badIndex: face 1 uses vertex 4, but the mesh has 4 vertices");
  EXPECT_EQ(errorOf(kSquare, {{0, 1, 3}}), "badIndex: vertex 2 belongs to no face");
  EXPECT_EQ(errorOf({{0, 0, 0}, {1, kInfinity, 0}, {0, 1, 0}}, {{0, 1, 2}}),
            "notFinite: vertex 1 has a coordinate that is not a finite number");
  EXPECT_EQ(errorOf(kSquare, {{0, 1, 3}, {2, 3, 3}}), "degenerateFace: face 1 uses vertex 3 twice");
  EXPECT_EQ(
      errorOf({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, {{0, 1, 2}}),
      "degenerateFace: face 0 is too thin: the height of its triangle 0, 1, 2 is at most 1e-12 "
      "of its longest edge");
}

TEST(BuildMesh, NamesItsLimitsOfSize) {
  EXPECT_EQ(
      errorOf({{0, 0, 0}, {1e150, 0, 0}, {0, 1e150, 0}}, {{0, 1, 2}}),
      "badArgument: vertex 1 has a coordinate of size 1e+150; at most 1e+30 is allowed: scale "
      "the mesh first");
  EXPECT_EQ(errorOf({{1, 0, 0}, {1, 1e-150, 0}, {1, 0, 1e-150}}, {{0, 1, 2}}),
            "badArgument: the mesh is only 1e-150 wide; it must be at least 1e-30: scale the mesh "
            "first");
  for (const double size : {1e30, 1e-30}) {
    EXPECT_EQ(errorOf({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{0, 1, 2}}), "");
  }
}

TEST(BuildMesh, RefusesEdgesThatAreNotManifold) {
  // Three pages of a book along the edge 0-1.
  const Array<Vec3> book = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  EXPECT_EQ(errorOf(book, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
            "nonManifoldEdge: edge 0-1 has 3 faces; a surface allows two");
  EXPECT_EQ(errorOf(kSquare, {{0, 1, 3}, {1, 3, 2}}),
            "nonManifoldEdge: faces 0 and 1 run along edge 1-3 in the same direction; their "
            "orientations must agree");
}

/*  1 --- 2       two triangles that touch at vertex 0 only
     \   /
       0
     /   \
    3 --- 4   */
TEST(BuildMesh, RefusesVerticesThatAreNotManifold) {
  const Array<Vec3> bow = {{0, 0, 0}, {-1, 1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  EXPECT_EQ(errorOf(bow, {{0, 2, 1}, {0, 3, 4}}),
            "nonManifoldVertex: vertex 0 joins more than one fan of faces: 1 of its 2 faces are "
            "connected around it");
}

TEST(BuildMesh, AllowsNeedlesButNotTheirLimit) {
  EXPECT_EQ(errorOf({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}, {{0, 1, 2}}), "");
  EXPECT_EQ(errorOf({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-13, 0}}, {{0, 1, 2}}).substr(0, 15),
            "degenerateFace:");
}

TEST(Topology, CountsLoopsAndHandles) {
  const auto expect = [](const TriangleMesh& mesh, int components, int loops, int genus) {
    const Topology t = topology(mesh);
    EXPECT_EQ(t.components, components);
    EXPECT_EQ(t.boundaryLoops, loops);
    EXPECT_EQ(t.genus, genus);
  };
  expect(meshOf(makeShape(Shape::kSphere, 500)), 1, 0, 0);
  expect(meshOf(makeShape(Shape::kTorus, 500)), 1, 0, 1);
  expect(meshOf(makeShape(Shape::kGenus3, 500)), 1, 0, 3);
  expect(meshOf(makeShape(Shape::kOpenSheet, 500)), 1, 1, 0);
  expect(meshOf(flatCylinder(12, 2, 1).soup), 1, 2, 0);
}

TEST(Topology, AddsUpComponents) {
  TriangleSoup both = makeShape(Shape::kTorus, 500);
  const int offset = both.positions.count();
  const TriangleSoup sheet = makeShape(Shape::kOpenSheet, 500);
  both.positions.insert(both.positions.end(), sheet.positions.begin(), sheet.positions.end());
  for (const Triangle& t : sheet.triangles) {
    both.triangles.emplace_back(t[0] + offset, t[1] + offset, t[2] + offset);
  }
  const TriangleMesh mesh = meshOf(both);
  const Topology t = topology(mesh);
  EXPECT_EQ(t.components, 2);
  EXPECT_EQ(t.boundaryLoops, 1);
  EXPECT_EQ(t.genus, 1);
  const Array<int> component = componentOfVertices(mesh);
  for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(component[v], v < offset ? 0 : 1);
}

TEST(Measures, OfASquare) {
  const TriangleMesh mesh = buildMesh(kSquare, {{0, 1, 3}, {2, 3, 1}});
  EXPECT_DOUBLE_EQ(boundingBoxDiagonal(mesh), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(meanEdgeLength(mesh), (4 + std::sqrt(2.0)) / 5);
}

}  // namespace
}  // namespace karcher

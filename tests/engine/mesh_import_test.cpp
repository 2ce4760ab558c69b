#include "mesh/mesh_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "generators/random.h"
#include "generators/sphere.h"
#include "mesh/error.h"

namespace karcher {
namespace {

std::string errorOf(const TriangleSoup& soup) {
  try {
    importMesh(soup, {.repair = false});
  } catch (const Error& error) {
    return std::string(errorCodeName(error.code())) + ": " + error.what();
  }
  return "";
}

/// The soup with separate vertices for every triangle.
TriangleSoup exploded(const TriangleSoup& soup) {
  TriangleSoup result;
  for (const Triangle& t : soup.triangles) {
    const int first = result.positions.count();
    for (const int v : t) result.positions.push_back(soup.positions[v]);
    result.triangles.emplace_back(first, first + 1, first + 2);
  }
  return result;
}

const TriangleSoup kTetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

/// The tetrahedron and a copy of it, whose own vertices `move` changes.
template <class Move>
TriangleSoup withCopy(Move&& move) {
  TriangleSoup result = kTetrahedron;
  for (const Vec3& p : kTetrahedron.positions) result.positions.push_back(move(p));
  for (const Triangle& t : kTetrahedron.triangles) {
    result.triangles.emplace_back(t[0] + 4, t[1] + 4, t[2] + 4);
  }
  return result;
}

/// Checks that the mesh equals the soup in the caller's numbering.
void expectSameSurface(const TriangleSoup& soup, const ImportedMesh& imported) {
  const TriangleMesh& mesh = imported.mesh;
  const Numbering& numbering = imported.numbering;
  ASSERT_EQ(numbering.engineVertex.count(), soup.positions.count());
  ASSERT_EQ(numbering.inputVertex.count(), mesh.vertexCount());
  ASSERT_EQ(numbering.engineFace.count(), soup.triangles.count());
  ASSERT_EQ(numbering.inputFace.count(), mesh.faceCount());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(numbering.engineVertex[numbering.inputVertex[v]], v);
  }
  for (int v = 0; v < soup.positions.count(); ++v) {
    const int w = numbering.engineVertex[v];
    if (w < 0) continue;
    EXPECT_EQ(mesh.positions[w], soup.positions[v]);
    EXPECT_LE(numbering.inputVertex[w], v);
  }
  for (int t = 0; t < soup.triangles.count(); ++t) {
    const int f = numbering.engineFace[t];
    EXPECT_EQ(numbering.inputFace[f], t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(mesh.corner(f, k), numbering.engineVertex[soup.triangles[t][k]]);
    }
  }
}

TEST(ImportMesh, KeepsTheCallersSurface) {
  const TriangleSoup soup = randomSphere(500, 1);
  const ImportedMesh imported = importMesh(soup);
  expectSameSurface(soup, imported);
  EXPECT_TRUE(imported.repairs.empty());
}

TEST(ImportMesh, NumbersNeighboursNearEachOther) {
  TriangleSoup soup = randomSphere(20000, 1);
  const TriangleMesh mesh = importMesh(soup).mesh;
  double distance = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) distance += std::abs(mesh.tail(h) - mesh.head(h));
  // Neighbours on a space-filling curve of the surface are about sqrt(vertices) apart, in a random
  // order a third of the vertices.
  EXPECT_LT(distance / mesh.halfedgeCount(), 5 * std::sqrt(mesh.vertexCount()));
}

TEST(ImportMesh, DropsUnusedVertices) {
  TriangleSoup soup = kTetrahedron;
  soup.positions.insert(soup.positions.begin() + 1, Vec3(7, 7, 7));
  soup.positions.push_back(Vec3(0, 0, 0));
  for (Triangle& t : soup.triangles) {
    for (int& v : t) v += v >= 1;
  }
  const ImportedMesh imported = importMesh(soup);
  expectSameSurface(soup, imported);
  EXPECT_EQ(imported.numbering.engineVertex[1], -1);
  EXPECT_EQ(imported.numbering.engineVertex[5], -1);
  ASSERT_EQ(imported.repairs.count(), 1);
  EXPECT_EQ(imported.repairs[0].kind, Repair::Kind::kDropped);
  EXPECT_EQ(imported.repairs[0].count, 2);
  EXPECT_EQ(imported.repairs[0].sentence, "2 vertices that no face uses were left out");
}

TEST(ImportMesh, WeldsTheSeamsOfUnweldedTriangles) {
  const TriangleSoup sphere = relaxedSphere(500, 2);
  const TriangleSoup soup = exploded(sphere);
  const ImportedMesh imported = importMesh(soup);
  expectSameSurface(soup, imported);
  EXPECT_EQ(imported.mesh.vertexCount(), sphere.positions.count());
  EXPECT_EQ(topology(imported.mesh).boundaryLoops, 0);
  ASSERT_EQ(imported.repairs.count(), 1);
  EXPECT_EQ(imported.repairs[0].kind, Repair::Kind::kWelded);
  EXPECT_EQ(imported.repairs[0].count, soup.positions.count() - sphere.positions.count());
}

TEST(ImportMesh, WeldsNoVertexOfARepeatedFaceAlone) {
  // two triangles of a square, and the first of them again, each with vertices of its own
  const TriangleSoup soup =
      exploded({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 1, 2}}});
  const ImportedMesh apart = importMesh(soup, {.repair = true, .weld = 0});
  EXPECT_EQ(apart.mesh.vertexCount(), 6);
  ASSERT_EQ(apart.repairs.count(), 2);
  EXPECT_EQ(apart.repairs[0].kind, Repair::Kind::kKeptApart);
  EXPECT_EQ(apart.repairs[1].kind, Repair::Kind::kDuplicate);
  const ImportedMesh joined = importMesh(soup);
  ASSERT_EQ(joined.repairs.count(), 2);
  EXPECT_EQ(joined.repairs[0].kind, Repair::Kind::kWelded);
  EXPECT_EQ(joined.repairs[0].count, 2);
  for (const ImportedMesh& imported : {apart, joined}) {
    EXPECT_EQ(imported.numbering.inputCorners(imported.mesh, 2), Triangle(0, 1, 2));
  }
}

TEST(ImportMesh, TreatsMinusZeroAsZero) {
  // 2---3 5    two triangles that meet along x = 0
  //  \ 0|4 \     0, 2, 3: the left one; 1, 4, 5 the right one
  const TriangleSoup soup = {
      {{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {1, 0, 0}, {-0.0, 1, -0.0}},
      {{0, 2, 1}, {3, 4, 5}}};
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(imported.mesh.vertexCount(), 4);
  EXPECT_EQ(imported.numbering.engineVertex[3], imported.numbering.engineVertex[0]);
  EXPECT_EQ(imported.numbering.engineVertex[5], imported.numbering.engineVertex[2]);
}

TEST(ImportMesh, SeparatesPartsThatTouchAtAVertex) {
  const TriangleSoup soup = withCopy([](const Vec3& p) { return Vec3(-p); });
  // The map -p turns the copy's faces inside out, and it is still a surface.
  const ImportedMesh imported = importMesh(soup);
  expectSameSurface(soup, imported);
  EXPECT_EQ(topology(imported.mesh).components, 2);
  ASSERT_EQ(imported.repairs.count(), 1);
  EXPECT_EQ(imported.repairs[0].kind, Repair::Kind::kKeptApart);
  EXPECT_EQ(imported.repairs[0].count, 1);
  EXPECT_EQ(imported.repairs[0].sentence,
            "1 vertex at the position of another stayed apart, where no edge joins their faces");
}

TEST(ImportMesh, KnowsItsVerticesAtTheCorners) {
  // Two triangles touch at vertex 0. A third one repeats the first, and a fourth one, without area,
  // cuts it at the middle of its side from 1 to 2.
  const TriangleSoup soup = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 1, 0}},
                             {{3, 4, 0}, {0, 1, 2}, {1, 2, 0}, {2, 1, 5}}};
  const ImportedMesh imported = importMesh(soup);
  const auto corners = [&](int t) { return imported.numbering.engineCorners(imported.mesh, t); };
  EXPECT_EQ(corners(2), Triangle(-1, -1, -1));
  for (const int t : {0, 1, 3}) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(imported.mesh.positions[corners(t)[k]], soup.positions[soup.triangles[t][k]]);
    }
  }
  EXPECT_NE(corners(0)[2], corners(1)[0]);
  EXPECT_EQ(componentOfVertices(imported.mesh)[corners(1)[0]],
            componentOfVertices(imported.mesh)[corners(1)[1]]);
}

TEST(ImportMesh, SeparatesPartsThatTouchAlongAnEdge) {
  // The copy is the tetrahedron after half a turn about the z axis: the edge 0-3 has four faces.
  const auto turn = [](const Vec3& p) { return Vec3(-p.x(), -p.y(), p.z()); };
  const TriangleSoup soup = withCopy(turn);
  EXPECT_EQ(topology(importMesh(soup).mesh).components, 2);
  // Without shared vertices, the import welds everything except that ambiguous edge.
  const ImportedMesh imported = importMesh(exploded(soup));
  EXPECT_EQ(topology(imported.mesh).components, 2);
  EXPECT_EQ(topology(imported.mesh).boundaryLoops, 0);
  EXPECT_EQ(imported.mesh.vertexCount(), 8);
}

TEST(ImportMesh, SeparatesTheSidesOfADoubledSheetInside) {
  // The soup is the front and the back of a square of four triangles around its center.
  TriangleSoup soup = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  for (int v = 0; v < 5; ++v) soup.positions.push_back(Vec3(soup.positions[v]));
  for (int t = 0; t < 4; ++t) {
    const Triangle front = soup.triangles[t];
    soup.triangles.emplace_back(front[1] + 5, front[0] + 5, front[2] + 5);
  }
  const ImportedMesh imported = importMesh(soup);
  // The result is closed along the rim like a cushion, with a center on each side.
  EXPECT_EQ(imported.mesh.vertexCount(), 6);
  EXPECT_EQ(topology(imported.mesh).boundaryLoops, 0);
}

TEST(ImportMesh, NamesTheCallersNumbers) {
  TriangleSoup soup = kTetrahedron;
  soup.triangles.push_back({2, 3, 907});
  EXPECT_EQ(errorOf(soup), "badIndex: face 4 uses vertex 907, but the mesh has 4 vertices");

  soup = kTetrahedron;
  soup.triangles.push_back({2, 3, -1});
  EXPECT_EQ(errorOf(soup), "badIndex: face 4 uses vertex -1, but the mesh has 4 vertices");

  soup = kTetrahedron;
  soup.positions[2].y() = std::nan("");
  EXPECT_EQ(errorOf(soup), "notFinite: vertex 2 has a coordinate that is not a finite number");

  soup = kTetrahedron;
  soup.triangles[2] = {1, 2, 1};
  EXPECT_EQ(errorOf(soup), "degenerateFace: face 2 uses vertex 1 twice");

  EXPECT_EQ(errorOf({{{0, 0, 0}}, {}}), "badFile: the mesh has no faces");
}

/// A tetrahedron among many others, so that the engine's numbers differ from the caller's.
TEST(ImportMesh, NamesTheCallersNumbersWhereItIsNotManifold) {
  TriangleSoup soup = randomSphere(300, 5);
  const Triangle t = soup.triangles[7];
  const int fin = soup.positions.count();
  soup.positions.push_back(2 * soup.positions[t[0]]);
  soup.triangles.push_back({t[1], t[0], fin});
  const auto [low, high] = std::minmax(t[0], t[1]);
  const std::string error = errorOf(soup);
  const std::string one = "nonManifoldEdge: edge " + std::to_string(low) + "-" +
                          std::to_string(high) + " has 3 faces; a surface allows two";
  const std::string other = "nonManifoldEdge: edge " + std::to_string(high) + "-" +
                            std::to_string(low) + " has 3 faces; a surface allows two";
  EXPECT_TRUE(error == one || error == other) << error;

  soup = randomSphere(300, 5);
  std::swap(soup.triangles[7][0], soup.triangles[7][1]);
  EXPECT_NE(errorOf(soup).find("7 "), std::string::npos);
  EXPECT_NE(errorOf(soup).find("in the same direction"), std::string::npos);

  soup = withCopy([](const Vec3& p) { return Vec3(-p); });
  for (Triangle& face : soup.triangles) {
    for (int& v : face) v = v == 4 ? 0 : v;
  }
  EXPECT_EQ(errorOf(soup),
            "nonManifoldVertex: vertex 0 joins more than one fan of faces: 3 of its 6 faces are "
            "connected around it");
}

TEST(ImportObj, ReportsEveryRepair) {
  const ImportedMesh imported = importObj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nv 1 1 0\nv 1 0 0\nv 2 0 0\n"
      "f 1 2 3 4\nf 6 7 8\n");
  EXPECT_EQ(imported.mesh.vertexCount(), 5);
  EXPECT_EQ(imported.mesh.faceCount(), 3);
  std::string repairs;
  for (const Repair& repair : imported.repairs) {
    repairs += std::string(repairName(repair.kind)) + " " + std::to_string(repair.count) + ": " +
               repair.sentence + "\n";
  }
  EXPECT_EQ(repairs,
            "triangulated 1: 1 polygon was cut into triangles\n"
            "welded 2: 2 vertices were welded to another at the same position\n"
            "dropped 1: 1 vertex that no face uses was left out\n");
  ASSERT_EQ(imported.droppedPositions.count(), 1);
  EXPECT_EQ(imported.droppedPositions[0], Vec3(9, 9, 9));
}

TEST(ImportObj, CountsRepeatedCornersOfPolygonsAndTriangles) {
  const ImportedMesh imported = importObj(
      "v 0 0 0\nv 1 0 0 # right\nv nan nan nan\nv 1 1 0\nv 0 1 0\n"
      "f 1 2 4 # half\nf 1 4 4 5\nf 1 1 2\n");
  ASSERT_EQ(imported.repairs.count(), 2);
  EXPECT_EQ(imported.repairs[0].kind, Repair::Kind::kRepeatedCorner);
  EXPECT_EQ(imported.repairs[0].count, 2);
  EXPECT_EQ(imported.repairs[1].kind, Repair::Kind::kDropped);
}

}  // namespace
}  // namespace karcher

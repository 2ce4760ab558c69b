#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "generators/defects.h"
#include "generators/grid.h"
#include "generators/random.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

using Counts = std::map<std::string, int>;

Counts countsOf(const ImportedMesh& imported) {
  Counts counts;
  for (const Repair& repair : imported.repairs) counts[repairName(repair.kind)] = repair.count;
  return counts;
}

Vec3 placeInSoup(const TriangleSoup& soup, int face, const Vec3& bary) {
  Vec3 place = Vec3::Zero();
  for (int k = 0; k < 3; ++k) place += bary[k] * soup.positions[soup.triangles[face][k]];
  return place;
}

/// Checks that points of every input triangle are at their place in the engine, and back.
void expectSamePlaces(const TriangleSoup& soup, const ImportedMesh& imported, double tolerance) {
  const TriangleMesh& mesh = imported.mesh;
  const Numbering& numbering = imported.numbering;
  ASSERT_EQ(numbering.inputFaceCount(), soup.triangles.count());
  ASSERT_EQ(numbering.inputFace.count(), mesh.faceCount());
  ASSERT_EQ(numbering.inputVertex.count(), mesh.vertexCount());
  for (int t = 0; t < soup.triangles.count(); ++t) {
    for (const Vec3& bary :
         {Vec3(0.2, 0.3, 0.5), Vec3(0.5, 0.5, 0), Vec3(0, 0, 1), Vec3(0.98, 0.01, 0.01)}) {
      const SurfacePoint point = toEngine(numbering, mesh, t, bary);
      const Vec3 place = placeInSoup(soup, t, bary);
      ASSERT_NEAR((position(mesh, point) - place).norm(), 0, tolerance) << "face " << t;
      const SurfacePoint back = toInput(numbering, point);
      ASSERT_NEAR((placeInSoup(soup, back.face, back.bary) - place).norm(), 0, tolerance)
          << "face " << t;
      const SurfacePoint again = toEngine(numbering, mesh, back.face, back.bary);
      ASSERT_NEAR((position(mesh, again) - position(mesh, point)).norm(), 0, tolerance);
    }
  }
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const SurfacePoint point = {f, Vec3(0.5, 0.2, 0.3)};
    const SurfacePoint input = toInput(numbering, point);
    const SurfacePoint back = toEngine(numbering, mesh, input.face, input.bary);
    ASSERT_EQ(back.face, f);
    ASSERT_NEAR((back.bary - point.bary).cwiseAbs().maxCoeff(), 0, 1e-9);
  }
}

/// Checks that the adjacency matches the faces.
void expectAdjacency(const TriangleMesh& mesh) {
  const TriangleMesh again = buildMesh(mesh.positions, mesh.faces);
  EXPECT_TRUE(again.twin == mesh.twin);
  EXPECT_TRUE(again.onBoundary == mesh.onBoundary);
}

/// The tolerance of places. For moved vertices it is sqrt(3) times 1e-9 of the diagonal.
double apart(Defect defect, const TriangleMesh& mesh) {
  return (defect == Defect::kSeams ? 1.8e-9 : 1e-14) * boundingBoxDiagonal(mesh);
}

/// The repair of each defect alone counts it, and leaves the shape unchanged.
TEST(RepairMesh, MendsEachDefectAlone) {
  for (const Shape shape : kShapes) {
    const TriangleSoup sound = makeShape(shape, 2000);
    const Topology before = topology(importMesh(sound).mesh);
    for (const Defect defect : kDefects) {
      SCOPED_TRACE(std::string(shapeName(shape)) + ", " + defectName(defect));
      DefectiveMesh made(sound, 3);
      const int count = made.add(defect, 7);
      ASSERT_GE(count, 7);
      const ImportedMesh imported = importMesh(made.soup());
      EXPECT_EQ(countsOf(imported), (Counts{{repairName(repairOf(defect)), count}}));
      expectAdjacency(imported.mesh);
      expectSamePlaces(made.soup(), imported, apart(defect, imported.mesh));
      const Topology after = topology(imported.mesh);
      const bool adds = defect == Defect::kFin || defect == Defect::kBowTie;
      EXPECT_EQ(after.components, before.components + (adds ? count : 0));
      EXPECT_EQ(after.boundaryLoops, before.boundaryLoops + (defect == Defect::kFin ? count : 0));
      EXPECT_EQ(after.genus, before.genus);
    }
  }
}

/// Pairs of defects are repaired, too. The last defect separates the vertices of the others, so
/// that another repair may apply to them.
TEST(RepairMesh, MendsDefectsInPairs) {
  SKIP_WHERE_SANITIZED();
  uint64_t seed = 100;
  for (const Shape shape : kShapes) {
    const TriangleSoup sound = makeShape(shape, 1000);
    for (const Defect one : kDefects) {
      for (const Defect other : kDefects) {
        if (one >= other) continue;
        SCOPED_TRACE(std::string(shapeName(shape)) + ", " + defectName(one) + " and " +
                     defectName(other) + ", seed " + std::to_string(++seed));
        DefectiveMesh made(sound, seed);
        Counts expected;
        expected[repairName(repairOf(one))] += made.add(one, 5);
        expected[repairName(repairOf(other))] += made.add(other, 5);
        const ImportedMesh imported = importMesh(made.soup());
        expectAdjacency(imported.mesh);
        expectSamePlaces(made.soup(), imported, apart(other, imported.mesh));
        if (other != Defect::kSeams) {
          EXPECT_EQ(countsOf(imported), expected);
        }
      }
    }
  }
}

TEST(RepairMesh, LeavesSoundMeshesAsTheyAre) {
  for (const Shape shape : kShapes) {
    const TriangleSoup sound = makeShape(shape, 3000);
    const ImportedMesh repaired = importMesh(sound);
    const ImportedMesh asItIs = importMesh(sound, {.repair = false});
    EXPECT_TRUE(repaired.repairs.empty());
    EXPECT_TRUE(repaired.mesh.positions == asItIs.mesh.positions);
    EXPECT_TRUE(repaired.mesh.faces == asItIs.mesh.faces);
    EXPECT_TRUE(repaired.mesh.twin == asItIs.mesh.twin);
    EXPECT_TRUE(repaired.mesh.outgoing == asItIs.mesh.outgoing);
    EXPECT_TRUE(repaired.numbering.engineFace == asItIs.numbering.engineFace);
    EXPECT_TRUE(repaired.numbering.engineVertex == asItIs.numbering.engineVertex);
  }
}

/*  A strip of n squares around a cylinder, closed with half a turn.  */
TriangleSoup moebius(int n, bool seam) {
  TriangleSoup soup;
  for (int i = 0; i <= n - (seam ? 0 : 1); ++i) {
    const double angle = 2 * kPi * i / n;
    const Vec3 out(std::cos(angle), std::sin(angle), 0);
    for (const double side : {-0.3, 0.3}) {
      soup.positions.push_back(
          out + side * (std::cos(angle / 2) * out + std::sin(angle / 2) * Vec3::UnitZ()));
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i;
    const bool last = i == n - 1 && !seam;
    const int c = last ? 1 : a + 2;
    const int d = last ? 0 : a + 3;
    soup.triangles.emplace_back(a, c, a + 1);
    soup.triangles.emplace_back(a + 1, c, d);
  }
  return soup;
}

TEST(RepairMesh, RefusesOneSidedSurfaces) {
  try {
    importMesh(moebius(20, false));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotOrientable);
    EXPECT_EQ(std::string(error.what()).substr(0, 35), "the surface has one side only, as a");
  }
  // With a seam the strip has two sides, and the seam stays open.
  const ImportedMesh strip = importMesh(moebius(20, true));
  EXPECT_EQ(topology(strip.mesh).boundaryLoops, 1);
  EXPECT_EQ(topology(strip.mesh).components, 1);
  EXPECT_EQ(strip.mesh.vertexCount(), 42);
}

TEST(RepairMesh, TurnsTheFewerFacesOver) {
  TriangleSoup soup = makeShape(Shape::kSphere, 500);
  for (int t = 0; t < soup.triangles.count() - 5; ++t) {
    std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  }
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(countsOf(imported), (Counts{{"turnedOver", 5}}));
  expectSamePlaces(soup, imported, 1e-14);
}

/// Two halves of a torus whose seams are a fraction of the diagonal apart.
TriangleSoup halves(double gap) {
  const TriangleMesh torus = importMesh(makeShape(Shape::kTorus, 4000)).mesh;
  TriangleSoup soup;
  std::map<std::pair<int, int>, int> number;
  for (const Triangle& t : torus.faces) {
    const int half =
        (torus.positions[t[0]] + torus.positions[t[1]] + torus.positions[t[2]]).x() > 0 ? 1 : 0;
    Triangle face;
    for (int k = 0; k < 3; ++k) {
      const auto [entry, isNew] = number.try_emplace({half, t[k]}, soup.positions.count());
      if (isNew) soup.positions.push_back(torus.positions[t[k]] + half * gap * Vec3::UnitZ());
      face[k] = entry->second;
    }
    soup.triangles.push_back(face);
  }
  return soup;
}

TEST(RepairMesh, WeldsWithinTheTolerance) {
  const double diagonal = boundingBoxDiagonal(importMesh(makeShape(Shape::kTorus, 4000)).mesh);
  const auto loops = [&](double gap, double weld) {
    return topology(importMesh(halves(gap * diagonal), {.repair = true, .weld = weld}).mesh)
        .boundaryLoops;
  };
  EXPECT_EQ(loops(0, -1), 0);
  EXPECT_EQ(loops(0.9e-6, -1), 0);
  EXPECT_EQ(loops(1.1e-6, -1), 4);
  EXPECT_EQ(loops(1.1e-6, 1.2e-6 * diagonal), 0);
  EXPECT_EQ(loops(0, 0), 4);
  // Triangles keep their corners even with a large tolerance.
  EXPECT_EQ(loops(0, 10 * diagonal), 0);
}

/// A grid, moved by `shift`, with separate vertices for its triangles, each moved by up to `most`
/// more.
TriangleSoup looseGrid(int n, double most, const Vec3& shift, Random& random) {
  TriangleSoup soup;
  const auto add = [&](int x, int y) {
    const Vec3 jitter(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    soup.positions.push_back(Vec3(x, y, 0) + shift + most / std::sqrt(3.0) * jitter);
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      for (const auto& corners : {std::array{0, 0, 1, 0, 1, 1}, std::array{0, 0, 1, 1, 0, 1}}) {
        const int first = soup.positions.count();
        for (size_t k = 0; k < 6; k += 2) add(x + corners[k], y + corners[k + 1]);
        soup.triangles.emplace_back(first, first + 1, first + 2);
      }
    }
  }
  return soup;
}

/// The repair first groups points in cubes. In any position it welds points within the tolerance,
/// and no farther ones.
TEST(RepairMesh, WeldsAcrossTheCellsOfTheGrid) {
  const uint64_t seed = 31;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  constexpr double kWeld = 1e-3;
  for (int i = 0; i < 20; ++i) {
    const Vec3 shift(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const ImportOptions options{.repair = true, .weld = kWeld};
    const ImportedMesh welded = importMesh(looseGrid(6, 0.49 * kWeld, shift, random), options);
    EXPECT_EQ(welded.mesh.vertexCount(), 49);
    EXPECT_EQ(topology(welded.mesh).boundaryLoops, 1);
    TriangleSoup soup = looseGrid(6, 0.2 * kWeld, shift, random);
    for (int v = 0; v < soup.positions.count(); ++v) {
      soup.positions[v].z() += v / 3 % 2 == 0 ? 0 : 1.5 * kWeld;
    }
    // The two triangles of a square are at different heights, and those at equal heights meet only
    // at vertices.
    EXPECT_EQ(importMesh(soup, options).mesh.vertexCount(), soup.positions.count());
  }
}

/// Many corners at three places, all within the tolerance: an edge would join more than two
/// triangles, so all stay apart.
TEST(RepairMesh, KeepsAClusterOfTrianglesApart) {
  Random random(4);
  TriangleSoup soup;
  constexpr int kCount = 20'000;
  for (int i = 0; i < kCount; ++i) {
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      const Vec3 jitter(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      soup.positions.push_back(place + 1e-8 * jitter);
    }
    soup.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(imported.mesh.faceCount(), kCount);
  ASSERT_EQ(imported.repairs.count(), 1);
  EXPECT_EQ(imported.repairs[0].kind, Repair::Kind::kKeptApart);
}

TEST(RepairMesh, SeparatesPartsThatOnlyTouch) {
  // Two triangles with a corner at one place, up to rounding.
  const TriangleSoup soup = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e-12, 0, 0}, {-1, 0, 0}, {0, -1, 0}},
      {{0, 1, 2}, {3, 4, 5}}};
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(topology(imported.mesh).components, 2);
  EXPECT_EQ(countsOf(imported), (Counts{{"keptApart", 1}}));
}

/*  A box with a wall inside: all edges around the wall have three faces.  */
TEST(RepairMesh, SeparatesAWallFromTheBoxAroundIt) {
  TriangleSoup soup;
  for (int x = 0; x <= 2; ++x) {
    for (const int y : {0, 1}) {
      for (const int z : {0, 1}) soup.positions.emplace_back(x, y, z);
    }
  }
  const auto quad = [&](int a, int b, int c, int d) {
    soup.triangles.emplace_back(a, b, c);
    soup.triangles.emplace_back(a, c, d);
  };
  for (const int x : {0, 4}) {
    quad(x, x + 4, x + 5, x + 1);
    quad(x + 2, x + 3, x + 7, x + 6);
    quad(x, x + 2, x + 6, x + 4);
    quad(x + 1, x + 5, x + 7, x + 3);
  }
  quad(0, 1, 3, 2);
  quad(8, 10, 11, 9);
  const Topology box = topology(importMesh(soup).mesh);
  EXPECT_EQ(box.boundaryLoops, 0);
  quad(4, 6, 7, 5);
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(countsOf(imported), (Counts{{"branching", 4}}));
  EXPECT_EQ(topology(imported.mesh).components, 2);
  EXPECT_EQ(topology(imported.mesh).boundaryLoops, 1);
  expectAdjacency(imported.mesh);
  expectSamePlaces(soup, imported, 1e-15);
}

/// A sheet of columns x rows quads over the plane, and its reversed copy with separate vertices.
TriangleSoup sheetWithItsBack(int columns, int rows) {
  TriangleSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) soup.positions.push_back(Vec3(i, j, 0.3 * i * j));
  }
  soup.triangles = gridTriangles(columns, rows, [](int, int) { return true; });
  const int vertices = soup.positions.count();
  const int faces = soup.triangles.count();
  for (int v = 0; v < vertices; ++v) soup.positions.push_back(Vec3(soup.positions[v]));
  for (int f = 0; f < faces; ++f) {
    const Triangle t = soup.triangles[f];
    soup.triangles.emplace_back(vertices + t[0], vertices + t[2], vertices + t[1]);
  }
  return soup;
}

TEST(RepairMesh, DoesNotTearASheetWithItsBack) {
  for (const auto& [columns, rows] :
       {std::pair(1, 1), {1, 8}, {8, 1}, {2, 2}, {2, 7}, {6, 6}, {20, 20}}) {
    const TriangleSoup soup = sheetWithItsBack(columns, rows);
    const ImportedMesh imported = importMesh(soup);
    SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
    expectAdjacency(imported.mesh);
    expectSamePlaces(soup, imported, 1e-12);
    EXPECT_EQ(imported.mesh.faceCount(), soup.triangles.count());
    EXPECT_EQ(topology(imported.mesh).components, 1);
    // Faces that the file joins stay joined.
    const TriangleMesh sheet =
        buildMesh({soup.positions.begin(), soup.positions.begin() + soup.positions.count() / 2},
                  {soup.triangles.begin(), soup.triangles.begin() + soup.triangles.count() / 2});
    for (int h = 0; h < sheet.halfedgeCount(); ++h) {
      if (sheet.twin[h] < 0) continue;
      for (const int copy : {0, sheet.faceCount()}) {
        const int f = imported.numbering.engineFace[copy + faceOf(h)];
        const int g = imported.numbering.engineFace[copy + faceOf(sheet.twin[h])];
        bool joined = false;
        for (int k = 0; k < 3; ++k) {
          const int twin = imported.mesh.twin[3 * f + k];
          joined = joined || (twin >= 0 && faceOf(twin) == g);
        }
        EXPECT_TRUE(joined) << "faces " << copy + faceOf(h) << " and "
                            << copy + faceOf(sheet.twin[h]);
      }
    }
  }
}

/// A face of the back occurs twice or thrice.
TEST(RepairMesh, LeavesOutARepeatedFaceOfASheetsBack) {
  for (const auto& [columns, rows] : {std::pair(1, 1), {6, 6}}) {
    for (const int copies : {1, 2}) {
      TriangleSoup soup = sheetWithItsBack(columns, rows);
      const int faces = soup.triangles.count();
      const Triangle back = soup.triangles[3 * faces / 4];
      for (int i = 0; i < copies; ++i) soup.triangles.push_back(back);
      const ImportedMesh imported = importMesh(soup);
      EXPECT_EQ(countsOf(imported)["duplicate"], copies);
      EXPECT_EQ(countsOf(imported).count("turnedOver"), 0);
      EXPECT_EQ(imported.mesh.faceCount(), faces);
      EXPECT_EQ(topology(imported.mesh).components, 1);
      expectSamePlaces(soup, imported, 1e-12);
    }
  }
}

/// The input faces at the edges of each input face, and those around each input vertex: independent
/// of the engine's numbering.
Array<Array<int>> neighborsInFile(const ImportedMesh& imported) {
  const auto& [mesh, numbering] = std::tie(imported.mesh, imported.numbering);
  Array<Array<int>> result;
  for (const int f : numbering.engineFace) {
    Array<int> faces;
    for (int k = 0; k < 3; ++k) {
      const int twin = mesh.twin[3 * f + k];
      faces.push_back(twin < 0 ? -1 : numbering.inputFace[faceOf(twin)]);
    }
    std::sort(faces.begin(), faces.end());
    result.push_back(faces);
  }
  for (const int v : numbering.engineVertex) {
    Array<int> faces;
    for (const int h : outgoingHalfedges(mesh, v)) faces.push_back(numbering.inputFace[faceOf(h)]);
    std::sort(faces.begin(), faces.end());
    result.push_back(faces);
  }
  return result;
}

TEST(RepairMesh, SeparatesBowTiesAndWallsAlikeInEveryPosition) {
  // A grid, a tetrahedron on an inner vertex, another on a boundary vertex, and walls on two of its
  // edges, where the surface continues alike on both sides.
  TriangleSoup soup;
  for (int j = 0; j <= 5; ++j) {
    for (int i = 0; i <= 5; ++i) soup.positions.push_back(Vec3(i, j, 0));
  }
  soup.triangles = gridTriangles(5, 5, [](int, int) { return true; });
  for (const int v : {14, 3}) {
    const int a = soup.positions.count();
    const Vec3 tip = soup.positions[v];
    soup.positions.insert(soup.positions.end(), {tip + Vec3(0.3, 0, 1), tip + Vec3(-0.2, 0.3, 1),
                                                 tip + Vec3(-0.2, -0.3, 1)});
    soup.triangles.insert(soup.triangles.end(),
                          {{v, a, a + 1}, {v, a + 1, a + 2}, {v, a + 2, a}, {a, a + 2, a + 1}});
  }
  for (const int v : {20, 26}) {
    const int a = soup.positions.count();
    soup.positions.push_back((soup.positions[v] + soup.positions[v + 1]) / 2 + Vec3(0, 0, 1));
    soup.positions.push_back((soup.positions[v] + soup.positions[v + 1]) / 2 - Vec3(0, 0, 1));
    soup.triangles.insert(soup.triangles.end(), {{v, v + 1, a}, {v + 1, v, a + 1}});
  }
  const Array<Array<int>> expected = neighborsInFile(importMesh(soup));
  const uint64_t seed = 40;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 40; ++i) {
    const Vec2 turns[3] = {unitVector(random.uniform(0, 7)), unitVector(random.uniform(0, 7)),
                           unitVector(random.uniform(0, 7))};
    TriangleSoup turned = soup;
    for (Vec3& p : turned.positions) {
      for (int k = 0; k < 3; ++k) {
        const Vec2 q = rotate(turns[k], Vec2(p[k], p[(k + 1) % 3]));
        p[k] = q.x();
        p[(k + 1) % 3] = q.y();
      }
    }
    EXPECT_TRUE(neighborsInFile(importMesh(turned)) == expected) << "turn " << i;
  }
}

TEST(RepairMesh, FlipsAChainOfTrianglesOnALine) {
  TriangleSoup soup = {{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}}, {{0, 1, 2}}};
  Array<int> line = {0};
  for (int i = 1; i < 20; ++i) {
    line.push_back(soup.positions.count());
    soup.positions.emplace_back(i / 20.0, 0, 0);
  }
  line.push_back(1);
  for (int i = 0; i + 1 < line.count(); ++i) soup.triangles.emplace_back(line[i + 1], line[i], 3);
  // The triangles between the edge 0-1 and the vertices on it.
  for (int i = 1; i + 1 < line.count(); ++i) soup.triangles.emplace_back(0, line[i], line[i + 1]);
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(countsOf(imported), (Counts{{"noArea", 19}}));
  EXPECT_EQ(imported.mesh.faceCount(), 40);
  EXPECT_EQ(topology(imported.mesh).boundaryLoops, 1);
  expectAdjacency(imported.mesh);
  expectSamePlaces(soup, imported, 1e-12);
}

TEST(RepairMesh, RefusesMeshesWithoutArea) {
  const TriangleSoup soup = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  try {
    importMesh(soup);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "no face has an area: the corners of each lie on a line, or two are the same");
  }
}

TEST(RepairMesh, RefusesAPointOfADroppedFace) {
  TriangleSoup soup = makeShape(Shape::kSphere, 500);
  const int lone = soup.positions.count();
  soup.positions.emplace_back(5, 5, 5);
  soup.triangles.emplace_back(lone, lone, lone);
  const ImportedMesh imported = importMesh(soup);
  EXPECT_EQ(countsOf(imported), (Counts{{"repeatedCorner", 1}, {"dropped", 1}}));
  EXPECT_THROW(toEngine(imported.numbering, imported.mesh, soup.triangles.count() - 1, {1, 0, 0}),
               Error);
}

}  // namespace
}  // namespace karcher

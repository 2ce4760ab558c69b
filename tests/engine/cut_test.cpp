#include "regions/cut.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "mesh/shapes.h"
#include "support.h"

/// Cuts of surfaces along paths.
namespace karcher {
namespace {

using Place = std::array<double, 3>;

Place placeOf(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

double areaOf(const Array<Vec3>& positions, const Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm() / 2;
}

/// The boundary sides of triangles, by their places.
std::map<std::pair<Place, Place>, int> rim(const Array<Vec3>& positions,
                                           const Array<Triangle>& triangles) {
  std::set<std::pair<int, int>> sides;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) sides.emplace(t[k], t[(k + 1) % 3]);
  }
  std::map<std::pair<Place, Place>, int> result;
  for (const auto& [a, b] : sides) {
    if (sides.count({b, a}) == 0) ++result[{placeOf(positions[a]), placeOf(positions[b])}];
  }
  return result;
}

/// Properties of every cut surface.
void expectSound(const Geometry& geometry, const Arrangement& all) {
  const TriangleMesh& mesh = *geometry.mesh;
  const CutSurface cut = cutApart(geometry, all);
  const Array<CutPart> parts = partsOf(cut, all.cellCount());
  Array<double> ofFace(static_cast<size_t>(mesh.faceCount()), 0);
  for (int c = 0; c < parts.count(); ++c) {
    const CutPart& part = parts[c];
    double area = 0;
    for (int t = 0; t < part.triangles.count(); ++t) {
      const double one = areaOf(part.positions, part.triangles[t]);
      area += one;
      ofFace[part.faceOf[t]] += one;
      // Each triangle lies in its old face.
      const int f = part.faceOf[t];
      Vec3 middle = Vec3::Zero();
      for (int k = 0; k < 3; ++k) middle += part.positions[part.triangles[t][k]] / 3;
      const Vec2 inPlane = toFace(geometry, f, middle - mesh.positions[mesh.corner(f, 0)]);
      EXPECT_GE(barycentric(geometry, f, inPlane).minCoeff(), -1e-9);
    }
    EXPECT_NEAR(area, all.cellArea[c], 1e-12 * surfaceArea(geometry));
    // The part is a manifold, except that its triangles may be as thin as pieces are.
    EXPECT_NO_THROW(connectMesh(part.positions, part.triangles, {}));
  }
  for (int f = 0; f < mesh.faceCount(); ++f) {
    EXPECT_NEAR(ofFace[f], doubleArea(geometry, f) / 2, 1e-12 * surfaceArea(geometry));
  }
  // Both sides of a cut fit to the last bit; the remaining sides are the mesh's own boundary.
  const auto sides = rim(cut.positions, cut.triangles);
  Array<double> lone;
  for (const auto& [side, count] : sides) {
    const auto other = sides.find({side.second, side.first});
    const int across = other == sides.end() ? 0 : other->second;
    if (across == count) continue;
    ASSERT_EQ(across, 0);
    lone.push_back((Vec3(side.first.data()) - Vec3(side.second.data())).norm());
  }
  double boundary = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin[h] < 0) boundary += geometry.edgeLength[h];
  }
  double sum = 0;
  for (const double length : lone) sum += length;
  EXPECT_NEAR(sum, boundary, 1e-9 * geometry.diagonal);
}

TEST(Cut, OfASheetWithAHoleAndASlit) {
  const Sheet sheet(planeGrid(6, 6));
  const SurfacePath paths[] = {
      polygonOn(sheet.geometry, {{1.3, 1.2}, {4.4, 1.2}, {4.4, 4.1}, {1.3, 4.1}}),
      polygonOn(sheet.geometry, {{2.5, 2.1}, {2.7, 2.1}, {2.7, 2.3}}),
      polygonOn(sheet.geometry, {{5.2, 0.4}, {5.4, 2.3}, {4.9, 3.1}}, false)};
  const Arrangement all = arrange(sheet.geometry, paths);
  expectSound(sheet.geometry, all);
  const Array<CutPart> parts = partsOf(cutApart(sheet.geometry, all), all.cellCount());
  ASSERT_EQ(parts.size(), 3U);
  Array<int> loops;
  for (const CutPart& part : parts) {
    loops.push_back(topology(connectMesh(part.positions, part.triangles, {})).boundaryLoops);
  }
  EXPECT_EQ(loops, (Array<int>{3, 2, 1})) << "the outer part has the rim, a hole and the slit";
}

TEST(Cut, OfATorusRoundItsTubeIsATube) {
  const Sheet torus(meshOf(makeShape(Shape::kTorus, 1000)));
  Array<SurfacePoint> points;
  for (const double y : {0.05, 0.3, 0.55, 0.8}) {
    points.push_back(nearestPoint(torus.mesh, conformalTorus({0.3, y * kTorusPeriod})));
  }
  const SurfacePath path = chain(torus.geometry, points, true);
  const Arrangement all = arrange(torus.geometry, std::span(&path, 1));
  expectSound(torus.geometry, all);
  const Array<CutPart> parts = partsOf(cutApart(torus.geometry, all), all.cellCount());
  ASSERT_EQ(parts.size(), 1U);
  const Topology tube = topology(connectMesh(parts[0].positions, parts[0].triangles, {}));
  EXPECT_EQ(tube.boundaryLoops, 2);
  EXPECT_EQ(tube.genus, 0);
}

TEST(Cut, OfRandomDrawingsFits) {
  const std::pair<const char*, TriangleMesh> meshes[] = {
      {"plane", meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 300, 3))},
      {"stretched plane", meshOf(tessellatedPlane(PlaneTessellation::kStretched, 300, 3))},
      {"sphere", meshOf(randomSphere(400, 2))},
      {"coarse sphere", meshOf(icosphere(1))},
      {"torus", meshOf(irregularTorus(400, 1, 4))},
      {"genus 3", meshOf(makeShape(Shape::kGenus3, 1000))},
      {"square", planeGrid(1, 1)}};
  const uint64_t rounds = longRun() ? 300 : 6;
  for (const auto& [name, mesh] : meshes) {
    const Geometry geometry = buildGeometry(mesh);
    for (uint64_t seed = 1; seed <= rounds; ++seed) {
      SCOPED_TRACE(std::string(name) + ", seed " + std::to_string(seed));
      Random random(seed);
      expectSound(geometry, arrange(geometry, randomDrawing(geometry, random)));
    }
  }
}

}  // namespace
}  // namespace karcher

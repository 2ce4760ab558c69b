#include <gtest/gtest.h>

#include <sstream>

#include "generators/plane.h"
#include "log_maps.h"
#include "support.h"

namespace karcher {
namespace {

LogMap logMap(const HeatOperators& operators, const SurfacePoint& source) {
  return logMapFromPoint(
      operators.geometry(), [&](int v) { return vectorHeatLogMap(operators, v); }, source);
}

TEST(VectorHeat, LogMapsAgreeWithAnIndependentLibrary) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  std::ifstream file = testData("bunny_vector_heat_logs.txt");
  std::string line;
  int sources = 0;
  while (std::getline(file, line)) {
    if (line[0] == '#') continue;
    SCOPED_TRACE("source " + std::to_string(sources++));
    std::istringstream words(line);
    int face = 0;
    Vec3 bary;
    words >> face >> bary[0] >> bary[1] >> bary[2];
    const LogMap logs = logMap(operators, checkedPoint(mesh, face, bary));
    Array<Vec2> expected;
    for (Vec2 log; words >> log[0] >> log[1];) expected.push_back(log);
    ASSERT_EQ(expected.count(), (mesh.vertexCount() + 2) / 3);
    const auto toComplex = [](const Vec2& v) { return Complex(v.x(), v.y()); };
    // The sum gives the library's frame at the source, as the best fitting rotation.
    Complex sum = 0;
    for (int i = 0; i < expected.count(); ++i) {
      sum += toComplex(expected[i]) * std::conj(toComplex(logs[3 * i]));
    }
    const Vec2 rotation = toVec2(sum / std::abs(sum));
    for (int i = 0; i < expected.count(); ++i) {
      // The file has 11 decimals for lengths up to 11.
      EXPECT_LE((rotate(rotation, logs[3 * i]) - expected[i]).norm(), 1e-9 * expected[i].norm());
    }
  }
  EXPECT_EQ(sources, 6);
}

TEST(VectorHeat, LogMapsScaleWithTheMesh) {
  const TriangleMesh mesh = bunnyMesh();
  Array<Vec3> scaled = mesh.positions;
  for (Vec3& p : scaled) p *= 1000;
  const TriangleMesh largeMesh = buildMesh(scaled, mesh.faces);
  const Geometry geometry = buildGeometry(mesh);
  const Geometry largeGeometry = buildGeometry(largeMesh);
  const SurfacePoint source{700, Vec3(0.2, 0.5, 0.3)};
  const LogMap logs = logMap(HeatOperators(geometry), source);
  const LogMap largeLogs = logMap(HeatOperators(largeGeometry), source);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_LT((largeLogs[v] / 1000 - logs[v]).norm(), 1e-9 * logs[v].norm());
  }
}

TEST(VectorHeat, LogMapFromAnEdgeIsTheSameFromBothFaces) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  const int h = 1001;
  const LogMap here = logMap(operators, edgePoint(h, 0.3));
  const LogMap there = logMap(operators, edgePoint(mesh.twin[h], 0.7));
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_LT((acrossEdge(geometry, h, here[v]) - there[v]).norm(), 1e-12 * geometry.diagonal);
  }
}

TEST(VectorHeat, HasNoLogarithmOnAnotherComponent) {
  // The mesh is two triangles apart.
  const TriangleMesh mesh = buildMesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  for (const SurfacePoint& source : {SurfacePoint{0, Vec3(1, 0, 0)}, {0, Vec3(0.2, 0.5, 0.3)}}) {
    const LogMap logs = logMap(operators, source);
    for (int v = 0; v < 3; ++v) EXPECT_TRUE(logs[v].allFinite());
    for (int v = 3; v < 6; ++v) EXPECT_EQ(logs[v], noLogarithm());
  }
}

TEST(VectorHeat, RefusesATimeThatIsNotPositive) {
  const TriangleMesh mesh = planeGrid(2, 2);
  const Geometry geometry = buildGeometry(mesh);
  HeatOptions options;
  for (const double factor : {0.0, -1.0, std::nan(""), kInfinity}) {
    options.timeFactor = factor;
    EXPECT_THROW(HeatOperators(geometry, options), Error);
  }
}

}  // namespace
}  // namespace karcher

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "curve_times.h"
#include "distance/edge_dijkstra.h"
#include "intrinsic/straightest.h"
#include "mesh/loop_subdivision.h"
#include "mesh/mesh_import.h"

/// Whether an edit's cost grows with the mesh: a B-spline on a mesh after LEVELS steps of Loop
/// subdivision and after two steps less, its points equally many mean edges apart (on the large
/// one 4 % of the diagonal), so that its fields hold equally many vertices. One JSON object.
///
///   large_bench MESH.obj [LEVELS]      4 by default
namespace karcher {
namespace {

constexpr int kPoints = 7;
constexpr int kSamples = 128;
constexpr double kSpacing = 0.04;
constexpr uint64_t kSeed = 3;

TriangleSoup refined(TriangleMesh mesh, int levels) {
  TriangleSoup soup = loopSubdivision(mesh);
  for (int i = 1; i < levels; ++i) soup = loopSubdivision(importMesh(std::move(soup)).mesh);
  return soup;
}

/// Points in a zigzag along straightest geodesics.
Array<SurfacePoint> zigzag(const Geometry& geometry, double spacing) {
  Random random(kSeed);
  Array<SurfacePoint> points{randomPoint(*geometry.mesh, random)};
  Vec2 direction(1, 0);
  while (points.count() < kPoints) {
    const Vec2 turned = rotate(unitVector(points.count() % 2 == 0 ? 0.7 : -0.7), direction);
    const StraightestPath path = traceStraightest(geometry, points.back(), spacing * turned);
    points.push_back(path.points.back());
    direction = path.direction;
  }
  return points;
}

struct Measured {
  int triangles = 0;
  double meanEdge = 0;
  double diagonal = 0;
  double prepareMs = 0;
  double calibrationNs = 0;
  int fieldVertices = 0;
  CurveTimes curve;
};

/// `spacing` in mean edges; 0 for kSpacing of the diagonal.
Measured measure(TriangleSoup soup, double spacing) {
  Measured result;
  std::unique_ptr<Surface> surface;
  result.prepareMs = timed([&] {
    surface = std::make_unique<Surface>(importMesh(std::move(soup)).mesh);
    surface->vertexFans();
  });
  const Geometry& geometry = surface->geometry();
  result.triangles = surface->mesh().faceCount();
  result.meanEdge = geometry.meanEdge;
  result.diagonal = geometry.diagonal;
  const double length = spacing > 0 ? spacing * geometry.meanEdge : kSpacing * geometry.diagonal;
  const FieldOptions options{Method::kKarcher, Solver::kFast, 6};
  const Array<SurfacePoint> points = zigzag(geometry, length);
  result.curve = timeCurve(*surface, points, kSamples, options);
  PointField field(*surface, options);
  field.setPoint(points[kPoints / 2]);
  result.fieldVertices = verticesWithin(*surface, field, length).count();
  result.calibrationNs =
      1e6 * timed([&] { edgeDijkstra(geometry, 0); }) / surface->mesh().vertexCount();
  return result;
}

void print(const char* name, const Measured& m) {
  std::printf(
      "\"%s\":{\"triangles\":%d,\"prepareMs\":%.0f,\"fieldVertices\":%d,\"sampleNs\":%.1f,"
      "\"samples\":%d,\"lost\":%d,\"dragMs\":%.3f,\"bridgeMs\":%.3f,\"joinMs\":%.3f,"
      "\"calibrationNs\":%.1f}",
      name, m.triangles, m.prepareMs, m.fieldVertices, 1000 * m.curve.sampleUs, m.curve.samples,
      m.curve.lost, m.curve.dragMs, m.curve.bridgeMs, m.curve.joinMs, m.calibrationNs);
}

void run(const std::string& path, int levels) {
  const TriangleMesh mesh = loadBenchMesh(path, "").mesh;
  const Measured large = measure(refined(mesh, levels), 0);
  const double peak = peakMemoryMB();
  const double spacing = kSpacing * large.diagonal / large.meanEdge;
  const Measured small = measure(refined(mesh, levels - 2), spacing);
  std::printf("{");
  print("large", large);
  std::printf(",");
  print("small", small);
  std::printf(",\"dragRatio\":%.2f,\"peakMemoryMB\":%.0f}\n",
              large.curve.dragMs / small.curve.dragMs, peak);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const int levels = argc == 3 ? std::atoi(argv[2]) : 4;
  if (argc < 2 || argc > 3 || levels < 3 || levels > 6) {
    std::fprintf(stderr, "usage: large_bench MESH.obj [LEVELS]      LEVELS from 3 to 6\n");
    return 1;
  }
  try {
    karcher::run(argv[1], levels);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

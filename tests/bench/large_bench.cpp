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
#include "peers/timed_field.h"

/// The growth of an edit's cost with the mesh, as one JSON object. B-splines lie at several places
/// of a mesh after LEVELS steps of Loop subdivision and after two steps less. Their points are 4 %
/// of the diagonal apart on the large mesh. On the small one they are so far apart that the fields
/// hold as many vertices as there. Each time is a median over the places.
///
///   large_bench MESH.obj [LEVELS]      4 by default
namespace karcher {
namespace {

constexpr int kPoints = 7;
constexpr int kSamples = 128;
constexpr double kSpacing = 0.04;
constexpr int kPlaces = 9;

TriangleSoup refined(TriangleMesh mesh, int levels) {
  TriangleSoup soup = loopSubdivision(mesh);
  for (int i = 1; i < levels; ++i) soup = loopSubdivision(importMesh(std::move(soup)).mesh);
  return soup;
}

/// Points in a zigzag along straightest geodesics, from a random place.
Array<SurfacePoint> zigzag(const Geometry& geometry, double spacing, uint64_t seed) {
  Random random(seed);
  Array<SurfacePoint> points{randomPoint(*geometry.mesh, random)};
  Vec2 direction(1, 0);
  while (points.count() < kPoints) {
    const Vec2 turned = rotate(unitVector(points.count() % 2 == 0 ? 0.7 : -0.7), direction);
    const StraightestPath path = traceStraightest(geometry, points.back(), spacing * turned);
    points.push_back(path.path.end());
    direction = path.direction;
  }
  return points;
}

constexpr FieldOptions kField{Method::kKarcher, Solver::kFast, 6};

struct Subject {
  std::unique_ptr<Surface> surface;
  double prepareMs = 0;
  double calibrationNs = 0;

  const Geometry& geometry() const { return surface->geometry(); }
};

Subject prepare(TriangleSoup soup) {
  Subject subject;
  subject.prepareMs =
      timed([&] { subject.surface = std::make_unique<Surface>(importMesh(std::move(soup)).mesh); });
  subject.calibrationNs = 1e6 * medianTime([&] { edgeDijkstra(subject.geometry(), 0); }) /
                          subject.surface->mesh().vertexCount();
  return subject;
}

/// The average number of vertices nearer to a place's middle point than its neighbours.
double fieldVertices(const Subject& subject, double spacing) {
  double sum = 0;
  for (int place = 1; place <= kPlaces; ++place) {
    const Array<SurfacePoint> points =
        zigzag(subject.geometry(), spacing, static_cast<uint64_t>(place));
    sum += TimedField(*subject.surface, kField, points[kPoints / 2], spacing).vertexCount();
  }
  return sum / kPlaces;
}

/// The spacing at which fields hold about this many vertices: their number grows with its square.
double spacingFor(const Subject& subject, double spacing, double vertices) {
  for (int i = 0; i < 4; ++i) spacing *= std::sqrt(vertices / fieldVertices(subject, spacing));
  return spacing;
}

/// Medians over the places, and the sums of counts.
CurveTimes timePlaces(const Subject& subject, double spacing) {
  Array<double> sample, drag, bridge, join;
  CurveTimes result;
  for (int place = 1; place <= kPlaces; ++place) {
    const Array<SurfacePoint> points =
        zigzag(subject.geometry(), spacing, static_cast<uint64_t>(place));
    const CurveTimes times = timeCurve(*subject.surface, points, kSamples, kField);
    sample.push_back(times.sampleUs);
    drag.push_back(times.dragMs);
    bridge.push_back(times.bridgeMs);
    join.push_back(times.joinMs);
    result.samples += times.samples;
    result.lost += times.lost;
  }
  result.sampleUs = median(sample);
  result.dragMs = median(drag);
  result.bridgeMs = median(bridge);
  result.joinMs = median(join);
  return result;
}

void print(const char* name, const Subject& subject, double vertices, const CurveTimes& times) {
  std::printf(
      "\"%s\":{\"triangles\":%d,\"prepareMs\":%.0f,\"fieldVertices\":%.0f,\"sampleNs\":%.1f,"
      "\"samples\":%d,\"lost\":%d,\"dragMs\":%.3f,\"bridgeMs\":%.3f,\"joinMs\":%.3f,"
      "\"calibrationNs\":%.1f}",
      name, subject.surface->mesh().faceCount(), subject.prepareMs, vertices, 1000 * times.sampleUs,
      times.samples, times.lost, times.dragMs, times.bridgeMs, times.joinMs, subject.calibrationNs);
}

void run(const std::string& path, int levels) {
  const TriangleMesh mesh = loadBenchMesh(path, "").mesh;
  const Subject large = prepare(refined(mesh, levels));
  const double spacing = kSpacing * large.geometry().diagonal;
  const double vertices = fieldVertices(large, spacing);
  const CurveTimes onLarge = timePlaces(large, spacing);
  const double peak = peakMemoryMB();

  const Subject small = prepare(refined(mesh, levels - 2));
  const double start = spacing / large.geometry().meanEdge * small.geometry().meanEdge;
  const double smallSpacing = spacingFor(small, start, vertices);
  const CurveTimes onSmall = timePlaces(small, smallSpacing);
  std::printf("{");
  print("large", large, vertices, onLarge);
  std::printf(",");
  print("small", small, fieldVertices(small, smallSpacing), onSmall);
  std::printf(",\"dragRatio\":%.2f,\"peakMemoryMB\":%.0f}\n", onLarge.dragMs / onSmall.dragMs,
              peak);
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

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "bench_support.h"
#include "curve_times.h"
#include "distance/edge_dijkstra.h"
#include "peers/timed_field.h"

/// The timings of a mesh and a B-spline on it, as one JSON object: the native twin of `karcher
/// bench MESH.obj --points FILE --samples N`, whose help explains each number. They are medians of
/// several runs, except for the graph.
namespace karcher {
namespace {

/// A whole field within a radius, as a curve reads it: distances, then the estimate at each vertex.
struct FieldTimes {
  double ms = 0;
  int vertices = 0;
};

FieldTimes timeField(Surface& surface, const SurfacePoint& point, Solver solver, double radius) {
  TimedField field(surface, {Method::kKarcher, solver, 6}, point, radius);
  const double ms = medianTime([&] { field.read(); }, kQuickRuns);
  return {ms, field.vertexCount()};
}

void run(const std::string& meshPath, const std::string& pointsPath, int samples) {
  BenchMesh input = loadBenchMesh(meshPath, pointsPath);
  const int vertices = input.mesh.vertexCount();
  const int triangles = input.mesh.faceCount();

  std::unique_ptr<Surface> surface;
  const double prepareMs = medianTime([&] {
    surface = std::make_unique<Surface>(buildMesh(input.mesh.positions, input.mesh.faces));
  });
  const double calibration =
      1e6 * medianTime([&] { edgeDijkstra(surface->geometry(), 0); }) / vertices;

  const double graphMs = timed([&] { surface->ringGraph(6); });
  surface->gradientOperator();
  const auto paperField = [&](Solver solver) {
    return medianTime([&] {
      PointField field(*surface, {Method::kPaper, solver, 6});
      field.setPoint(input.points[0]);
    });
  };
  const double fieldGraphMs = paperField(Solver::kGraph);
  const double fieldExactMs = paperField(Solver::kExact);
  const Array<double> values(static_cast<size_t>(vertices), 1.0);
  const double gradientMs = medianTime([&] { applyGradient(surface->gradientOperator(), values); });
  const CurveTimes paper =
      timeCurve(*surface, input.points, samples, {Method::kPaper, Solver::kGraph, 6});

  const double radius = 0.1 * surface->geometry().diagonal;
  const FieldTimes fast = timeField(*surface, input.points[0], Solver::kFast, radius);
  const FieldTimes windows = timeField(*surface, input.points[0], Solver::kExact, radius);
  const CurveTimes karcher =
      timeCurve(*surface, input.points, samples, {Method::kKarcher, Solver::kFast, 6});

  const SteadyTimes steady = timeSteadyDrag(*surface, input.points, samples);

  std::printf(
      "{\"mesh\":{\"vertices\":%d,\"triangles\":%d},\"prepareMs\":%.3f,"
      "\"paper\":{\"graphMs\":%.1f,\"fieldGraphMs\":%.3f,\"fieldExactMs\":%.3f,"
      "\"gradientMs\":%.3f,\"sampleUs\":%.4f,\"samples\":%d,\"lost\":%d,\"dragMs\":%.3f,"
      "\"bridgeMs\":%.3f,\"joinMs\":%.3f,\"weightMs\":%.3f},"
      "\"karcher\":{\"fieldMs\":%.3f,\"fieldVertices\":%d,\"fieldNsPerVertex\":%.1f,"
      "\"sampleNs\":%.1f,\"samples\":%d,\"lost\":%d,\"dragMs\":%.3f,\"bridgeMs\":%.3f,\"joinMs\":%."
      "3f,"
      "\"weightMs\":%.3f},"
      "\"steady\":{\"levels\":%d,\"dragMs\":%.3f},"
      "\"exact\":{\"fieldMs\":%.3f,\"fieldVertices\":%d,\"fieldNsPerVertex\":%.1f},"
      "\"calibrationNs\":%.1f,\"peakMemoryMB\":%.1f}\n",
      vertices, triangles, prepareMs, graphMs, fieldGraphMs, fieldExactMs, gradientMs,
      paper.sampleUs, paper.samples, paper.lost, paper.dragMs, paper.bridgeMs, paper.joinMs,
      paper.weightMs, fast.ms, fast.vertices, 1e6 * fast.ms / fast.vertices,
      1000 * karcher.sampleUs, karcher.samples, karcher.lost, karcher.dragMs, karcher.bridgeMs,
      karcher.joinMs, karcher.weightMs, steady.levels, steady.dragMs, windows.ms, windows.vertices,
      1e6 * windows.ms / windows.vertices, calibration, peakMemoryMB());
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const int samples = argc == 4 ? std::atoi(argv[3]) : 128;
  if (argc < 3 || argc > 4 || samples < 2) {
    std::fprintf(stderr, "usage: karcher_bench MESH.obj POINTS.txt [SAMPLES]\n");
    return 1;
  }
  try {
    karcher::run(argv[1], argv[2], samples);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

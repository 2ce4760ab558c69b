#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/curve_shapes.h"

/// Samples whose search did not converge, on uniform cubic B-splines of 256 samples a segment, of
/// level 0 and of automatic levels. The control points are those of the file, or the nearest
/// corners of their faces.
///
///   lost_study MESH.obj POINTS.txt [MESH.obj POINTS.txt ...]
namespace karcher {
namespace {

constexpr int kSamples = 256;

SurfacePoint snapped(const SurfacePoint& p) {
  int corner = 0;
  for (int k = 1; k < 3; ++k) {
    if (p.bary[k] > p.bary[corner]) corner = k;
  }
  return edgePoint(3 * p.face + corner, 0);
}

int lost(Surface& surface, const Array<SurfacePoint>& points, Solver solver, int levels) {
  CurveOptions options =
      ofLevelZero({CurveKind::kBSpline}, kSamples, {Method::kKarcher, solver, 6});
  options.levels = levels;
  Curve curve(surface, options, points);
  int count = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      count += sample.status != SampleStatus::kConverged;
    }
  }
  return count;
}

void study(const std::string& meshPath, const std::string& pointsPath) {
  BenchMesh input = loadBenchMesh(meshPath, pointsPath);
  Surface surface(std::move(input.mesh));
  Array<SurfacePoint> atVertices;
  for (const SurfacePoint& p : input.points) atVertices.push_back(snapped(p));
  const int total = (input.points.count() - 3) * kSamples;
  for (const int levels : {0, kAutomaticLevels}) {
    std::printf("| %s | %s | %d |", meshPath.c_str(), levels == 0 ? "0" : "auto", total);
    for (const Solver solver : {Solver::kFast, Solver::kExact}) {
      for (const Array<SurfacePoint>& points : {input.points, atVertices}) {
        std::printf(" %d |", lost(surface, points, solver, levels));
      }
    }
    std::printf("\n");
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) {
    std::fprintf(stderr, "usage: lost_study MESH.obj POINTS.txt [MESH.obj POINTS.txt ...]\n");
    return 1;
  }
  try {
    std::printf(
        "| mesh | levels | samples | lost, fast | at vertices | lost, exact | at vertices |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
    for (int i = 1; i + 1 < argc; i += 2) karcher::study(argv[i], argv[i + 1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

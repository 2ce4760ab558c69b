#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"

/// The paper's method against curves that its authors' program traced: the distance in mean edges
/// between samples at the same parameter, except where the authors' curves repeat a position.
///
///   authors_study MESH.obj POINTS.txt AUTHORS.json exact|graph
namespace karcher {
namespace {

constexpr int kSamples = 257;

void study(const std::string& meshPath, const std::string& pointsPath,
           const std::string& authorsPath, Solver solver) {
  BenchMesh input = loadBenchMesh(meshPath, pointsPath);
  Surface surface(std::move(input.mesh));
  const CurveOptions options{{CurveKind::kBSpline}, kSamples, {Method::kPaper, solver, 6}};
  Curve curve(surface, options, input.points);
  size_t at = 0;
  const Array<Vec3> theirs = readPositions(readFile(authorsPath), "positions", at);
  Array<double> errors;
  int lost = 0;
  int total = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (int i = 0; i < kSamples - 1; ++i) {
      ++total;
      const CurveSample& sample = curve.samples(j)[i];
      lost += sample.status != SampleStatus::kConverged;
      const int k = j * (kSamples - 1) + i;
      if (k > 0 && theirs[k] == theirs[k - 1]) continue;
      const double distance = (position(surface.mesh(), sample.point) - theirs[k]).norm();
      errors.push_back(distance / surface.geometry().meanEdge);
    }
  }
  std::printf("| %s | %s | %d | %d | %.4f | %.4f | %.4f | %d |\n", meshPath.c_str(),
              solver == Solver::kExact ? "exact" : "graph", total, errors.count(), median(errors),
              quantile(errors, 0.95), quantile(errors, 1), lost);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  const std::string solver = argc == 5 ? argv[4] : "";
  if (solver != "exact" && solver != "graph") {
    std::fprintf(stderr, "usage: authors_study MESH.obj POINTS.txt AUTHORS.json exact|graph\n");
    return 1;
  }
  try {
    std::printf(
        "| mesh | solver | samples | compared | median h | 95 %% | maximum | lost by us |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    study(argv[1], argv[2], argv[3], solver == "exact" ? Solver::kExact : Solver::kGraph);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

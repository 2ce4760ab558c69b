#include <cstdio>
#include <string>

#include "bench_support.h"
#include "distance/exact_distance.h"
#include "distance/fast_distance.h"

/// The fast solver's distances against exact ones, from random sources (half of them vertices) to
/// all vertices, and to those within a part of the diagonal: relative errors.
///
///   fast_study MESH.obj [MESH.obj ...]
namespace karcher {
namespace {

constexpr uint64_t kSeed = 11;
constexpr int kSources = 20;
constexpr double kNear = 0.15;

struct Errors {
  double mean = 0;
  double percentile99 = 0;
  double maximum = 0;
};

Errors summary(const Array<double>& errors) {
  double sum = 0;
  for (const double e : errors) sum += e;
  return {sum / errors.count(), quantile(errors, 0.99), quantile(errors, 1)};
}

void study(const std::string& path) {
  const TriangleMesh mesh = loadBenchMesh(path, "").mesh;
  const Geometry geometry = buildGeometry(mesh);
  FastDistance fast(geometry);
  ExactDistance exact(geometry);
  Random random(kSeed);
  Array<double> whole;
  Array<double> near;
  for (int i = 0; i < kSources; ++i) {
    const SurfacePoint source = i % 2 == 0 ? randomPoint(mesh, random)
                                           : vertexPoint(mesh, random.index(mesh.vertexCount()));
    fast.setSource(source);
    fast.grow(kInfinity);
    exact.setSource(source);
    exact.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double truth = exact.distance(v);
      if (truth == kInfinity || truth < 1e-12 * geometry.diagonal) continue;
      const double error = std::abs(fast.distance(v) / truth - 1);
      whole.push_back(error);
      if (truth < kNear * geometry.diagonal) near.push_back(error);
    }
  }
  const Errors all = summary(whole);
  const Errors close = summary(near);
  std::printf("| %s | %d | %.2e | %.2f %% | %.2f %% | %.2e | %.2f %% | %.2f %% |\n",
              path.substr(path.rfind('/') + 1).c_str(), mesh.faceCount(), all.mean,
              100 * all.percentile99, 100 * all.maximum, close.mean, 100 * close.percentile99,
              100 * close.maximum);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: fast_study MESH.obj [MESH.obj ...]\n");
    return 1;
  }
  try {
    std::printf("%d sources a mesh, seed %d; near: within %.0f %% of the diagonal\n",
                karcher::kSources, static_cast<int>(karcher::kSeed), 100 * karcher::kNear);
    std::printf("| mesh | triangles | mean | 99 %% | max | near: mean | 99 %% | max |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (int i = 1; i < argc; ++i) karcher::study(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

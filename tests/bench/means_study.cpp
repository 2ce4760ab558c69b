#include <cstdio>
#include <string>

#include "bench_support.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"

/// How long a center of mass of many random points takes, cold, on meshes of files or on a torus of
/// so many triangles: a row for each number of points, the processor's milliseconds.
///
///   means_study [--points N]... [MESH.obj | TRIANGLES]...     (1000 and 5000 points by default)
namespace karcher {
namespace {

constexpr uint64_t kSeed = 100;

TriangleMesh meshOf(const std::string& word) {
  if (word.find(".obj") != std::string::npos) return loadBenchMesh(word, "").mesh;
  return importMesh(makeShape(Shape::kTorus, std::stoi(word))).mesh;
}

void print(const std::string& word, const Array<int>& counts) {
  Surface surface(meshOf(word));
  prepareFields(surface, {});
  for (const int count : counts) {
    Random random(kSeed);
    Array<SurfacePoint> points;
    Array<double> weights;
    for (int i = 0; i < count; ++i) {
      points.push_back(randomPoint(surface.mesh(), random));
      weights.push_back(1.0 / count);
    }
    Mean mean;
    const double time = processorTimed([&] { mean = centerOfMass(surface, points, weights, {}); });
    std::printf("| %s | %d | %d | %.0f | %d | %s |\n", word.substr(word.rfind('/') + 1).c_str(),
                surface.mesh().faceCount(), count, time, mean.iterations, statusName(mean.status));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::Array<int> counts;
    karcher::Array<std::string> meshes;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--points" && i + 1 < argc) {
        counts.push_back(std::stoi(argv[++i]));
      } else {
        meshes.push_back(word);
      }
    }
    if (counts.empty()) counts = {1000, 5000};
    if (meshes.empty()) meshes = {"100000"};
    std::printf(
        "| mesh | triangles | points | ms | solves | ended |\n| --- | --- | --- | --- | --- | --- "
        "|\n");
    for (const std::string& mesh : meshes) karcher::print(mesh, counts);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

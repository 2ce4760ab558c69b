#include <algorithm>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "mesh/mesh_import.h"
#include "mesh/positions.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"

/// The cost of a center of mass of random points, on meshes of files or on a torus of this many
/// triangles. Each row is for a number of points within a part of the diagonal. It has the
/// processor time in milliseconds (median and most, with the fields), the steps of a search
/// (median), and the share that converged.
///
///   means_study [--points N]... [--within PART]... [--solver exact] [--cases N] [--list]
///               [MESH.obj | TRIANGLES]...
///
/// By default one mean of 1000 and one of 5000 points all over the surface. --list prints each
/// case's status, energy and place to the error output: two versions find the same minima where
/// these agree.
namespace karcher {
namespace {

constexpr uint64_t kSeed = 100;

struct StudyOptions {
  Array<int> counts;
  Array<double> parts;
  MeanOptions mean;
  int cases = 1;
  bool isListed = false;
};

TriangleMesh meshOf(const std::string& word) {
  if (word.find(".obj") != std::string::npos) return loadBenchMesh(word, "").mesh;
  return importMesh(makeShape(Shape::kTorus, std::stoi(word))).mesh;
}

/// Random points within a distance of the first.
Array<SurfacePoint> pointsWithin(const TriangleMesh& mesh, double length, int count,
                                 Random& random) {
  Array<SurfacePoint> points{randomPoint(mesh, random)};
  const Vec3 middle = position(mesh, points[0]);
  constexpr int kMostTries = 10'000'000;
  for (int i = 0; i < kMostTries && points.count() < count; ++i) {
    const SurfacePoint point = randomPoint(mesh, random);
    if ((position(mesh, point) - middle).norm() <= length) points.push_back(point);
  }
  return points;
}

void print(const std::string& word, const StudyOptions& options) {
  Surface surface(meshOf(word));
  prepareFields(surface, options.mean.field);
  const std::string name = word.substr(word.rfind('/') + 1);
  for (const int count : options.counts) {
    for (const double part : options.parts) {
      Random random(kSeed);
      Array<double> times;
      Array<double> iterations;
      int converged = 0;
      for (int k = 0; k < options.cases; ++k) {
        const Array<SurfacePoint> points =
            pointsWithin(surface.mesh(), part * surface.geometry().diagonal, count, random);
        Array<double> weights;
        double sum = 0;
        for (int i = 0; i < points.count(); ++i) {
          weights.push_back(options.cases == 1 ? 1.0 : random.uniform(0.2, 1));
          sum += weights.back();
        }
        for (double& weight : weights) weight /= sum;
        Mean mean;
        times.push_back(
            processorTimed([&] { mean = centerOfMass(surface, points, weights, options.mean); }));
        iterations.push_back(mean.iterations);
        converged += mean.status == Status::kConverged ? 1 : 0;
        if (!options.isListed) continue;
        const Vec3 place = position(surface.mesh(), mean.point);
        std::fprintf(stderr, "%s %d %g %d %s %.9g %.9g %.9g %.9g\n", name.c_str(), count, part, k,
                     statusName(mean.status), mean.energy, place.x(), place.y(), place.z());
      }
      std::printf("| %s | %d | %d | %g | %.2f | %.2f | %.0f | %d %% |\n", name.c_str(),
                  surface.mesh().faceCount(), count, part, median(times), quantile(times, 1),
                  median(iterations), 100 * converged / options.cases);
      std::fflush(stdout);
    }
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::StudyOptions options;
    karcher::Array<std::string> meshes;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      const bool hasNext = i + 1 < argc;
      if (word == "--points" && hasNext) {
        options.counts.push_back(std::stoi(argv[++i]));
      } else if (word == "--within" && hasNext) {
        options.parts.push_back(std::stod(argv[++i]));
      } else if (word == "--cases" && hasNext) {
        options.cases = std::stoi(argv[++i]);
      } else if (word == "--solver" && hasNext && std::string(argv[i + 1]) == "exact") {
        options.mean.field.solver = karcher::Solver::kExact;
        ++i;
      } else if (word == "--list") {
        options.isListed = true;
      } else {
        meshes.push_back(word);
      }
    }
    if (options.counts.empty()) options.counts = {1000, 5000};
    if (options.parts.empty()) options.parts = {1};
    if (meshes.empty()) meshes = {"100000"};
    std::printf(
        "| mesh | triangles | points | within | ms | most | steps | converged |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const std::string& mesh : meshes) karcher::print(mesh, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "distance/edge_dijkstra.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/rough.h"
#include "mesh/shapes.h"
#include "mesh/triangle_mesh.h"
#include "rcm/field_options.h"
#include "rcm/surface.h"

/// Whole fields by the fast solver (field_options.h): the relative errors of distances to all
/// vertices, and the time for a vertex beside a Dijkstra along edges in the same run.
///
///   fields_study tubes [COUNT [SEED]]    ring tubes of random proportions
///   fields_study rough [TRIANGLES]       a rough torus of so many triangles, or of a million, from
///                                        one source
///   fields_study [MESH.obj ...]          meshes, or without any the gallery's
namespace karcher {
namespace {

constexpr uint64_t kSeed = 17;
constexpr int kSources = 4;
constexpr int kRoughSources = 1;
constexpr double kWrong = 0.01;

struct Row {
  double mean = 0;
  double longest = 0;   // the largest relative error of values that are too long
  double shortest = 0;  // the largest relative error of values that are too short
  double wrong = 0;     ///< the part of the vertices with errors above kWrong
  double time = 0;      // processor time, in multiples of Dijkstra's
};

struct Tally {
  Row row;
  int count = 0;

  void add(double value, double truth) {
    const double error = value / truth - 1;
    row.mean += std::abs(error);
    row.longest = std::max(row.longest, error);
    row.shortest = std::max(row.shortest, -error);
    row.wrong += std::abs(error) > kWrong ? 1 : 0;
    ++count;
  }
  Row result(double time) const {
    Row averaged = row;
    averaged.mean /= std::max(count, 1);
    averaged.wrong /= std::max(count, 1);
    averaged.time = time;
    return averaged;
  }
};

void print(const Row& row) {
  std::printf(" %.3f %% | +%.2f -%.2f %% | %.2f %% | %.1f |", 100 * row.mean, 100 * row.longest,
              100 * row.shortest, 100 * row.wrong, row.time);
}

/// Prints a row; returns the worst error.
double study(const std::string& name, TriangleMesh given, int sources = kSources) {
  Surface surface(std::move(given));
  const TriangleMesh& mesh = surface.mesh();
  const int count = mesh.vertexCount();
  Random random(kSeed);
  Tally asked;
  double edges = 0;
  double exactTime = 0;
  double askedTime = 0;
  WindowDistance exact(surface.geometry());
  WindowDistance tolerant(surface.geometry(), kFastTolerance);
  const auto once = [&](DistanceSolver& grown, const SurfacePoint& source) {
    return processorTimed([&] {
      grown.setSource(source);
      grown.grow(kInfinity);
    });
  };
  for (int i = 0; i < sources; ++i) {
    const int vertex = random.index(count);
    const SurfacePoint source = i % 2 == 0 ? vertexPoint(mesh, vertex) : randomPoint(mesh, random);
    edges += processorTimed([&] { edgeDijkstra(surface.geometry(), vertex); });
    exactTime += once(exact, source);
    askedTime += once(tolerant, source);
    for (int v = 0; v < count; ++v) {
      const double truth = exact.distance(v);
      if (truth == kInfinity || truth < 1e-12 * surface.geometry().diagonal) continue;
      asked.add(tolerant.distance(v), truth);
    }
  }
  const Row row = asked.result(askedTime / edges);
  std::printf("| %s | %d | %.0f | %.1f |", name.c_str(), mesh.faceCount(),
              1e6 * edges / (static_cast<double>(sources) * count), exactTime / edges);
  print(row);
  std::printf("\n");
  std::fflush(stdout);
  return std::max(row.longest, row.shortest);
}

double studyTubes(int count, uint64_t seed) {
  Random random(seed);
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const double radius = std::exp(random.uniform(std::log(0.004), std::log(0.6)));
    const int around = 4 + random.index(28);
    const int along = 20 + random.index(140);
    const TriangleSoup soup = ringTube(radius, around, along);
    char name[64];
    std::snprintf(name, sizeof name, "%.4f, %d x %d", radius, along, around);
    worst = std::max(worst, study(name, buildMesh(soup.positions, soup.triangles)));
  }
  return worst;
}

double studyRough(int triangles) {
  constexpr int kParts = 4;
  const TriangleSoup smooth = makeShape(Shape::kTorus, triangles / (kParts * kParts));
  const TriangleSoup soup = roughened(buildMesh(smooth.positions, smooth.triangles), kParts, kSeed);
  return study("rough torus", buildMesh(soup.positions, soup.triangles), kRoughSources);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    const Array<std::string> names(argv + 1, argv + argc);
    const bool isRough = !names.empty() && names[0] == "rough";
    const int sources = isRough ? kRoughSources : kSources;
    std::printf("%d source%s a mesh, seed %d. Wrong: off by more than %.0f %%.\n", sources,
                sources == 1 ? "" : "s", static_cast<int>(kSeed), 100 * kWrong);
    std::printf(
        "| mesh | triangles | edge Dijkstra, ns a vertex | exact, in these | fast: mean | too "
        "long, too short | wrong | time |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    double worst = 0;
    if (isRough) {
      worst = studyRough(names.count() > 1 ? std::stoi(names[1]) : 1'000'000);
    } else if (!names.empty() && names[0] == "tubes") {
      worst = studyTubes(names.count() > 1 ? std::stoi(names[1]) : 200,
                         names.count() > 2 ? std::stoull(names[2]) : kSeed);
    } else {
      forEachMesh(names, [&](const std::string& name, const TriangleMesh& mesh, bool) {
        worst = std::max(worst, study(name, mesh));
      });
    }
    std::printf("\nThe worst: %.2f %%.\n", 100 * worst);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

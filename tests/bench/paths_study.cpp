#include <algorithm>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "distance/find_path.h"
#include "distance/shortest_path.h"
#include "generators/rough.h"
#include "intrinsic/straighten.h"
#include "intrinsic/straightest.h"

/// Fast paths against the shortest ones by exact windows, for random pairs of points, .05 to .3 of
/// the diagonal apart. Also the cost of a crossing of an edge when a tight path is straightened
/// again, and when its end moves by a tenth of a mean edge. Times are the least of three.
///
///   paths_study [--pairs N] [--rough] MESH.obj ...
///
/// --rough splits each following mesh 1 to 16, with noise of a tenth of a mean edge.
namespace karcher {
namespace {

constexpr uint64_t kSeed = 42;
constexpr int kRepeats = 3;
constexpr int kMoves = 20;

struct Outcome {
  Array<double> excess;
  Array<double> times;       // milliseconds for each pair
  Array<double> legTimes;    // milliseconds of pairs .18 to .22 of the diagonal apart
  double crossings = 0;      // crossings of each path
  double straightening = 0;  // nanoseconds for each crossing
  double moving = 0;
};

template <class Work>
double leastTime(const Work& work) {
  double least = kInfinity;
  for (int i = 0; i < kRepeats; ++i) least = std::min(least, timed(work));
  return least;
}

Outcome measurePaths(const Geometry& geometry, int pairs) {
  Random random(kSeed);
  Outcome outcome;
  FindPathWorkspace workspace;
  SurfacePath path;
  double pieces = 0;
  double straightening = 0;
  double moving = 0;
  for (const PointPair& pair : randomPairs(geometry, random, pairs, randomPlace, 0.05, 0.3)) {
    const double exact = shortestPath(geometry, pair.from, pair.to).length();
    const double ms = leastTime([&] { findPath(geometry, pair.from, pair.to, workspace, path); });
    outcome.times.push_back(ms);
    if (std::abs(exact / geometry.diagonal - 0.2) < 0.02) outcome.legTimes.push_back(ms);
    outcome.excess.push_back(path.length() / exact - 1);
    pieces += path.points.count() - 1;
    straightening += leastTime([&] { straighten(geometry, path, workspace.strip); });
    const double heading = random.uniform(-kPi, kPi);
    for (int i = 0; i < kMoves; ++i) {
      const SurfacePoint end =
          traceStraightest(geometry, path.end(), 0.1 * geometry.meanEdge * unitVector(heading))
              .path.end();
      moving += timed([&] { moveEnd(geometry, end, path, workspace.strip); }) / kMoves;
    }
  }
  outcome.crossings = pieces / pairs;
  outcome.straightening = 1e6 * straightening / pieces;
  outcome.moving = 1e6 * moving / pieces;
  return outcome;
}

void study(const std::string& name, const TriangleMesh& mesh, int pairs) {
  const Geometry geometry = buildGeometry(mesh);
  const Outcome outcome = measurePaths(geometry, pairs);
  const auto within = std::count_if(outcome.excess.begin(), outcome.excess.end(),
                                    [](double excess) { return excess < 1e-3; });
  std::printf("| %s | %d | %d | %.1f %% | %.2f %% | %.2f | %.2f |", name.c_str(), mesh.faceCount(),
              pairs, 100.0 * static_cast<double>(within) / pairs, 100 * quantile(outcome.excess, 1),
              median(outcome.times), quantile(outcome.times, 1));
  if (outcome.legTimes.empty()) {
    std::printf(" - | - |");
  } else {
    std::printf(" %.2f | %.2f |", median(outcome.legTimes), quantile(outcome.legTimes, 1));
  }
  std::printf(" %.0f | %.0f | %.0f |\n", outcome.crossings, outcome.straightening, outcome.moving);
  std::fflush(stdout);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    std::printf(
        "| mesh | triangles | pairs | within 1e-3 of the shortest | worst excess | ms, median | "
        "maximum | ms of legs of .2, median | maximum | pieces a path | straightening, ns a piece "
        "| "
        "moving an end, ns a piece |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    int pairs = 100;
    bool rough = false;
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument == "--rough") {
        rough = true;
      } else if (argument == "--pairs" && i + 1 < argc) {
        pairs = std::stoi(argv[++i]);
      } else {
        const std::string name = argument.substr(argument.find_last_of('/') + 1);
        const TriangleMesh mesh = loadBenchMesh(argument, "").mesh;
        if (rough) {
          const TriangleSoup soup = roughened(mesh, 4, kSeed);
          study(name + ", rough", buildMesh(soup.positions, soup.triangles), pairs);
        } else {
          study(name, mesh, pairs);
        }
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

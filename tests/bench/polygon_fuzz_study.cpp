#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench_support.h"
#include "fuzz/polygon_fuzz.h"

/// Random control polygons over the meshes in turn, each as curves of all kinds: their faults, and
/// the share of marked intervals for each spacing of points.
///
///   polygon_fuzz_study [--count N] [--seed S] [--spacing K] [--levels 0]
///                      MESH.obj [MESH.obj ...]
///
/// Levels are 0 to 8 or auto. With --levels only the kinds that have levels run. Spacings take
/// turns unless --spacing gives the index of one in kSpacings. The seed of a fault, its spacing and
/// a count of 1 show the fault again.
namespace karcher {
namespace {

struct Arguments {
  int count = 100;
  uint64_t seed = 1;
  int spacing = -1;
  int levels = 0;
  Array<std::string> meshes;
};

Arguments parse(int argc, char** argv) {
  Arguments result;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--count" && i + 1 < argc) {
      result.count = std::atoi(argv[++i]);
    } else if (argument == "--seed" && i + 1 < argc) {
      result.seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (argument == "--spacing" && i + 1 < argc) {
      result.spacing = std::clamp(std::atoi(argv[++i]), 0, kSpacingCount - 1);
    } else if (argument == "--levels" && i + 1 < argc) {
      const std::string levels = argv[++i];
      result.levels = levels == "auto" ? kAutomaticLevels : std::atoi(levels.c_str());
    } else {
      result.meshes.push_back(argument);
    }
  }
  return result;
}

int study(const Arguments& arguments) {
  FuzzTally tally;
  const double start = milliseconds();
  const int meshes = arguments.meshes.count();
  for (int m = 0; m < meshes; ++m) {
    Surface surface(loadBenchMesh(arguments.meshes[m], "").mesh);
    const double began = milliseconds();
    double slowest = 0;
    int number = 0;
    for (int i = m; i < arguments.count; i += meshes, ++number) {
      const int spacing = arguments.spacing >= 0 ? arguments.spacing : number % kSpacingCount;
      const int known = tally.faults.count();
      const uint64_t seed = arguments.seed + static_cast<uint64_t>(i);
      const double took =
          timed([&] { fuzzPolygon(surface, spacing, seed, tally, arguments.levels); });
      slowest = std::max(slowest, took);
      // A run takes long, so it prints faults as it finds them.
      for (int k = known; k < tally.faults.count(); ++k) {
        std::printf("%s: %s\n", arguments.meshes[m].c_str(), tally.faults[k].c_str());
        std::fflush(stdout);
      }
    }
    std::printf("%s: %d polygons, %.1f s, slowest %.1f s, %d faults so far\n",
                arguments.meshes[m].c_str(), number, (milliseconds() - began) / 1e3, slowest / 1e3,
                tally.faults.count());
    std::fflush(stdout);
  }
  std::printf("\n| spacing / diagonal | polygons | curves | marked |\n| --- | --- | --- | --- |\n");
  for (int s = 0; s < kSpacingCount; ++s) {
    const FuzzTally::OfSpacing& of = tally.spacings[s];
    const std::string name = kSpacings[s] > 0 ? std::to_string(kSpacings[s]).substr(0, 4) : "any";
    std::printf("| %s | %d | %d | %.2f %% |\n", name.c_str(), of.polygons, of.curves,
                100 * of.marked / std::max(of.curves, 1));
  }
  std::printf("\nsteps outside marks: %d; searches lost between converged samples: %d\n",
              tally.steps, tally.lostBetween);
  std::printf(
      "largest jump without a mark: %.3g mean edges; join: %.2g, edit: %.2g of the diagonal\n",
      tally.largestJump, tally.largestJoin, tally.largestEdit);
  std::printf("%d faults in %.0f s\n", tally.faults.count(), (milliseconds() - start) / 1e3);
  return tally.faults.empty() ? 0 : 1;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const karcher::Arguments arguments = karcher::parse(argc, argv);
  if (arguments.meshes.empty()) {
    std::fprintf(stderr,
                 "usage: polygon_fuzz_study [--count N] [--seed S] [--spacing K] [--levels 0] "
                 "MESH.obj ...\n");
    return 1;
  }
  try {
    return karcher::study(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

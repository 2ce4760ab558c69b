#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "bench_support.h"
#include "fuzz/region_fuzz.h"

/// Random drawings on surfaces of genus 0 to 3 and with rims, in turn: the violations of the
/// invariants of their cells and regions.
///
///   region_fuzz_study [--count N] [--seed S]
///
/// The seed of a fault, the surface's place and a count of 1 show the fault again:
///
///   region_fuzz_study --seed S --count 1 --surface K
namespace karcher {
namespace {

int study(int count, uint64_t seed, int only) {
  const Array<std::unique_ptr<RegionSurface>> surfaces = regionSurfaces();
  RegionTally tally;
  const double start = milliseconds();
  for (int i = 0; i < count; ++i) {
    const int known = tally.faults.count();
    const int k = only >= 0 ? only % surfaces.count() : i % surfaces.count();
    fuzzRegions(*surfaces[k], seed + static_cast<uint64_t>(i), tally);
    for (int f = known; f < tally.faults.count(); ++f) {
      std::printf("surface %d, %s\n", k, tally.faults[f].c_str());
      std::fflush(stdout);
    }
  }
  std::printf("%d drawings of %d paths on %d surfaces, from seed %llu: %d cells, %d regions, ",
              tally.drawings, tally.paths, surfaces.count(), static_cast<unsigned long long>(seed),
              tally.cells, tally.regions);
  std::printf("%d sets of paths that bound no region, %d points\n", tally.unbounded, tally.points);
  std::printf("largest error of the areas' sum %.2g of the surface's, of Gauss-Bonnet %.2g\n",
              tally.largestAreaError, tally.largestBonnetError);
  std::printf("%d faults in %.0f s\n", tally.faults.count(), (milliseconds() - start) / 1e3);
  return tally.faults.empty() ? 0 : 1;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  int count = 10'000;
  uint64_t seed = 1;
  int surface = -1;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--count") == 0) count = std::atoi(argv[i + 1]);
    if (std::strcmp(argv[i], "--seed") == 0) seed = std::strtoull(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--surface") == 0) surface = std::atoi(argv[i + 1]);
  }
  return karcher::study(count, seed, surface);
}

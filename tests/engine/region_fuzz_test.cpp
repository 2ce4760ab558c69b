#include "fuzz/region_fuzz.h"

#include <gtest/gtest.h>

#include <string>

#include "support.h"

namespace karcher {
namespace {

TEST(RegionFuzz, CellsAndRegionsOfRandomDrawingsHold) {
  const Array<std::unique_ptr<RegionSurface>> surfaces = regionSurfaces();
  // `npm run study -- region_fuzz` draws 10,000.
  const int drawings = longRun() ? 3000 : 3 * surfaces.count();
  constexpr uint64_t kFirstSeed = 100'000;
  RegionTally tally;
  for (int i = 0; i < drawings; ++i) {
    fuzzRegions(*surfaces[i % surfaces.count()], kFirstSeed + static_cast<uint64_t>(i), tally);
  }
  std::printf("%d drawings from seed %d: %d cells, %d regions, %d sets of paths that bound none\n",
              tally.drawings, static_cast<int>(kFirstSeed), tally.cells, tally.regions,
              tally.unbounded);
  for (const std::string& fault : tally.faults) ADD_FAILURE() << fault;
  EXPECT_GT(tally.regions, 2 * tally.drawings);
  EXPECT_GT(tally.unbounded, tally.drawings / 4);
}

}  // namespace
}  // namespace karcher

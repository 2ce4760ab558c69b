#pragma once

#include <cstdint>

#include "generators/random.h"
#include "mesh/triangle_soup.h"

/// Small random meshes for tests of properties that hold on every surface.
namespace karcher {

/// The seed of case i. KARCHER_SEED in the environment selects other cases.
uint64_t seedOf(int first, int i);

/// A sheet of thin triangles, up to 10,000 times as long as wide.
TriangleSoup slivers(Random& random);

/// A lattice with saddles, a rim with holes, a wheel, slivers, spikes, a cone, or a rough sheet.
TriangleSoup randomSurface(Random& random);

/// The soup rotated, scaled and moved.
TriangleSoup carried(TriangleSoup soup, double scale, Random& random);

/// The number of a test's checks of random cases. It is printed at the end of the test, with the
/// sum of all tests in the process so far.
struct Checks {
  Checks() = default;
  Checks(const Checks&) = delete;
  Checks& operator=(const Checks&) = delete;
  ~Checks();
  int count = 0;
};

}  // namespace karcher

#include "random_surfaces.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "generators/gallery.h"
#include "generators/grid.h"

namespace karcher {
namespace {

TriangleSoup roughSheet(Random& random) {
  const int columns = 3 + random.index(6);
  const int rows = 3 + random.index(6);
  const double height = random.uniform(0, 1.5);
  const double shift = random.uniform(0, 0.3);
  TriangleSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double x = i + shift * random.uniform(-1, 1);
      const double y = j + shift * random.uniform(-1, 1);
      soup.positions.emplace_back(x, y, height * random.uniform());
    }
  }
  soup.triangles = gridTriangles(columns, rows, [&](int, int) { return random.index(2) == 0; });
  return soup;
}

/// A sheet with some vertices raised by up to 1,000 edges.
TriangleSoup spikes(Random& random) {
  TriangleSoup soup = roughSheet(random);
  const double height = std::pow(10, random.uniform(0, 3));
  for (Vec3& p : soup.positions) {
    if (random.index(6) == 0) p.z() += height * random.uniform();
  }
  return soup;
}

}  // namespace

uint64_t seedOf(int first, int i) {
  const char* other = std::getenv("KARCHER_SEED");
  const uint64_t drawn = other == nullptr ? 0 : std::strtoull(other, nullptr, 10);
  return 1'000'000 * drawn + static_cast<uint64_t>(first + i);
}

TriangleSoup slivers(Random& random) {
  TriangleSoup soup = roughSheet(random);
  const double thin = std::pow(10, random.uniform(-4, -1));
  for (Vec3& p : soup.positions) p = {p.x(), thin * p.y(), thin * p.z()};
  return soup;
}

TriangleSoup randomSurface(Random& random) {
  switch (random.index(7)) {
    case 0:
      return ringTube(random.uniform(0.2, 0.7), 4 + random.index(6), 6 + random.index(12));
    case 1:
      return plateWithHoles(3 + 2 * random.index(2), 3 + 2 * random.index(2));
    case 2:
      return wheel(5 + random.index(20), random.index(3), random.uniform(0, 2));
    case 3:
      return slivers(random);
    case 4:
      return spikes(random);
    case 5:  // a cone, from blunt to a needle, around which paths may wind
      return wheel(5 + random.index(400), 0, std::pow(10, random.uniform(-1, 4)));
    default:
      return roughSheet(random);
  }
}

TriangleSoup carried(TriangleSoup soup, double scale, Random& random) {
  const Vec2 turns[3] = {unitVector(random.uniform(0, 7)), unitVector(random.uniform(0, 7)),
                         unitVector(random.uniform(0, 7))};
  const Vec3 shift(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
  for (Vec3& p : soup.positions) {
    for (int k = 0; k < 3; ++k) {
      const Vec2 q = rotate(turns[k], Vec2(p[k], p[(k + 1) % 3]));
      p[k] = q.x();
      p[(k + 1) % 3] = q.y();
    }
    p = scale * (p + shift);
  }
  return soup;
}

Checks::~Checks() {
  static int sum = 0;
  sum += count;
  std::printf("%d random checks, %d with the tests before\n", count, sum);
}

}  // namespace karcher

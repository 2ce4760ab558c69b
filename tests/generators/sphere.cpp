#include "generators/sphere.h"

#include <algorithm>

#include "generators/delaunay.h"
#include "generators/random.h"
#include "generators/relax.h"

namespace karcher {

TriangleSoup randomSphere(int triangles, uint64_t seed) {
  Random random(seed);
  TriangleSoup soup;
  for (int i = 0; i < triangles / 2 + 2; ++i) {
    const double z = random.uniform(-1, 1);
    const Vec2 u = std::sqrt(1 - z * z) * unitVector(random.uniform(0, 2 * kPi));
    soup.positions.emplace_back(u.x(), u.y(), z);
  }
  soup.triangles = sphereHull(soup.positions);
  return soup;
}

TriangleSoup relaxedSphere(int triangles, uint64_t seed) {
  TriangleSoup soup = randomSphere(triangles, seed);
  constexpr int kSteps = 8;
  for (int step = 0; step < kSteps; ++step) {
    soup.positions = meanCentroids(soup);
    for (Vec3& p : soup.positions) p = closestOnSphere(p);
    soup.triangles = sphereHull(soup.positions);
  }
  return soup;
}

TriangleSoup jitteredUvSphere(int triangles, uint64_t seed) {
  Random random(seed);
  const int rows = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 4.0))));
  const int columns = 2 * rows;
  TriangleSoup soup;
  soup.positions.emplace_back(0, 0, 1);
  for (int j = 1; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double latitude = kPi * (j + random.uniform(-0.2, 0.2)) / rows;
      const Vec2 u =
          std::sin(latitude) * unitVector(2 * kPi * (i + random.uniform(-0.2, 0.2)) / columns);
      soup.positions.emplace_back(u.x(), u.y(), std::cos(latitude));
    }
  }
  soup.positions.emplace_back(0, 0, -1);
  const int south = soup.positions.count() - 1;
  const auto vertex = [&](int i, int j) { return 1 + (j - 1) * columns + i % columns; };
  for (int i = 0; i < columns; ++i) {
    soup.triangles.emplace_back(0, vertex(i, 1), vertex(i + 1, 1));
    for (int j = 1; j + 1 < rows; ++j) {
      const int a = vertex(i, j);
      const int b = vertex(i, j + 1);
      const int c = vertex(i + 1, j + 1);
      const int d = vertex(i + 1, j);
      if (random.uniform() < 0.5) {
        soup.triangles.emplace_back(a, b, c);
        soup.triangles.emplace_back(a, c, d);
      } else {
        soup.triangles.emplace_back(a, b, d);
        soup.triangles.emplace_back(b, c, d);
      }
    }
    soup.triangles.emplace_back(south, vertex(i + 1, rows - 1), vertex(i, rows - 1));
  }
  return soup;
}

}  // namespace karcher

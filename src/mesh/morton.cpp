#include "mesh/morton.h"

#include <algorithm>
#include <utility>

namespace karcher {
namespace {

/// Moves bit i of a 21-bit number to bit 3 i.
uint64_t spread(uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffffULL;
  x = (x | x << 16) & 0x001f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  x = (x | x << 2) & 0x1249249249249249ULL;
  return x;
}

struct Entry {
  uint64_t code;
  int vertex;
};

}  // namespace

Array<int> mortonOrder(const Array<Vec3>& positions, Array<int> vertices) {
  if (vertices.empty()) return vertices;
  Vec3 low = positions[vertices[0]];
  Vec3 high = low;
  for (const int v : vertices) {
    low = low.cwiseMin(positions[v]);
    high = high.cwiseMax(positions[v]);
  }
  // The difference of two finite numbers may overflow, so this subtracts halves.
  const double halfWidth = (high / 2 - low / 2).maxCoeff();
  constexpr double kCells = (1 << 21) - 1;  // the greatest number of 21 bits
  const double scale = halfWidth > 0 ? kCells / halfWidth : 0;
  Array<Entry> entries;
  entries.reserve(vertices.size());
  for (const int v : vertices) {
    uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
      const double cell = std::clamp((positions[v][k] / 2 - low[k] / 2) * scale, 0.0, kCells);
      code |= spread(static_cast<uint64_t>(cell)) << k;
    }
    entries.push_back({code, v});
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.code != b.code) return a.code < b.code;
    const Vec3& p = positions[a.vertex];
    const Vec3& q = positions[b.vertex];
    for (int k = 0; k < 3; ++k) {
      if (p[k] != q[k]) return p[k] < q[k];
    }
    return a.vertex < b.vertex;
  });
  for (int i = 0; i < vertices.count(); ++i) vertices[i] = entries[i].vertex;
  return vertices;
}

}  // namespace karcher

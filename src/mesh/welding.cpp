#include "mesh/welding.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mesh/edges.h"

namespace karcher {
namespace {

Array<int> identity(int count) {
  Array<int> result(static_cast<size_t>(count));
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/// Per vertex the first in `order` at its position.
Array<int> firstAtPosition(const TriangleSoup& soup, const Array<int>& order) {
  Array<int> first = identity(soup.positions.count());
  for (int i = 1; i < order.count(); ++i) {
    if (soup.positions[order[i]] == soup.positions[order[i - 1]]) {
      first[order[i]] = first[order[i - 1]];
    }
  }
  return first;
}

Array<Triangle> renumbered(const Array<Triangle>& triangles, const Array<int>& number) {
  Array<Triangle> result;
  result.reserve(triangles.size());
  for (const Triangle& t : triangles) result.emplace_back(number[t[0]], number[t[1]], number[t[2]]);
  return result;
}

/// Sets of vertices, each named by its smallest.
class Sets {
 public:
  explicit Sets(int count) : parent_(identity(count)) {}

  int find(int v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  Array<int> parent_;
};

bool allEdgesManifold(const Array<Triangle>& faces, int vertexCount) {
  bool all = true;
  forEachEdge(faces, vertexCount, [&](int, std::span<const EdgeSide> sides) {
    all = all && isManifoldEdge(faces, sides);
  });
  return all;
}

}  // namespace

Welding findWelding(const TriangleSoup& soup, const Array<int>& order) {
  const int count = soup.positions.count();
  const Array<int> first = firstAtPosition(soup, order);
  Welding welding{identity(count)};
  for (const int v : order) welding.keptApart += first[v] != v;
  if (welding.keptApart == 0) return welding;

  Sets sets(count);
  const Array<Triangle> byPosition = renumbered(soup.triangles, first);
  forEachEdge(byPosition, count, [&](int, std::span<const EdgeSide> sides) {
    if (sides.size() != 2 || !isManifoldEdge(byPosition, sides)) return;
    const int g = sides[0].halfedge;
    const int h = sides[1].halfedge;
    const auto corner = [&](int f, int k) { return soup.triangles[f][k % 3]; };
    sets.unite(corner(g / 3, g % 3), corner(h / 3, h % 3 + 1));
    sets.unite(corner(g / 3, g % 3 + 1), corner(h / 3, h % 3));
  });
  Array<int> target(static_cast<size_t>(count));
  for (int v = 0; v < count; ++v) target[v] = sets.find(v);
  // Seams on all sides of an edge where three faces meet would close it, too: then weld nothing.
  if (!allEdgesManifold(renumbered(soup.triangles, target), count)) return welding;
  welding.target = std::move(target);
  for (const int v : order) welding.welded += welding.target[v] != v;
  welding.keptApart -= welding.welded;
  return welding;
}

}  // namespace karcher

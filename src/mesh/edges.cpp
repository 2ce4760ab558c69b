#include "mesh/edges.h"

#include <algorithm>
#include <numeric>

namespace karcher {

SortedSides sortSides(const Array<Triangle>& faces, int vertexCount) {
  const auto forEachHalfedge = [&](auto&& use) {
    for (int f = 0; f < faces.count(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int a = faces[f][k];
        const int b = faces[f][k == 2 ? 0 : k + 1];
        use(std::min(a, b), EdgeSide{std::max(a, b), 3 * f + k});
      }
    }
  };
  SortedSides sorted;
  Array<int>& start = sorted.start;
  // The count of vertex v goes to start[v + 2]. So start[v + 1] is at first the beginning of the
  // list of v, and moves to the end while the list fills.
  start.assign(static_cast<size_t>(vertexCount) + 2, 0);
  forEachHalfedge([&](int v, const EdgeSide&) { ++start[v + 2]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  sorted.sides.resize(3 * faces.size());
  forEachHalfedge([&](int v, const EdgeSide& side) { sorted.sides[start[v + 1]++] = side; });
  for (int v = 0; v < vertexCount; ++v) {
    std::sort(sorted.sides.begin() + start[v], sorted.sides.begin() + start[v + 1],
              [](const EdgeSide& a, const EdgeSide& b) {
                return a.otherVertex != b.otherVertex ? a.otherVertex < b.otherVertex
                                                      : a.halfedge < b.halfedge;
              });
  }
  return sorted;
}

}  // namespace karcher

#pragma once

#include <algorithm>
#include <numeric>
#include <span>

#include "mesh/types.h"

namespace karcher {

/// A half-edge 3 f + k among those of one edge.
struct EdgeSide {
  int otherVertex;  ///< the greater of the edge's two vertices
  int halfedge;
};

/// Groups the half-edges of `faces` by their undirected edge and calls
/// visit(int smallerVertex, std::span<const EdgeSide> sides) once an edge, in the order of its
/// vertices, the sides in the order of their half-edges. Corners must be in [0, vertexCount).
template <class Visit>
void forEachEdge(const Array<Triangle>& faces, int vertexCount, Visit&& visit) {
  const auto forEachHalfedge = [&](auto&& use) {
    for (int f = 0; f < faces.count(); ++f) {
      for (int k = 0; k < 3; ++k) {
        const int a = faces[f][k];
        const int b = faces[f][k == 2 ? 0 : k + 1];
        use(std::min(a, b), EdgeSide{std::max(a, b), 3 * f + k});
      }
    }
  };
  Array<int> start(static_cast<size_t>(vertexCount) + 1, 0);
  forEachHalfedge([&](int v, const EdgeSide&) { ++start[v + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  Array<EdgeSide> sides(3 * faces.size());
  // Filling moves start[v] to the end of v's part.
  forEachHalfedge([&](int v, const EdgeSide& side) { sides[start[v]++] = side; });
  for (int v = 0; v < vertexCount; ++v) {
    EdgeSide* first = sides.data() + (v == 0 ? 0 : start[v - 1]);
    EdgeSide* const end = sides.data() + start[v];
    std::sort(first, end, [](const EdgeSide& a, const EdgeSide& b) {
      return a.otherVertex != b.otherVertex ? a.otherVertex < b.otherVertex
                                            : a.halfedge < b.halfedge;
    });
    while (first < end) {
      EdgeSide* last = first + 1;
      while (last < end && last->otherVertex == first->otherVertex) ++last;
      visit(v, std::span<const EdgeSide>(first, last));
      first = last;
    }
  }
}

/// True for one half-edge alone, and for two that run in opposite directions. `faces` are those
/// whose edges were visited.
inline bool isManifoldEdge(const Array<Triangle>& faces, std::span<const EdgeSide> sides) {
  const auto tail = [&](const EdgeSide& side) {
    return faces[side.halfedge / 3][side.halfedge % 3];
  };
  return sides.size() == 1 || (sides.size() == 2 && tail(sides[0]) != tail(sides[1]));
}

}  // namespace karcher

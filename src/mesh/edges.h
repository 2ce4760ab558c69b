#pragma once

#include <span>

#include "mesh/types.h"

namespace karcher {

/// A half-edge 3 f + k of an edge, in the list of the edge's smaller vertex.
struct EdgeSide {
  int otherVertex;  ///< the larger of the edge's two vertices
  int halfedge;
};

/// The half-edges of faces, grouped by the smaller vertex of their edge. The group of vertex v
/// begins at sides[start[v]] and ends before sides[start[v + 1]]. Each group is sorted by the other
/// vertex and then by half-edge.
struct SortedSides {
  Array<int> start;
  Array<EdgeSide> sides;
};

/// Corners must be in [0, vertexCount).
SortedSides sortSides(const Array<Triangle>& faces, int vertexCount);

/// Groups the half-edges of `faces` by their undirected edge and calls visit(int smallerVertex,
/// std::span<const EdgeSide> sides) once for each edge. Edges are in the order of their vertices,
/// and sides in the order of their half-edges. Corners must be in [0, vertexCount).
template <class Visit>
void forEachEdge(const Array<Triangle>& faces, int vertexCount, Visit&& visit) {
  const SortedSides sorted = sortSides(faces, vertexCount);
  for (int v = 0; v < vertexCount; ++v) {
    const EdgeSide* first = sorted.sides.data() + sorted.start[v];
    const EdgeSide* const end = sorted.sides.data() + sorted.start[v + 1];
    while (first < end) {
      const EdgeSide* last = first + 1;
      while (last < end && last->otherVertex == first->otherVertex) ++last;
      visit(v, std::span<const EdgeSide>(first, last));
      first = last;
    }
  }
}

/// Whether the edge has one half-edge, or two that run in opposite directions. `faces` must be the
/// faces given to `forEachEdge`.
inline bool isManifoldEdge(const Array<Triangle>& faces, std::span<const EdgeSide> sides) {
  const auto tail = [&](const EdgeSide& side) {
    return faces[side.halfedge / 3][side.halfedge % 3];
  };
  return sides.size() == 1 || (sides.size() == 2 && tail(sides[0]) != tail(sides[1]));
}

}  // namespace karcher

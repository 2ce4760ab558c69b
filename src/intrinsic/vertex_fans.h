#pragma once

#include "intrinsic/geometry.h"

/// The triangles around each vertex laid flat, in one array. A solver that goes from vertex to
/// vertex reads all it needs here, and computes no sine or square root of the mesh.
///
/// A vertex's fan lists its edges counterclockwise from its `outgoing` half-edge; edge i and the
/// next one bound a corner, which has the number i. At an interior vertex the last edge and the
/// first bound the last corner; at the boundary the last edge has no corner.
namespace karcher {

struct FanEdge {
  /// The edge as a vector from the vertex, at its unscaled direction (geometry.h): triangles of the
  /// fan lie flat side by side, with a gap or an overlap after the last where the surface is not.
  Vec2 vector = Vec2::Zero();
  double length = 0;
  /// Of the edges of the corner that begins here: the cross product, twice the triangle's area, and
  /// the dot product. Both are 0 without a corner.
  double cross = 0;
  double dot = 0;
  int head = -1;     ///< the vertex at the other end
  int reverse = -1;  ///< number of the same edge in the fan of `head`
};

struct VertexFans {
  static constexpr uint8_t kBoundary = 1;
  /// The total angle exceeds 2 pi by more than a corner: the cosine and the sine of an unscaled
  /// direction do not tell on which turn it lies, not even near an edge.
  static constexpr uint8_t kWide = 2;

  Array<int> begin;      ///< per vertex its first edge; one entry more at the end
  Array<FanEdge> edges;  ///< fans one after another
  Array<double> angles;  ///< per edge its unscaled direction (geometry.h)
  Array<Vec2> turn;      ///< per vertex, unit: the rotation by the total angle
  Array<uint8_t> flags;  ///< per vertex kBoundary, kWide
  /// Per vertex how far beyond its distance a front must go, from the nearest vertices outwards,
  /// before the distance is final: the last vertex that its shortest path depends on may be so
  /// late.
  Array<float> delay;

  int end(int vertex) const { return begin[vertex + 1]; }
  bool onBoundary(int vertex) const { return (flags[vertex] & kBoundary) != 0; }

  /// The fan edges beside `edge`, counterclockwise and clockwise, around an interior vertex.
  int after(int vertex, int edge) const {
    return edge + 1 == end(vertex) ? begin[vertex] : edge + 1;
  }
  int before(int vertex, int edge) const {
    return edge == begin[vertex] ? end(vertex) - 1 : edge - 1;
  }
};

VertexFans buildVertexFans(const Geometry& geometry);

/// The number of the edge from `vertex` to `head`, which must be neighbours.
int fanEdge(const VertexFans& fans, int vertex, int head);

}  // namespace karcher

#pragma once

#include <span>

#include "intrinsic/surface_path.h"
#include "regions/grid.h"

/// A drawing: paths on the surface, cut at all points where they meet. Points and crossings become
/// vertices. Vertices nearer than kTogether merge: a vertex or an edge of the mesh takes the points
/// near it, and a line that passes near a vertex bends through it. This is snap rounding (J. Hobby,
/// 1999), repeated until no two vertices, and no vertex and line, are near each other (D. Halperin,
/// E. Packer, "Iterated Snap Rounding", 2002). Both faces of an edge share the vertices on it, so
/// that these never differ.
namespace karcher {

/// A vertex that the paths add to those of the mesh.
struct DrawnVertex {
  int face = 0;
  int halfedge = -1;  ///< the edge's half-edge (`drawnHalfedge`); -1 for a vertex inside the face
  double t = 0;       ///< the place along this half-edge
  Vec2 place = Vec2::Zero();
};

/// A straight piece of a path between two vertices, without other vertices on it. Vertices are
/// numbered consecutively: first those of the mesh, then those of the drawing.
struct DrawnPiece {
  int from = 0;
  int to = 0;
  int path = 0;
  /// A number that grows along the path: the index of the path's point before the piece, plus a
  /// fraction if the piece does not start at that point.
  double order = 0;
  double span = 1;  ///< the difference to the next piece's `order`
};

/// An edge's vertices in order along its `drawnHalfedge`, and the pieces on the edge.
struct DrawnEdge {
  int halfedge = 0;
  Array<int> vertices;
  Array<DrawnPiece> pieces;
};

/// The vertices and pieces inside a face.
struct DrawnFace {
  int face = 0;
  Array<int> vertices;
  Array<DrawnPiece> pieces;
};

struct Drawing {
  int meshVertices = 0;
  int paths = 0;
  Array<DrawnVertex> added;
  Array<DrawnEdge> edges;
  Array<DrawnFace> faces;
  /// for each `drawnHalfedge`, the index of its edge in `edges`; -1 for an edge without vertices or
  /// pieces
  Array<int> edgeOf;
  Array<int> faceOf;  ///< the index of each face in `faces`; -1 if it has no vertices or pieces
};

/// The half-edge that represents an edge in the drawing.
inline int drawnHalfedge(const TriangleMesh& mesh, int h) {
  return mesh.twin[h] >= 0 ? std::min(h, mesh.twin[h]) : h;
}

/// The position of a vertex in the coordinates of a face, if the vertex is inside the face or on
/// its sides.
Vec2 placeIn(const TriangleMesh& mesh, const Array<DrawnVertex>& added, int face, int vertex);

/// Throws Error kBadArgument if consecutive points of a path have no face in common.
Drawing drawPaths(const TriangleMesh& mesh, std::span<const SurfacePath> paths);

}  // namespace karcher

#pragma once

#include "intrinsic/geometry.h"
#include "regions/drawing.h"

/// The surface divided by paths into cells, as a half-edge structure. The drawing's lines divide
/// each face into pieces; a piece with isolated lines inside has several loops. The drawing's
/// vertices divide the edges of the mesh. Both faces at an edge share the vertices on it, so that
/// their pieces always fit. A cell is a maximal connected set of pieces that no path separates.
namespace karcher {

/// The use of an edge of the arrangement by a path.
struct PathUse {
  int halfedge = 0;  ///< the smaller of the edge's two half-edges
  int path = 0;
  double order = 0;  ///< a number that grows along the path (`DrawnPiece::order`)
  int sign = 1;      ///< 1 if the path runs along the half-edge, -1 if against it
};

struct Arrangement {
  int meshVertices = 0;
  int paths = 0;
  /// The vertices that paths add to the mesh's. Vertices are numbered consecutively: first those of
  /// the mesh, then these.
  Array<DrawnVertex> added;

  // Arrays by half-edge. The half-edges of face f are [firstOfFace[f], firstOfFace[f + 1]). Those
  // on the face's sides come first, counterclockwise from corner 0. Each piece lies left of its
  // half-edges.
  Array<int> firstOfFace;
  Array<int> tail;
  Array<int> next;
  Array<int> twin;  ///< the opposite half-edge, or -1 at the boundary of the surface
  Array<int> piece;

  // Arrays by piece. The pieces of a face are consecutive.
  Array<int> faceOfPiece;
  Array<double> pieceArea;
  Array<int> cellOfPiece;

  Array<double> cellArea;
  /// The uses of edges by paths, sorted by half-edge.
  Array<PathUse> uses;

  int halfedgeCount() const { return tail.count(); }
  int pieceCount() const { return faceOfPiece.count(); }
  int cellCount() const { return cellArea.count(); }
  int head(int h) const { return tail[next[h]]; }
  int face(int h) const { return faceOfPiece[piece[h]]; }
  int cell(int h) const { return cellOfPiece[piece[h]]; }
};

/// Throws Error kBadArgument if consecutive points of a path have no face in common.
Arrangement arrange(const Geometry& geometry, std::span<const SurfacePath> paths);

/// A vertex as a point of a face that contains it.
SurfacePoint vertexInFace(const TriangleMesh& mesh, const Arrangement& arrangement, int face,
                          int vertex);

/// A difference of places in a face as a vector in the face's frame.
inline Vec2 inFrame(const Geometry& geometry, int face, const Vec2& way) {
  const Vec2& apex = geometry.apex[face];
  return {way.x() * geometry.edgeLength[3 * face] + way.y() * apex.x(), way.y() * apex.y()};
}

/// The length of a half-edge.
double lengthOf(const Geometry& geometry, const Arrangement& arrangement, int h);

/// For each cell, a point inside it and away from its border, in the cell's largest piece.
Array<SurfacePoint> pointsInside(const Geometry& geometry, const Arrangement& arrangement);

/// The piece that contains a point. If the point lies on a line, it is the piece on either side.
int pieceHolding(const TriangleMesh& mesh, const Arrangement& arrangement,
                 const SurfacePoint& point);

}  // namespace karcher

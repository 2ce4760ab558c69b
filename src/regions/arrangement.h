#pragma once

#include "intrinsic/geometry.h"
#include "regions/drawing.h"

/// The surface cut by paths into cells, as half-edges.
///
/// Each face is cut by the drawing's lines into pieces; a piece that has lines in it, which touch
/// nothing, has several loops. Over an edge of the mesh pieces are joined by the drawing's vertices
/// on it, which both faces share, so whatever the paths do, the pieces fit. A cell is what can be
/// reached without crossing a path.
namespace karcher {

/// What a path does on an edge of the arrangement.
struct PathUse {
  int halfedge = 0;  ///< of the edge's two the smaller one
  int path = 0;
  int part = 0;
  int sign = 1;  ///< -1 where the path runs against the half-edge
};

struct Arrangement {
  int meshVertices = 0;
  int paths = 0;
  /// Vertices are numbered through the mesh's and then these.
  Array<DrawnVertex> added;

  // Per half-edge: those of face f are firstOfFace[f] to firstOfFace[f + 1], first those on its
  // sides, counterclockwise from corner 0. The piece lies left of it.
  Array<int> firstOfFace;
  Array<int> tail;
  Array<int> next;
  Array<int> twin;  ///< -1 at the boundary of the surface
  Array<int> piece;

  // Per piece; those of a face follow each other.
  Array<int> faceOfPiece;
  Array<double> pieceArea;
  Array<int> cellOfPiece;

  Array<double> cellArea;
  /// By half-edge.
  Array<PathUse> uses;

  int halfedgeCount() const { return tail.count(); }
  int pieceCount() const { return faceOfPiece.count(); }
  int cellCount() const { return cellArea.count(); }
  int head(int h) const { return tail[next[h]]; }
  int face(int h) const { return faceOfPiece[piece[h]]; }
  int cell(int h) const { return cellOfPiece[piece[h]]; }
};

/// Throws Error kBadArgument where consecutive points of a path have no face in common.
Arrangement arrange(const Geometry& geometry, std::span<const SurfacePath> paths);

/// A vertex in a face that holds it.
SurfacePoint vertexInFace(const TriangleMesh& mesh, const Arrangement& arrangement, int face,
                          int vertex);

/// A difference of places in a face as a vector in the face's frame.
inline Vec2 inFrame(const Geometry& geometry, int face, const Vec2& way) {
  const Vec2& apex = geometry.apex[face];
  return {way.x() * geometry.edgeLength[3 * face] + way.y() * apex.x(), way.y() * apex.y()};
}

/// The length of a half-edge.
double lengthOf(const Geometry& geometry, const Arrangement& arrangement, int h);

/// The piece that holds a point. On a line it is the piece of one side.
int pieceHolding(const TriangleMesh& mesh, const Arrangement& arrangement,
                 const SurfacePoint& point);

}  // namespace karcher

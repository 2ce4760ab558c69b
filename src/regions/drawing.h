#pragma once

#include <span>

#include "intrinsic/surface_path.h"
#include "regions/grid.h"

/// Paths on the surface, cut at all points where they meet.
///
/// Points and crossings become vertices. What lies nearer than kTogether is one: a vertex of the
/// mesh takes what is near it, an edge what is near it, and a line that passes a vertex is bent
/// through it. This is snap rounding (J. Hobby, 1999), repeated until no two vertices, and no
/// vertex and line, are near each other (D. Halperin, E. Packer, "Iterated Snap Rounding", 2002).
/// Vertices on an edge are kept once for both of its faces, so these never differ.
namespace karcher {

/// A vertex that the paths add to those of the mesh.
struct DrawnVertex {
  int face = 0;
  int halfedge = -1;  ///< of an edge's two the one that the drawing knows; -1 inside the face
  double t = 0;       ///< along this half-edge
  Vec2 place = Vec2::Zero();
};

/// A straight piece of a path between two vertices, with nothing on it. Vertices are numbered
/// through the mesh's and then the drawing's.
struct DrawnPiece {
  int from = 0;
  int to = 0;
  int path = 0;
  int part = 0;  ///< of the path, from its point of this number to the next
};

/// An edge's vertices in the order along the drawing's half-edge, and what runs on it.
struct DrawnEdge {
  int halfedge = 0;
  Array<int> vertices;
  Array<DrawnPiece> pieces;
};

/// What lies inside a face.
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
  Array<int> edgeOf;  ///< per half-edge, of the smaller of an edge's two; -1 where nothing is
  Array<int> faceOf;  ///< per face; -1 where nothing is
};

/// Of an edge's half-edges the one that the drawing knows.
inline int drawnHalfedge(const TriangleMesh& mesh, int h) {
  return mesh.twin[h] >= 0 ? std::min(h, mesh.twin[h]) : h;
}

/// Where a vertex of a face, or on one of its sides, lies in it.
Vec2 placeIn(const TriangleMesh& mesh, const Array<DrawnVertex>& added, int face, int vertex);

/// Throws Error kBadArgument where consecutive points of a path have no face in common.
Drawing drawPaths(const TriangleMesh& mesh, std::span<const SurfacePath> paths);

}  // namespace karcher

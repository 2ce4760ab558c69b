#pragma once

#include "regions/arrangement.h"

/// The surface divided along paths into triangles. In each face, flips of edges triangulate the
/// vertices and lines together (S. Sloan, "A fast algorithm for generating constrained Delaunay
/// triangulations", 1993). Its decisions are exact, so that the triangles fit even in thin pieces.
namespace karcher {

/// The triangles of a divided surface. Cells have no vertices in common. Along a path that ends
/// inside a cell, each side has its own vertices. Vertices on both sides of a path have equal
/// positions, to the last bit.
struct CutSurface {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;  ///< the face of the mesh that contains each triangle
  Array<int> cellOf;  ///< the cell of each triangle
};

CutSurface cutApart(const Geometry& geometry, const Arrangement& arrangement);

/// A cell as a separate mesh.
struct CutPart {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;
};

/// The parts, one for each cell, in the order of the cells.
Array<CutPart> partsOf(const CutSurface& surface, int cellCount);

}  // namespace karcher

#pragma once

#include "regions/arrangement.h"

/// Cutting of the surface along paths into triangles.
///
/// The vertices and lines of a face are triangulated together, by flips (S. Sloan, "A fast
/// algorithm for generating constrained Delaunay triangulations", 1993) with exact decisions, so
/// that thin pieces fit as well as others.
namespace karcher {

/// Cells have no vertices in common, and along a path that ends inside a cell each side has its
/// own. Vertices on both sides of a path have equal positions, to the last bit.
struct CutSurface {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;  ///< the face that each triangle is a part of
  Array<int> cellOf;  ///< per triangle
};

CutSurface cutApart(const Geometry& geometry, const Arrangement& arrangement);

/// A cell as triangles of its own.
struct CutPart {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;
};

/// One part for each cell, in their order.
Array<CutPart> partsOf(const CutSurface& surface, int cellCount);

}  // namespace karcher

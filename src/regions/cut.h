#pragma once

#include "regions/arrangement.h"

/// The surface cut apart along paths, as triangles.
///
/// The vertices and lines of a face are triangulated together, by flips (S. Sloan, "A fast
/// algorithm for generating constrained Delaunay triangulations", 1993) whose every decision is
/// exact, so that thin pieces fit as well as others.
namespace karcher {

/// Cells have no vertex in common, and along a path that ends inside a cell both sides have their
/// own. What lies on both sides of a path has equal positions, to the last bit.
struct CutSurface {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;  ///< per triangle the face that it is a part of
  Array<int> cellOf;  ///< per triangle
};

CutSurface cutApart(const Geometry& geometry, const Arrangement& arrangement);

/// A cell as triangles of its own.
struct CutPart {
  Array<Vec3> positions;
  Array<Triangle> triangles;
  Array<int> faceOf;
};

/// One part a cell, in their order.
Array<CutPart> partsOf(const CutSurface& surface, int cellCount);

}  // namespace karcher

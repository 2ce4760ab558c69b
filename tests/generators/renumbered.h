#pragma once

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

namespace karcher {

/// A mesh with vertices and faces in another order, and each face starting at another corner.
struct Renumbered {
  TriangleMesh mesh;
  Array<int> newFace;    // by the face's old index
  Array<int> oldFace;    // by its new index
  Array<int> rotations;  // by its new index: the corner that comes first

  /// Converts a point of the old mesh to this one.
  SurfacePoint at(const SurfacePoint& point) const;
  /// Converts a point of this mesh to the old one.
  SurfacePoint before(const SurfacePoint& point) const;
};

Renumbered renumbered(const TriangleMesh& mesh, uint64_t seed);

}  // namespace karcher

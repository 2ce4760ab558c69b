#pragma once

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

namespace karcher {

/// A mesh with its vertices and faces in another order, and another first corner in each face.
struct Renumbered {
  TriangleMesh mesh;
  Array<int> newFace;    // the new index for each old one
  Array<int> oldFace;    // the old index for each new one
  Array<int> rotations;  // the corner that comes first, for each new index

  /// Converts a point of the old mesh to this one.
  SurfacePoint at(const SurfacePoint& point) const;
  /// Converts a point of this mesh to the old one.
  SurfacePoint before(const SurfacePoint& point) const;
};

Renumbered renumbered(const TriangleMesh& mesh, uint64_t seed);

}  // namespace karcher

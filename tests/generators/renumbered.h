#pragma once

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

namespace karcher {

/// A mesh with vertices and faces in another order, and each face from another corner.
struct Renumbered {
  TriangleMesh mesh;
  Array<int> newFace;    ///< by the face's number before
  Array<int> oldFace;    ///< by its new one
  Array<int> rotations;  ///< by its new number: which corner comes first

  /// Where a point of the mesh before lies.
  SurfacePoint at(const SurfacePoint& point) const;
  /// The same the other way round.
  SurfacePoint before(const SurfacePoint& point) const;
};

Renumbered renumbered(const TriangleMesh& mesh, uint64_t seed);

}  // namespace karcher

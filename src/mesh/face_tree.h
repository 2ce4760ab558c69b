#pragma once

#include "mesh/triangle_mesh.h"

namespace karcher {

/// A tree of boxes around the faces of a mesh. It finds the point of the surface that is nearest to
/// a place. A box holds faces with consecutive indices; in an imported mesh, such faces lie near
/// each other (morton.h).
class FaceTree {
 public:
  /// The mesh must outlive the tree.
  explicit FaceTree(const TriangleMesh& mesh);

  struct Nearest {
    int face = -1;
    Vec3 bary = Vec3::Zero();
    double distance = kInfinity;
  };

  /// The nearest point. If several are equally near, it is in the face with the smallest index.
  /// Throws Error kNotFinite for a place that is not finite, and kBadArgument for a coordinate
  /// beyond 1e30.
  Nearest nearest(const Vec3& place) const;

 private:
  struct Box {
    Vec3 low = Vec3::Constant(kInfinity);
    Vec3 high = Vec3::Constant(-kInfinity);
  };

  void search(int node, const Vec3& place, Nearest& best) const;
  double squaredDistance(int node, const Vec3& place) const;

  const TriangleMesh& mesh_;
  int leaves_ = 1;  ///< the number of leaves, a power of 2
  /// the boxes of nodes: node i has the children 2 i and 2 i + 1; the root is 1
  Array<Box> boxes_;
};

}  // namespace karcher

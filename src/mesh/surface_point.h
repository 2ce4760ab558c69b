#pragma once

#include "mesh/rounding.h"
#include "mesh/triangle_mesh.h"

/// Points anywhere on the surface, also on edges and at vertices. A point is a face and barycentric
/// weights.
namespace karcher {

struct SurfacePoint {
  int face = 0;
  /// Weights of the face's corners 0, 1, 2: none negative, sum 1. A zero weight is an exact 0.
  Vec3 bary = Vec3(1, 0, 0);
};

/// Checks and cleans a caller's point on a mesh of `faceCount` faces. Weights may be negative, and
/// their sum may differ from 1, by up to 1e-6. Weights below kLocalRounding become 0, and the sum
/// becomes 1. Throws Error: kBadIndex (no such face), kNotFinite, kBadPoint.
SurfacePoint checkedPoint(int faceCount, int face, const Vec3& bary);
inline SurfacePoint checkedPoint(const TriangleMesh& mesh, int face, const Vec3& bary) {
  return checkedPoint(mesh.faceCount(), face, bary);
}

/// The point with these weights. Weights below kLocalRounding come from rounding and become 0, so
/// that the point lies exactly on an edge or at a vertex. The sum becomes 1.
inline SurfacePoint clampedPoint(int face, const Vec3& bary) {
  SurfacePoint point{face, bary};
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] < kLocalRounding) point.bary[k] = 0;
  }
  // Most weights already have this sum, and divisions are slow.
  const double sum = point.bary[0] + point.bary[1] + point.bary[2];
  if (std::abs(sum - 1) > kStepRounding) point.bary /= sum;
  return point;
}

/// The point at a vertex, in the vertex's first face. Throws Error kBadIndex if there is no such
/// vertex.
SurfacePoint vertexPoint(const TriangleMesh& mesh, int vertex);

Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point);

/// The place of a point: in a face, on an edge (not at its ends), or at a vertex.
enum class Simplex { kFace, kEdge, kVertex };

struct PointLocation {
  Simplex simplex = Simplex::kFace;
  int face = 0;
  int halfedge = -1;  ///< the half-edge in the point's own face, for kEdge
  int vertex = -1;    ///< the vertex, for kVertex
};

PointLocation locate(const TriangleMesh& mesh, const SurfacePoint& point);

/// The point at parameter s in [0, 1] along half-edge h, in h's face.
SurfacePoint edgePoint(int h, double s);

/// The same point, with its weights in `face`. This may be the other face of the point's edge, or
/// any face around its vertex. Throws Error kBadArgument if `face` does not hold the point.
SurfacePoint inFace(const TriangleMesh& mesh, const SurfacePoint& point, int face);

/// The point of the mesh nearest to q by brute force over all faces, for tests and tools.
SurfacePoint nearestPoint(const TriangleMesh& mesh, const Vec3& q);

}  // namespace karcher

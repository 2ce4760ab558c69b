#pragma once

#include "measures/box_tree.h"
#include "mesh/surface_point.h"

/// The sideways turning of a curve on a mesh, by its positions alone: one measure for curves of
/// every origin.
namespace karcher {

/// The points of a mesh nearest to places in space, by a tree of boxes around its faces.
class NearestOnMesh {
 public:
  /// The mesh must outlive the object.
  explicit NearestOnMesh(const TriangleMesh& mesh);
  SurfacePoint at(const Vec3& place) const;

 private:
  const TriangleMesh* mesh_;
  BoxTree tree_;
};

/// Unit normals of a mesh that approximates a smooth surface: at vertices the area-weighted sums of
/// the surrounding faces' normals, interpolated inside faces.
class SmoothNormals {
 public:
  /// The mesh must outlive the object.
  explicit SmoothNormals(const TriangleMesh& mesh);
  Vec3 at(const SurfacePoint& point) const;

 private:
  const TriangleMesh* mesh_;
  Array<Vec3> atVertex_;
};

struct TurningMeasure {
  explicit TurningMeasure(const TriangleMesh& mesh) : nearest(mesh), normals(mesh) {}
  NearestOnMesh nearest;
  SmoothNormals normals;
};

/// `count` places with the same length of the polyline between consecutive ones, its ends included.
Array<Vec3> evenlySpaced(const Array<Vec3>& polyline, int count);

/// The sum of the angles, in degrees, between consecutive pieces of the polyline through `pieces` +
/// 1 even places on a curve. At each place the two pieces are projected to the mesh's tangent plane
/// there.
double turning(const TurningMeasure& measure, const Array<Vec3>& curve, int pieces = 32);

}  // namespace karcher

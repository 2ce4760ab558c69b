#include "intrinsic/tangent.h"

namespace karcher {
namespace {

/// The half-edge that leaves a vertex in a face that holds it.
int cornerAt(const TriangleMesh& mesh, int vertex, int face) {
  int h = 3 * face;
  while (mesh.tail(h) != vertex) ++h;
  return h;
}

}  // namespace

Vec2 logAlong(const Geometry& geometry, const SurfacePath& path) {
  const TriangleMesh& mesh = *geometry.mesh;
  const SurfacePoint& start = path.points.front();
  for (int i = 1; i < path.points.count(); ++i) {
    if (!(path.lengths[i] > 0)) continue;
    const int face = commonFace(mesh, start, path.points[i]);
    if (face < 0) break;
    const Vec2 step = pointInFace(geometry, inFace(mesh, path.points[i], face)) -
                      pointInFace(geometry, inFace(mesh, start, face));
    Vec2 vector = path.length() * step.normalized();
    const PointLocation at = locate(mesh, start);
    if (at.simplex == Simplex::kVertex) {
      const double direction = directionAtTail(geometry, cornerAt(mesh, at.vertex, face), vector);
      return path.length() * unitVector(geometry.angleScale[at.vertex] * direction);
    }
    if (face == start.face) return vector;
    return acrossEdge(geometry, mesh.twin[at.halfedge], vector);
  }
  return Vec2::Zero();
}

SurfacePath expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector) {
  const TriangleMesh& mesh = *geometry.mesh;
  const PointLocation at = locate(mesh, point);
  if (at.simplex != Simplex::kVertex || !(vector.norm() > 0)) {
    return traceStraightest(geometry, point, vector).path;
  }
  double angle = angleOf(vector);
  if (angle < 0) angle += 2 * kPi;
  const double direction = angle / geometry.angleScale[at.vertex];
  return traceFromVertex(geometry, at.vertex, direction, vector.norm()).path;
}

}  // namespace karcher

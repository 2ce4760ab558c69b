#include "intrinsic/tangent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "intrinsic/strip_path.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The half-edge that leaves a vertex, in one of the vertex's faces.
int cornerAt(const TriangleMesh& mesh, int vertex, int face) {
  int h = 3 * face;
  while (mesh.tail(h) != vertex) ++h;
  return h;
}

/// The vector from point `from` of a path toward point `first`, in the frame of a face of both. The
/// direction of a short vector is known only up to rounding over its length. So the vector extends
/// to points of the next faces, unfolded, as long as the path goes straight on within this error,
/// and until the vector is as long as the face's longest edge. `stride` leads to the next point.
Vec2 vectorOnward(const Geometry& geometry, const SurfacePath& path, int from, int first,
                  int stride, int face) {
  const TriangleMesh& mesh = *geometry.mesh;
  Vec2 vector = stepInFace(geometry, face, path.points[from], path.points[first]);
  double size = 0;
  for (int h = 3 * face; h < 3 * face + 3; ++h) size = std::max(size, geometry.edgeLength[h]);
  const double rounding = kStepRounding * size;
  Vec2 toFirst = Vec2::UnitX();  // the rotation from the frame of `current` to that of `face`
  int current = face;
  int i = first;
  for (int k = first + stride; k >= 0 && k < path.points.count() && vector.norm() < size;
       i = k, k += stride) {
    const PointLocation at = locate(mesh, path.points[i]);
    if (at.simplex == Simplex::kVertex) break;
    const int next = commonFace(mesh, path.points[i], path.points[k]);
    if (next < 0) break;
    if (next != current) {
      if (at.simplex != Simplex::kEdge) break;
      const int h = faceOf(at.halfedge) == next ? at.halfedge : mesh.twin[at.halfedge];
      if (faceOf(h) != next || faceOf(mesh.twin[h]) != current) break;
      toFirst = rotate(toFirst, acrossEdge(geometry, h, Vec2::UnitX()));
      current = next;
    }
    const Vec2 step = rotate(toFirst, stepInFace(geometry, next, path.points[i], path.points[k]));
    const bool isStraight = vector.dot(step) >= 0 && std::abs(cross(vector, step)) <=
                                                         rounding * (vector.norm() + step.norm());
    if (!isStraight) break;
    vector += step;
  }
  return vector;
}

/// The log vector of a path at its end point `from`, 0 or the last index. `stride` leads to the
/// next point: 1 or -1.
Vec2 logAtEnd(const Geometry& geometry, const SurfacePath& path, int from, int stride) {
  const TriangleMesh& mesh = *geometry.mesh;
  const SurfacePoint& start = path.points[from];
  for (int i = from + stride; i >= 0 && i < path.points.count(); i += stride) {
    if (path.lengths[i] == path.lengths[from] || samePlace(mesh, start, path.points[i])) continue;
    const int face = commonFace(mesh, start, path.points[i]);
    if (face < 0) break;
    const Vec2 onward = vectorOnward(geometry, path, from, i, stride, face);
    Vec2 vector = path.length() * onward.normalized();
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

/// The vector from one point to another that shares a face with it, in the first point's tangent
/// plane.
Vec2 stepAt(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to) {
  return logAlong(geometry, pathThrough(*geometry.mesh, {from, to}));
}

}  // namespace

Vec2 logAlong(const Geometry& geometry, const SurfacePath& path) {
  return logAtEnd(geometry, path, 0, 1);
}

Vec2 logBack(const Geometry& geometry, const SurfacePath& path) {
  return logAtEnd(geometry, path, path.points.count() - 1, -1);
}

double directionAt(const Geometry& geometry, int vertex, const Vec2& vector) {
  const double direction = angleOf(vector) / geometry.angleScale[vertex];
  if (!geometry.mesh->onBoundary[vertex]) return direction;
  const double total = geometry.totalAngle[vertex];
  const double turned = direction < 0 ? direction + 2 * kPi : direction;
  if (turned <= total) return turned;
  return turned - total < 2 * kPi - turned ? total : 0;
}

bool expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector,
              SurfacePath& path) {
  const TriangleMesh& mesh = *geometry.mesh;
  const PointLocation at = locate(mesh, point);
  StraightestPath traced;
  std::swap(traced.path, path);
  if (at.simplex != Simplex::kVertex || !(vector.stableNorm() > 0)) {
    traceStraightest(geometry, point, vector, traced);
  } else {
    const double direction = angleOf(vector) / geometry.angleScale[at.vertex];
    traceFromVertex(geometry, at.vertex, direction, vector.stableNorm(), traced);
  }
  std::swap(traced.path, path);
  return traced.stop == TraceStop::kComplete;
}

SurfacePath expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector) {
  SurfacePath path;
  expAlong(geometry, point, vector, path);
  return path;
}

Vec2 transportAlong(const Geometry& geometry, const SurfacePath& path, const Vec2& vector) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Vec2 leaving = logAlong(geometry, path);
  const Vec2 arriving = -logBack(geometry, path);
  if (!(leaving.norm() > 0) || !(arriving.norm() > 0)) {
    const PointLocation at = locate(mesh, path.start());
    const bool isAcross = at.simplex == Simplex::kEdge && path.start().face != path.end().face;
    return isAcross ? acrossEdge(geometry, at.halfedge, vector) : vector;
  }
  Vec2 carried = rotateBack(leaving.normalized(), vector);  // the vector relative to the path
  const int count = path.points.count();
  for (int i = 1; i + 1 < count; ++i) {
    if (locate(mesh, path.points[i]).simplex != Simplex::kVertex) continue;
    int next = i + 1;
    while (next + 1 < count && path.lengths[next] == path.lengths[i]) ++next;
    const Vec2 in = -stepAt(geometry, path.points[i], path.points[i - 1]);
    const Vec2 out = stepAt(geometry, path.points[next - 1], path.points[next]);
    if (in.norm() > 0 && out.norm() > 0) {
      carried = rotateBack(rotateBack(in.normalized(), out.normalized()), carried);
    }
    i = next - 1;
  }
  return rotate(arriving.normalized(), carried);
}

Vec3 tangentToSpace(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector) {
  const PointLocation at = locate(*geometry.mesh, point);
  if (at.simplex != Simplex::kVertex) return toSpace(geometry, point.face, vector);
  const int h = cornerAt(*geometry.mesh, at.vertex, point.face);
  return toSpace(geometry, point.face, rotate(geometry.vertexToFace[h], vector));
}

Vec2 tangentFromSpace(const Geometry& geometry, const SurfacePoint& point, const Vec3& vector) {
  const PointLocation at = locate(*geometry.mesh, point);
  Vec2 inFace = toFace(geometry, point.face, vector);
  if (at.simplex != Simplex::kVertex) return inFace;
  return rotateBack(geometry.vertexToFace[cornerAt(*geometry.mesh, at.vertex, point.face)], inFace);
}

}  // namespace karcher

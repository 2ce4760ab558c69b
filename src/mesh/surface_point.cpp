#include "mesh/surface_point.h"

#include <string>

#include "mesh/error.h"
#include "mesh/nearest_in_triangle.h"
#include "mesh/rounding.h"

namespace karcher {
SurfacePoint checkedPoint(int faceCount, int face, const Vec3& bary) {
  if (face < 0 || face >= faceCount) {
    throw Error(ErrorCode::kBadIndex, "there is no face " + std::to_string(face) +
                                          ": the mesh has " + std::to_string(faceCount) +
                                          " faces, numbered from 0");
  }
  // The tolerance allows for raycasts in floats and for weights of nine digits.
  const bool isFinite = bary.allFinite();
  if (isFinite && bary.minCoeff() >= -kFloatRounding &&
      std::abs(bary.sum() - 1) <= kFloatRounding) {
    return clampedPoint(face, bary);
  }
  // The text is built only for an error, since its construction takes longer than the rest of the
  // check.
  throw Error(isFinite ? ErrorCode::kBadPoint : ErrorCode::kNotFinite,
              "the point (" + inSentence(bary[0]) + ", " + inSentence(bary[1]) + ", " +
                  inSentence(bary[2]) + ") in face " + std::to_string(face) +
                  (isFinite ? " lies outside it: the weights must be at least 0 and sum to 1"
                            : " has a weight that is not a finite number"));
}

SurfacePoint vertexPoint(const TriangleMesh& mesh, int vertex) {
  if (vertex < 0 || vertex >= mesh.vertexCount()) {
    throw Error(ErrorCode::kBadIndex, "there is no vertex " + std::to_string(vertex) +
                                          ": the mesh has " + std::to_string(mesh.vertexCount()) +
                                          " vertices, numbered from 0");
  }
  const int h = mesh.outgoing[vertex];
  return edgePoint(h, 0);
}

Vec3 position(const TriangleMesh& mesh, const SurfacePoint& point) {
  Vec3 p = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    p += point.bary[k] * mesh.positions[mesh.corner(point.face, k)];
  }
  return p;
}

PointLocation locate(const TriangleMesh& mesh, const SurfacePoint& point) {
  PointLocation location;
  location.face = point.face;
  const bool isZero[] = {point.bary[0] == 0, point.bary[1] == 0, point.bary[2] == 0};
  const int zeros = isZero[0] + isZero[1] + isZero[2];
  if (zeros == 1) {
    location.simplex = Simplex::kEdge;
    // The edge starts at the corner that follows the corner of weight 0.
    location.halfedge = 3 * point.face + (isZero[0] ? 1 : isZero[1] ? 2 : 0);
  } else if (zeros == 2) {
    location.simplex = Simplex::kVertex;
    location.vertex = mesh.corner(point.face, isZero[2] ? (isZero[1] ? 0 : 1) : 2);
  }
  return location;
}

SurfacePoint edgePoint(int h, double s) {
  SurfacePoint point{faceOf(h), Vec3::Zero()};
  point.bary[cornerOf(h)] = 1 - s;
  point.bary[cornerOf(next(h))] = s;
  return point;
}

SurfacePoint inFace(const TriangleMesh& mesh, const SurfacePoint& point, int face) {
  if (face == point.face) return point;
  const PointLocation location = locate(mesh, point);
  if (location.simplex == Simplex::kEdge) {
    const int t = mesh.twin[location.halfedge];
    if (t >= 0 && faceOf(t) == face) {
      return edgePoint(t, point.bary[cornerOf(location.halfedge)]);
    }
  } else if (location.simplex == Simplex::kVertex) {
    for (int k = 0; k < 3; ++k) {
      if (mesh.corner(face, k) == location.vertex) return edgePoint(3 * face + k, 0);
    }
  }
  throw Error(ErrorCode::kBadArgument, "the point in face " + std::to_string(point.face) +
                                           " does not lie in face " + std::to_string(face));
}

SurfacePoint nearestPoint(const TriangleMesh& mesh, const Vec3& q) {
  SurfacePoint best;
  double bestDistance = kInfinity;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Triangle& face = mesh.faces[f];
    const SurfacePoint candidate{
        f, nearestInTriangle(q, mesh.positions[face[0]], mesh.positions[face[1]],
                             mesh.positions[face[2]])};
    const double distance = (position(mesh, candidate) - q).squaredNorm();
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace karcher

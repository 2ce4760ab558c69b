#include "mesh/surface_point.h"

#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// How far outside its triangle a caller's point may be: the rounding of a raycast in floats and
/// of weights written with nine digits.
constexpr double kOutsideTolerance = 1e-6;

/// The point of triangle a, b, c nearest to q, as barycentric weights (Ericson, Real-Time
/// Collision Detection, 5.1.5: by the regions around the triangle).
Vec3 nearestInTriangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(q - a);
  const double d2 = ac.dot(q - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = ab.dot(q - b);
  const double d4 = ac.dot(q - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double s = d1 / (d1 - d3);
    return {1 - s, s, 0};
  }
  const double d5 = ab.dot(q - c);
  const double d6 = ac.dot(q - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double s = d2 / (d2 - d6);
    return {1 - s, 0, s};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - s, s};
  }
  const double total = va + vb + vc;
  return {va / total, vb / total, vc / total};
}

}  // namespace

SurfacePoint checkedPoint(const TriangleMesh& mesh, int face, const Vec3& bary) {
  if (face < 0 || face >= mesh.faceCount()) {
    throw Error(ErrorCode::kBadIndex, "there is no face " + std::to_string(face) +
                                          ": the mesh has " + std::to_string(mesh.faceCount()) +
                                          " faces, numbered from 0");
  }
  const std::string name = "the point (" + inSentence(bary[0]) + ", " + inSentence(bary[1]) + ", " +
                           inSentence(bary[2]) + ") in face " + std::to_string(face);
  if (!bary.allFinite()) {
    throw Error(ErrorCode::kNotFinite, name + " has a weight that is not a finite number");
  }
  if (bary.minCoeff() < -kOutsideTolerance || std::abs(bary.sum() - 1) > kOutsideTolerance) {
    throw Error(ErrorCode::kBadPoint,
                name + " lies outside it: the weights must be at least 0 and sum to 1");
  }
  return clampedPoint(face, bary);
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
  int zeros = 0;
  int zeroCorner = -1;
  int oneCorner = -1;
  for (int k = 0; k < 3; ++k) {
    if (point.bary[k] == 0) {
      ++zeros;
      zeroCorner = k;
    } else {
      oneCorner = k;
    }
  }
  if (zeros == 1) {
    location.simplex = Simplex::kEdge;
    location.halfedge = 3 * point.face + (zeroCorner + 1) % 3;
  } else if (zeros == 2) {
    location.simplex = Simplex::kVertex;
    location.vertex = mesh.corner(point.face, oneCorner);
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

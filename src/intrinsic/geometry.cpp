#include "intrinsic/geometry.h"

#include <algorithm>

#include "intrinsic/angles.h"
#include "mesh/positions.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Twice the area, from the cross product of the two shortest edges. The rounding error of a cross
/// product is proportional to the product of the two lengths. For the two long edges of a needle,
/// this far exceeds the area.
double doubledArea(const Vec3& e0, const Vec3& e1, const Vec3& e2) {
  const double a = e0.squaredNorm();
  const double b = e1.squaredNorm();
  const double c = e2.squaredNorm();
  if (c >= a && c >= b) return e0.cross(e1).norm();
  return a >= b ? e1.cross(e2).norm() : e2.cross(e0).norm();
}

void measureFaces(const TriangleMesh& mesh, Geometry& geometry) {
  const size_t halfedges = static_cast<size_t>(mesh.halfedgeCount());
  geometry.edgeLength.resize(halfedges);
  geometry.cornerAngle.resize(halfedges);
  geometry.apex.resize(mesh.faces.size());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Vec3& p0 = mesh.positions[mesh.corner(f, 0)];
    const Vec3& p1 = mesh.positions[mesh.corner(f, 1)];
    const Vec3& p2 = mesh.positions[mesh.corner(f, 2)];
    const Vec3 e0 = p1 - p0;
    const Vec3 e1 = p2 - p1;
    const Vec3 e2 = p0 - p2;
    const double length = e0.norm();
    geometry.edgeLength[3 * f] = length;
    geometry.edgeLength[3 * f + 1] = e1.norm();
    geometry.edgeLength[3 * f + 2] = e2.norm();
    const double area = doubledArea(e0, e1, e2);
    geometry.cornerAngle[3 * f] = std::atan2(area, -e2.dot(e0));
    geometry.cornerAngle[3 * f + 1] = std::atan2(area, -e0.dot(e1));
    geometry.cornerAngle[3 * f + 2] = std::atan2(area, -e1.dot(e2));
    geometry.apex[f] = Vec2(-e2.dot(e0), area) / length;
  }
}

void cumulateAngles(const TriangleMesh& mesh, Geometry& geometry) {
  geometry.cumulatedAngle.resize(static_cast<size_t>(mesh.halfedgeCount()));
  geometry.totalAngle.resize(mesh.positions.size());
  geometry.angleScale.resize(mesh.positions.size());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    double angle = 0;
    for (const int h : outgoingHalfedges(mesh, v)) {
      geometry.cumulatedAngle[h] = angle;
      angle += geometry.cornerAngle[h];
    }
    geometry.totalAngle[v] = angle;
    geometry.angleScale[v] = mesh.onBoundary[v] ? 1 : 2 * kPi / angle;
  }
}

/// Computes one rotation for each corner: the direction from the vertex to the face's centroid, as
/// an angle in the frame of the face, minus the same direction in the frame of the vertex.
void connectFrames(const TriangleMesh& mesh, Geometry& geometry) {
  geometry.vertexToFace.resize(static_cast<size_t>(mesh.halfedgeCount()));
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Vec2 corners[3] = {cornerInFace(geometry, f, 0), cornerInFace(geometry, f, 1),
                             cornerInFace(geometry, f, 2)};
    const Vec2 centroid = (corners[0] + corners[1] + corners[2]) / 3;
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * f + k;
      const Vec2 edge = corners[k == 2 ? 0 : k + 1] - corners[k];
      const Vec2 toCentroid = centroid - corners[k];
      const double inCorner = angleFromTo(edge, toCentroid);
      const double inVertex =
          geometry.angleScale[mesh.tail(h)] * (geometry.cumulatedAngle[h] + inCorner);
      geometry.vertexToFace[h] = rotateBack(unitVector(inVertex), toCentroid.normalized());
    }
  }
}

}  // namespace

Geometry buildGeometry(const TriangleMesh& mesh) {
  Geometry geometry;
  geometry.mesh = &mesh;
  measureFaces(mesh, geometry);
  cumulateAngles(mesh, geometry);
  connectFrames(mesh, geometry);
  const auto [shortest, longest] =
      std::minmax_element(geometry.edgeLength.begin(), geometry.edgeLength.end());
  geometry.shortestEdge = *shortest;
  geometry.longestEdge = *longest;
  geometry.meanEdge = meanEdgeLength(mesh);
  geometry.diagonal = boundingBoxDiagonal(mesh);
  geometry.extent = extentOf(mesh.positions);
  return geometry;
}

Vec3 barycentric(const Geometry& geometry, int f, const Vec2& x) {
  const Vec2& apex = geometry.apex[f];
  const double b2 = x.y() / apex.y();
  const double b1 = (x.x() - b2 * apex.x()) / geometry.edgeLength[3 * f];
  return {1 - b1 - b2, b1, b2};
}

Vec2 stepInFace(const Geometry& geometry, int f, const SurfacePoint& from, const SurfacePoint& to) {
  const Vec3 change = inFace(*geometry.mesh, to, f).bary - inFace(*geometry.mesh, from, f).bary;
  // The step is a sum along the two sides that meet at the corner whose weight changes most. If
  // another weight does not change, only one of the two sides contributes.
  int corner = 0;
  change.cwiseAbs().maxCoeff(&corner);
  const int h = 3 * f + corner;
  return change[cornerOf(next(h))] * halfedgeInFace(geometry, h) -
         change[cornerOf(previous(h))] * halfedgeInFace(geometry, previous(h));
}

Vec2 acrossEdge(const Geometry& geometry, int h, const Vec2& vector) {
  const Vec2 here = halfedgeInFace(geometry, h) / geometry.edgeLength[h];
  const int t = geometry.mesh->twin[h];
  const Vec2 there = -halfedgeInFace(geometry, t) / geometry.edgeLength[t];
  return rotate(there, rotateBack(here, vector));
}

Vec3 toSpace(const Geometry& geometry, int f, const Vec2& vector) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Vec3& p0 = mesh.positions[mesh.corner(f, 0)];
  const Vec3 e1 = mesh.positions[mesh.corner(f, 1)] - p0;
  const Vec3 e2 = mesh.positions[mesh.corner(f, 2)] - p0;
  const Vec3 x = e1 / geometry.edgeLength[3 * f];
  const Vec3 y = (e2 - geometry.apex[f].x() * x) / geometry.apex[f].y();
  return vector.x() * x + vector.y() * y;
}

Vec2 toFace(const Geometry& geometry, int f, const Vec3& vector) {
  const Vec3 x = toSpace(geometry, f, Vec2(1, 0));
  const Vec3 y = toSpace(geometry, f, Vec2(0, 1));
  return {vector.dot(x), vector.dot(y)};
}

double directionAtTail(const Geometry& geometry, int h, const Vec2& vector) {
  const Vec2 edge = halfedgeInFace(geometry, h);
  return geometry.cumulatedAngle[h] + angleFromTo(edge, vector);
}

EdgeDirection directionOfEdge(const Geometry& geometry, int h) {
  const int onward = next(h);
  const double back = geometry.cumulatedAngle[onward] + geometry.cornerAngle[onward];
  return {unitVector(geometry.angleScale[geometry.mesh->tail(h)] * geometry.cumulatedAngle[h]),
          unitVector(geometry.angleScale[geometry.mesh->head(h)] * back + kPi)};
}

CornerDirection cornerOfDirection(const Geometry& geometry, int vertex, double direction) {
  const TriangleMesh& mesh = *geometry.mesh;
  const double total = geometry.totalAngle[vertex];
  if (mesh.onBoundary[vertex]) {
    const auto isOn = [&](double d) { return d >= -kChainRounding && d <= total + kChainRounding; };
    for (const double turn : {0.0, 2 * kPi, -2 * kPi}) {
      if (!isOn(direction + turn)) continue;
      direction += turn;
      break;
    }
    if (!isOn(direction)) return {};
    direction = std::clamp(direction, 0.0, total);
  } else {
    direction -= total * std::floor(direction / total);
  }
  int h = mesh.outgoing[vertex];
  for (;;) {
    const int left = rotateLeft(mesh, h);
    const bool last = left < 0 || left == mesh.outgoing[vertex];
    if (last || direction < geometry.cumulatedAngle[left]) {
      return {h, std::clamp(direction - geometry.cumulatedAngle[h], 0.0, geometry.cornerAngle[h])};
    }
    h = left;
  }
}

}  // namespace karcher

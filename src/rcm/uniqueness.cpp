#include "rcm/uniqueness.h"

#include <algorithm>
#include <cmath>

#include "distance/shortest_path.h"
#include "mesh/nearest_in_triangle.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The paths of the proof lie within this radius of the center, relative to the radius r of a ball
/// about the center. A shortest path between two points in the ball stays within 2 r of the center.
/// At the distance 2 r from the center the energy is larger than at the center. A shortest path
/// from a place at this distance to a point in the ball stays within 3 r.
constexpr double kReach = 3;

/// The proof applies up to this fraction of a smooth surface's radius of convexity, since the mesh
/// differs from the surface.
constexpr double kConvexPart = 0.9;

double distanceToFace(const TriangleMesh& mesh, int f, const Vec3& place) {
  const Vec3& a = mesh.positions[mesh.corner(f, 0)];
  const Vec3& b = mesh.positions[mesh.corner(f, 1)];
  const Vec3& c = mesh.positions[mesh.corner(f, 2)];
  const Vec3 bary = nearestInTriangle(place, a, b, c);
  return (bary[0] * a + bary[1] * b + bary[2] * c - place).norm();
}

struct FaceSet {
  Array<int> faces;
  Array<char> isIn;  ///< one entry for each face of the mesh
};

/// The faces within `radius` of the center in space. A face counts only if a chain of such faces,
/// adjacent at edges, connects it to the center's face. The result contains the geodesic
/// ball of that radius.
FaceSet facesWithin(const TriangleMesh& mesh, const SurfacePoint& center, double radius) {
  const Vec3 place = position(mesh, center);
  FaceSet found;
  found.isIn.assign(static_cast<size_t>(mesh.faceCount()), 0);
  const auto add = [&](int f) {
    found.isIn[f] = 1;
    found.faces.push_back(f);
  };
  add(center.face);
  for (int k = 0; k < found.faces.count(); ++k) {
    const int f = found.faces[k];
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.twin[h] < 0) continue;
      const int other = faceOf(mesh.twin[h]);
      if (found.isIn[other] == 0 && distanceToFace(mesh, other, place) <= radius) add(other);
    }
  }
  return found;
}

bool isPositivelyCurved(const Geometry& geometry, int vertex) {
  return geometry.mesh->onBoundary[vertex] == 0 &&
         geometry.totalAngle[vertex] < 2 * kPi - kChainRounding;
}

/// Whether the faces, which are connected through edges, form a disk in which no vertex has
/// positive curvature.
bool isDiskWithoutPositiveCurvature(const Geometry& geometry, const FaceSet& set) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<char> isCounted;
  isCounted.assign(static_cast<size_t>(mesh.vertexCount()), 0);
  int vertices = 0;
  int sides = 0;
  for (const int f : set.faces) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int vertex = mesh.tail(h);
      if (isPositivelyCurved(geometry, vertex)) return false;
      if (isCounted[vertex] == 0) ++vertices;
      isCounted[vertex] = 1;
      // The loop counts an interior edge from both sides.
      const bool inside = mesh.twin[h] >= 0 && set.isIn[faceOf(mesh.twin[h])] != 0;
      sides += inside ? 1 : 2;
    }
  }
  // The Euler characteristic is 1 for a disk, and for no other surface whose faces are connected
  // through edges.
  return vertices - sides / 2 + set.faces.count() == 1;
}

bool isProvedOnMesh(const Geometry& geometry, const SurfacePoint& center, double radius) {
  const TriangleMesh& mesh = *geometry.mesh;
  // Most meshes fail this test.
  for (int k = 0; k < 3; ++k) {
    if (isPositivelyCurved(geometry, mesh.corner(center.face, k))) return false;
  }
  return isDiskWithoutPositiveCurvature(geometry, facesWithin(mesh, center, kReach * radius));
}

bool isProvedOnSmoothSurface(const CurvatureBound& bound, double radius) {
  const double convex =
      std::min(bound.injectivityRadius / 2, kPi / (4 * std::sqrt(bound.largestCurvature)));
  return radius < kConvexPart * convex;
}

}  // namespace

const char* uniquenessName(Uniqueness uniqueness) {
  switch (uniqueness) {
    case Uniqueness::kCertain:
      return "certain";
    case Uniqueness::kLikely:
      return "likely";
    case Uniqueness::kNotUnique:
      return "notUnique";
    default:
      return "notLooked";
  }
}

std::optional<CurvatureBound> curvatureBound(Shape shape) {
  if (shape == Shape::kSphere) return CurvatureBound{1, kPi};
  if (shape != Shape::kTorus) return std::nullopt;
  // The largest curvature is at the outer equator; the shortest closed geodesics lead around the
  // tube or along the inner equator.
  const double largest = 1 / (kTorusMinor * (kTorusMajor + kTorusMinor));
  const double around = kPi * std::min(kTorusMinor, kTorusMajor - kTorusMinor);
  return CurvatureBound{largest, std::min(around, kPi / std::sqrt(largest))};
}

double provedRadius(const Surface& surface, const Array<SurfacePoint>& points,
                    const Array<double>& weights, const SurfacePoint& center,
                    const std::optional<CurvatureBound>& smooth) {
  const TriangleMesh& mesh = surface.mesh();
  const auto isProved = [&](double radius) {
    return (smooth && isProvedOnSmoothSurface(*smooth, radius)) ||
           isProvedOnMesh(surface.geometry(), center, radius);
  };
  double chord = 0;
  for (int i = 0; i < points.count(); ++i) {
    if (weights[i] < 0) return -1;
    if (weights[i] == 0) continue;
    chord = std::max(chord, (position(mesh, points[i]) - position(mesh, center)).norm());
  }
  // Chords come first, since paths are no shorter and take longer to find.
  if (!isProved(chord)) return -1;
  double radius = chord;
  for (int i = 0; i < points.count(); ++i) {
    if (weights[i] == 0) continue;
    radius = std::max(radius, shortestPath(surface.geometry(), center, points[i]).length());
  }
  return isProved(radius) ? radius : -1;
}

Array<SurfacePoint> spreadPoints(Surface& surface, int face, int count) {
  const TriangleMesh& mesh = surface.mesh();
  const int component = surface.component(mesh.corner(face, 0));
  const auto areaOf = [&](int f) {
    const bool belongs = surface.component(mesh.corner(f, 0)) == component;
    return belongs ? doubleArea(surface.geometry(), f) : 0.0;
  };
  double all = 0;
  for (int f = 0; f < mesh.faceCount(); ++f) all += areaOf(f);
  Array<SurfacePoint> result;
  double sum = 0;
  int step = 0;
  for (int f = 0; f < mesh.faceCount() && step < count; ++f) {
    sum += areaOf(f);
    // One large face may contain the middles of several steps, but occurs only once.
    bool ends = false;
    for (; step < count && sum * count >= (step + 0.5) * all; ++step) ends = true;
    if (ends) result.push_back({f, Vec3::Constant(1.0 / 3)});
  }
  return result;
}

}  // namespace karcher

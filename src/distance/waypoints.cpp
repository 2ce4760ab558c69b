#include "distance/waypoints.h"

#include <utility>

namespace karcher {
namespace {

constexpr int kMostWaypoints = 31;

/// Where two paths are compared: at so many parts of their lengths.
constexpr int kComparedParts = 32;

/// How far apart they may lie there, as a part of their length.
constexpr double kSamePath = 1e-4;

bool areAlike(const TriangleMesh& mesh, const SurfacePath& a, const SurfacePath& b) {
  const double tolerance = kSamePath * a.length();
  if (std::abs(a.length() - b.length()) > tolerance) return false;
  for (int i = 1; i < kComparedParts; ++i) {
    const double part = static_cast<double>(i) / kComparedParts;
    const Vec3 p = position(mesh, pointAlong(mesh, a, part * a.length()));
    const Vec3 q = position(mesh, pointAlong(mesh, b, part * b.length()));
    if ((p - q).norm() > tolerance) return false;
  }
  return true;
}

}  // namespace

bool findPathBy(const Geometry& geometry, const SurfacePoint& from,
                const Array<SurfacePoint>& waypoints, const SurfacePoint& to,
                FindPathWorkspace& workspace, SurfacePath& path) {
  SurfacePath whole;
  for (int i = 0; i <= waypoints.count(); ++i) {
    const SurfacePoint& start = i == 0 ? from : waypoints[i - 1];
    const SurfacePoint& end = i == waypoints.count() ? to : waypoints[i];
    SurfacePath part;
    if (!findPath(geometry, start, end, workspace, part)) return false;
    if (i == 0) {
      whole = std::move(part);
    } else {
      appendPart(*geometry.mesh, part, 0, part.length(), whole);
    }
  }
  if (!waypoints.empty()) straighten(geometry, whole, workspace.strip);
  path = std::move(whole);
  return true;
}

Array<SurfacePoint> waypointsOf(const Geometry& geometry, const SurfacePath& path,
                                FindPathWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<SurfacePoint> waypoints;
  SurfacePath found;
  for (int count = 0; count <= kMostWaypoints; count = 2 * count + 1) {
    waypoints.clear();
    for (int i = 1; i <= count; ++i) {
      waypoints.push_back(pointAlong(mesh, path, i * path.length() / (count + 1)));
    }
    if (findPathBy(geometry, path.start(), waypoints, path.end(), workspace, found) &&
        areAlike(mesh, path, found)) {
      break;
    }
  }
  return waypoints;
}

}  // namespace karcher

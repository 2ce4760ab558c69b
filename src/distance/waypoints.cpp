#include "distance/waypoints.h"

#include <utility>

#include "intrinsic/straighten.h"

namespace karcher {
namespace {

/// The number of equal parts into which a comparison divides each of two paths. It compares the
/// ends of the parts.
constexpr int kComparedParts = 32;

/// Paths count as equal if their lengths, and the places at these ends, differ by at most this
/// ratio of the length.
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

/// Whether the waypoints themselves are a path across faces from edge to edge.
bool areCrossings(const TriangleMesh& mesh, const SurfacePoint& from,
                  const Array<SurfacePoint>& waypoints, const SurfacePoint& to) {
  const SurfacePoint* last = &from;
  for (const SurfacePoint& point : waypoints) {
    if (locate(mesh, point).simplex == Simplex::kFace) return false;
    if (!haveCommonFace(mesh, *last, point)) return false;
    last = &point;
  }
  return !waypoints.empty() && haveCommonFace(mesh, *last, to);
}

}  // namespace

bool findPathBy(const Geometry& geometry, const SurfacePoint& from,
                const Array<SurfacePoint>& waypoints, const SurfacePoint& to,
                FindPathWorkspace& workspace, SurfacePath& path) {
  if (areCrossings(*geometry.mesh, from, waypoints, to)) {
    path.points.assign(1, from);
    path.points.insert(path.points.end(), waypoints.begin(), waypoints.end());
    path.points.push_back(to);
    measure(*geometry.mesh, path);
    return true;
  }
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
                                FindPathWorkspace& workspace, const FindPathOptions& options) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<SurfacePoint> waypoints;
  SurfacePath found;
  const auto isFound = [&] {
    return findPathBy(geometry, path.start(), waypoints, path.end(), workspace, found) &&
           areAlike(mesh, path, found);
  };
  // With as many waypoints as the path has points, no point could move.
  for (int count = 0; count == 0 || count < path.points.count() - 2; count = 2 * count + 1) {
    waypoints.clear();
    for (int i = 1; i <= count; ++i) {
      waypoints.push_back(pointAlong(mesh, path, i * path.length() / (count + 1)));
    }
    if (!isFound()) continue;
    if (count > 0 || !options.certified) return waypoints;
    if (findPath(geometry, path.start(), path.end(), workspace, found, options) &&
        areAlike(mesh, path, found)) {
      return waypoints;
    }
  }
  waypoints.clear();
  for (int i = 1; i + 1 < path.points.count(); ++i) waypoints.push_back(path.points[i]);
  return waypoints;
}

}  // namespace karcher

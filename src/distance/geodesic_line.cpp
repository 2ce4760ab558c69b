#include "distance/geodesic_line.h"

#include <algorithm>
#include <utility>

#include "distance/shortest_path.h"
#include "intrinsic/local_path.h"
#include "intrinsic/surface_path.h"

namespace karcher {

namespace {

/// Writes the path by a search that begins at `from`; returns false if it finds no strip of faces.
bool searchFrom(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                StripWorkspace& workspace, SurfacePath& line) {
  line.points.assign(1, from);
  const LocalPathOptions everywhere{2 * geometry.mesh->faceCount()};
  if (!appendLocalPath(geometry, from, to, workspace, line.points, everywhere)) return false;
  measure(*geometry.mesh, line);
  return true;
}

}  // namespace

void geodesicLine(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                  GeodesicWorkspace& workspace, SurfacePath& line) {
  if (!searchFrom(geometry, from, to, workspace.strip, line)) {
    line = shortestPath(geometry, from, to);
    measure(*geometry.mesh, line);
    return;
  }
  SurfacePath& back = workspace.back;
  if (!searchFrom(geometry, to, from, workspace.strip, back) || !(back.length() < line.length())) {
    return;
  }
  std::swap(line, back);
  std::reverse(line.points.begin(), line.points.end());
  measure(*geometry.mesh, line);
}

void halve(const TriangleMesh& mesh, const SurfacePath& line, LineHalves& halves) {
  const double half = line.length() / 2;
  const int after = pieceAt(line.lengths, half) + 1;
  const SurfacePoint middle = pointAlong(mesh, line, half);
  auto& [first, second] = halves;
  first.points.assign(line.points.begin(), line.points.begin() + after);
  first.lengths.assign(line.lengths.begin(), line.lengths.begin() + after);
  first.points.push_back(middle);
  first.lengths.push_back(half);
  second.points.assign(1, middle);
  second.lengths.assign(1, 0.0);
  for (int i = after; i < line.points.count(); ++i) {
    second.points.push_back(line.points[i]);
    second.lengths.push_back(line.lengths[i] - half);
  }
}

SurfacePoint averageOf(const Geometry& geometry, const SurfacePoint& a, const SurfacePoint& b,
                       double s) {
  if (s <= 0) return a;
  if (s >= 1) return b;
  SurfacePath path = shortestPath(geometry, a, b);
  measure(*geometry.mesh, path);
  return pointAlong(*geometry.mesh, path, s * path.length());
}

}  // namespace karcher

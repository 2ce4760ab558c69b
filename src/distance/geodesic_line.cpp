#include "distance/geodesic_line.h"

#include <algorithm>

#include "distance/shortest_path.h"
#include "intrinsic/along_path.h"
#include "intrinsic/local_path.h"

namespace karcher {

namespace {

/// The points of the path by a search that begins at `from`, with their lengths; none if it finds
/// no strip of faces.
SurfacePath searchedFrom(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to) {
  SurfacePath line;
  line.points.push_back(from);
  StripWorkspace workspace;
  const LocalPathOptions everywhere{2 * geometry.mesh->faceCount()};
  if (!appendLocalPath(geometry, from, to, workspace, line.points, everywhere)) return {};
  measure(*geometry.mesh, line);
  return line;
}

}  // namespace

SurfacePath geodesicLine(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to) {
  SurfacePath line = searchedFrom(geometry, from, to);
  if (line.points.empty()) {
    line = shortestPath(geometry, from, to);
    measure(*geometry.mesh, line);
    return line;
  }
  SurfacePath back = searchedFrom(geometry, to, from);
  if (back.points.empty() || !(back.length() < line.length())) return line;
  back = reversed(back);
  measure(*geometry.mesh, back);
  return back;
}

LineHalves halvesOf(const TriangleMesh& mesh, const SurfacePath& line) {
  const double half = line.length() / 2;
  const int after = pieceAt(line.lengths, half) + 1;
  const SurfacePoint middle = pointAlong(mesh, line, half);
  LineHalves halves;
  halves.first.points.assign(line.points.begin(), line.points.begin() + after);
  halves.first.lengths.assign(line.lengths.begin(), line.lengths.begin() + after);
  halves.first.points.push_back(middle);
  halves.first.lengths.push_back(half);
  halves.second.points.push_back(middle);
  halves.second.lengths.push_back(0);
  for (int i = after; i < line.points.count(); ++i) {
    halves.second.points.push_back(line.points[i]);
    halves.second.lengths.push_back(line.lengths[i] - half);
  }
  return halves;
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

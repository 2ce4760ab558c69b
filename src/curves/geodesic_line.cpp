#include "curves/geodesic_line.h"

#include "distance/shortest_path.h"
#include "intrinsic/local_path.h"

namespace karcher {

GeodesicLine geodesicLine(const Geometry& geometry, const SurfacePoint& from,
                          const SurfacePoint& to) {
  GeodesicLine line;
  line.points.push_back(from);
  LocalPathWorkspace workspace;
  double length = 0;
  const LocalPathOptions everywhere{2 * geometry.mesh->faceCount()};
  if (!appendLocalPath(geometry, from, to, workspace, line.points, length, everywhere)) {
    line.points = shortestPath(geometry, from, to).points;
  }
  line.lengths = lengthsAlong(*geometry.mesh, line.points);
  return line;
}

LineHalves halvesOf(const TriangleMesh& mesh, const GeodesicLine& line) {
  const double half = line.length() / 2;
  const int after = pieceAt(line.lengths, half) + 1;
  const SurfacePoint middle = pointAlong(mesh, line.points, line.lengths, half);
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

}  // namespace karcher

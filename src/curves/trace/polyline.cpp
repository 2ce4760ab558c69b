#include "curves/trace/polyline.h"

#include "distance/shortest_path.h"
#include "intrinsic/along_path.h"

namespace karcher {

PolylineSegment traceShortestPath(Surface& surface, const SurfacePoint& from,
                                  const SurfacePoint& to, int samples) {
  const TriangleMesh& mesh = surface.mesh();
  const Array<SurfacePoint> points = shortestPath(surface.geometry(), from, to).points;
  const Array<double> lengths = lengthsAlong(mesh, points);
  PolylineSegment segment;
  JoinedPath& path = segment.path;
  path.length = lengths.back();
  int next = 1;  // of the shortest path's points
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / (samples - 1);
    const double length = t * path.length;
    const SurfacePoint point = i == 0             ? from
                               : i == samples - 1 ? to
                                                  : pointAlong(mesh, points, lengths, length);
    for (; next < points.count() && lengths[next] < length; ++next) {
      path.points.push_back(points[next]);
      path.sample.push_back(i);
    }
    segment.samples.push_back({t, point, Status::kConverged});
    path.points.push_back(point);
    path.sample.push_back(i);
  }
  path.unconverged.assign(path.points.size(), 0);
  return segment;
}

}  // namespace karcher

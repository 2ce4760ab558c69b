#include "curves/trace/polyline.h"

namespace karcher {

TracedPiece traceLeg(const TriangleMesh& mesh, const SurfacePath& leg, int samples) {
  TracedPiece piece;
  JoinedPath& path = piece.path;
  path.length = leg.length();
  int next = 1;  // of the leg's points
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / (samples - 1);
    const double length = t * path.length;
    const SurfacePoint point = i == 0             ? leg.start()
                               : i == samples - 1 ? leg.end()
                                                  : pointAlong(mesh, leg, length);
    for (; next < leg.points.count() && leg.lengths[next] < length; ++next) {
      path.points.push_back(leg.points[next]);
      path.sample.push_back(i);
    }
    piece.samples.push_back({t, point, Status::kConverged});
    path.points.push_back(point);
    path.sample.push_back(i);
  }
  path.unconverged.assign(path.points.size(), 0);
  return piece;
}

}  // namespace karcher

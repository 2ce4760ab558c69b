#include "curves/trace/polyline.h"

namespace karcher {

TracedPiece traceLeg(const TriangleMesh& mesh, const SurfacePath& leg, int samples) {
  TracedPiece piece;
  JoinedPath& path = piece.path;
  int next = 1;  // the index of the leg's next point
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / (samples - 1);
    const double length = t * leg.length();
    const SurfacePoint point = i == 0             ? leg.start()
                               : i == samples - 1 ? leg.end()
                                                  : pointAlong(mesh, leg, length);
    for (; next < leg.points.count() && leg.lengths[next] < length; ++next) {
      path.line.points.push_back(leg.points[next]);
      path.line.lengths.push_back(leg.lengths[next]);
      path.sample.push_back(i);
    }
    piece.samples.push_back({t, point, SampleStatus::kConverged});
    path.line.points.push_back(point);
    path.line.lengths.push_back(length);
    path.sample.push_back(i);
  }
  path.unconverged.assign(path.sample.size(), 0);
  return piece;
}

}  // namespace karcher

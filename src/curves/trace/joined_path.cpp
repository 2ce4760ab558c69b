#include "curves/trace/joined_path.h"

#include "distance/shortest_path.h"
#include "intrinsic/local_path.h"

namespace karcher {

JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples,
                       const Array<Bridge>& bridges, EdgeCrossings* crossings) {
  JoinedPath path;
  StripWorkspace workspace;
  path.points.push_back(samples.front().point);
  path.sample.push_back(0);
  path.unconverged.push_back(samples.front().status != Status::kConverged);
  auto bridge = bridges.begin();
  for (int i = 1; i < samples.count(); ++i) {
    const SurfacePoint& from = samples[i - 1].point;
    const SurfacePoint& to = samples[i].point;
    const Geometry& geometry = surface.geometry();
    while (bridge != bridges.end() && bridge->t1 <= samples[i - 1].t) ++bridge;
    const bool isBridged = bridge != bridges.end() && bridge->t0 <= samples[i - 1].t;
    if (isBridged) {
      appendPart(surface.mesh(), *bridge, samples[i - 1].t, samples[i].t, path.points, path.length);
    } else if (crossings && samples[i - 1].status == Status::kConverged &&
               samples[i].status == Status::kConverged &&
               crossings->append(samples[i - 1], samples[i], path.points, path.length)) {
      // The curve itself.
    } else if (!appendLocalPath(geometry, from, to, workspace, path.points, path.length)) {
      const SurfacePath shortest = shortestPath(geometry, from, to);
      path.points.insert(path.points.end(), shortest.points.begin() + 1, shortest.points.end());
      path.length += shortest.length();
    }
    path.sample.resize(path.points.size(), i);
    path.unconverged.resize(path.points.size(),
                            isBridged || samples[i].status != Status::kConverged);
  }
  return path;
}

}  // namespace karcher

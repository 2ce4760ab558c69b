#include "curves/trace/joined_path.h"

#include "distance/shortest_path.h"
#include "intrinsic/local_path.h"

namespace karcher {

JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples,
                       const Array<Bridge>& bridges, EdgeCrossings* crossings) {
  JoinedPath path;
  StripWorkspace workspace;
  joinSamples(surface, samples, bridges, crossings, workspace, path);
  return path;
}

void joinSamples(Surface& surface, const Array<CurveSample>& samples, const Array<Bridge>& bridges,
                 EdgeCrossings* crossings, StripWorkspace& workspace, JoinedPath& path) {
  Array<SurfacePoint>& points = path.line.points;
  points.assign(1, samples.front().point);
  path.sample.assign(1, 0);
  path.unconverged.assign(1, samples.front().status != SampleStatus::kConverged);
  auto bridge = bridges.begin();
  for (int i = 1; i < samples.count(); ++i) {
    const SurfacePoint& from = samples[i - 1].point;
    const SurfacePoint& to = samples[i].point;
    const Geometry& geometry = surface.geometry();
    while (bridge != bridges.end() && bridge->t1 <= samples[i - 1].t) ++bridge;
    const bool isBridged = bridge != bridges.end() && bridge->t0 <= samples[i - 1].t;
    if (isBridged) {
      appendPart(surface.mesh(), *bridge, samples[i - 1].t, samples[i].t, points);
    } else if (crossings && samples[i - 1].status == SampleStatus::kConverged &&
               samples[i].status == SampleStatus::kConverged &&
               crossings->append(samples[i - 1], samples[i], points)) {
      // The path follows the curve itself.
    } else {
      appendGeodesic(geometry, from, to, workspace, points);
    }
    path.sample.resize(points.size(), i);
    const bool isSubdivided = isBridged && bridge->reason == SampleStatus::kSubdivided;
    const bool isConverged = !isBridged && samples[i].status == SampleStatus::kConverged;
    path.unconverged.resize(points.size(), !(isSubdivided || isConverged));
  }
  measure(surface.mesh(), path.line);
}

void appendGeodesic(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                    StripWorkspace& workspace, Array<SurfacePoint>& points) {
  if (appendLocalPath(geometry, from, to, workspace, points)) return;
  const SurfacePath shortest = shortestPath(geometry, from, to);
  points.insert(points.end(), shortest.points.begin() + 1, shortest.points.end());
}

}  // namespace karcher

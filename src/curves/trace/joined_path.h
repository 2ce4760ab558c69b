#pragma once

#include "curves/trace/bridge.h"
#include "curves/trace/edge_crossings.h"

namespace karcher {

/// What lies between consecutive samples.
enum class CurveGeometry {
  kGeodesic,  ///< the locally shortest path
  kExact,     ///< the curve's own crossings of edges (edge_crossings.h)
};

/// A path through the samples. Consecutive samples are joined by geodesics or by the curve's
/// crossings, and along the bridges where there are any.
struct JoinedPath {
  SurfacePath line;
  /// Per point the number of the sample that its piece leads to.
  Array<int> sample;
  /// Per point whether its piece lies on a bridge or leads to a sample that is not converged.
  Array<uint8_t> unconverged;
};

/// With `crossings` exact; geodesics join what those leave open. Writes to `path`, whose memory is
/// used again.
void joinSamples(Surface& surface, const Array<CurveSample>& samples, const Array<Bridge>& bridges,
                 EdgeCrossings* crossings, StripWorkspace& workspace, JoinedPath& path);
JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples,
                       const Array<Bridge>& bridges = {}, EdgeCrossings* crossings = nullptr);

/// Appends the geodesic between two samples that lie near each other as a rule: its points after
/// `from`. The samples must lie on one component.
void appendGeodesic(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                    StripWorkspace& workspace, Array<SurfacePoint>& points);

}  // namespace karcher

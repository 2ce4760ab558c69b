#pragma once

#include "curves/trace/bridge.h"
#include "curves/trace/edge_crossings.h"

namespace karcher {

/// The connection between consecutive samples.
enum class CurveGeometry {
  kGeodesic,  ///< a locally shortest path
  kExact,     ///< the curve's own crossings of edges (edge_crossings.h)
};

/// A path through the samples. Geodesics, the curve's own crossings or bridges join consecutive
/// samples.
struct JoinedPath {
  SurfacePath line;
  /// For each point, the index of the sample to which its piece of the path leads.
  Array<int> sample;
  /// For each point, whether its piece of the path lies on a bridge over a gap, or leads to a
  /// sample that is not converged. Bridges with the reason kSubdivided do not count.
  Array<uint8_t> unconverged;
};

/// Writes to `path`. With `crossings` the path follows the curve's own crossings, and geodesics
/// close the remaining gaps.
void joinSamples(Surface& surface, const Array<CurveSample>& samples, const Array<Bridge>& bridges,
                 EdgeCrossings* crossings, StripWorkspace& workspace, JoinedPath& path);
JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples,
                       const Array<Bridge>& bridges = {}, EdgeCrossings* crossings = nullptr);

/// Appends the geodesic between two samples on one component, without its first point `from`. The
/// samples are usually near each other.
void appendGeodesic(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                    StripWorkspace& workspace, Array<SurfacePoint>& points);

}  // namespace karcher

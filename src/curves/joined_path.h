#pragma once

#include "curves/bridge.h"

namespace karcher {

/// A polyline on the surface through the samples: consecutive points lie in one face. Points of
/// consecutive samples are joined by geodesics, and along the bridges where there are any.
struct JoinedPath {
  Array<SurfacePoint> points;
  /// Per point the number of the sample that its piece leads to.
  Array<int> sample;
  /// Per point whether its piece lies on a bridge or leads to a sample that is not converged.
  Array<uint8_t> unconverged;
  double length = 0;
};

JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples,
                       const Array<Bridge>& bridges = {});

}  // namespace karcher

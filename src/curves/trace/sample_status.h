#pragma once

#include "rcm/search_end.h"

namespace karcher {

/// The status of a curve's point: a center of mass, the end of a search that found none
/// (rcm/search_end.h), or a point of a bridge (bridge.h).
enum class SampleStatus {
  kConverged,
  kIndefinite,
  kBoundary,
  kNoProgress,
  kLimit,
  kJump,     ///< the reason of a bridge: the curve jumps from one local minimum to another
  kBridged,  ///< the sample lies on a bridge
  /// the sample lies on a piece that is a subdivision curve, since it crosses a larger face
  /// (Curve::findSubdivided); also the reason of a bridge
  kSubdivided,
};
inline constexpr SampleStatus kLastSampleStatus = SampleStatus::kSubdivided;

/// The sample status for a search that ended with `ofSearch`.
SampleStatus sampleStatus(Status ofSearch);

/// The name of a status in reports, such as "converged".
const char* statusName(SampleStatus status);

}  // namespace karcher

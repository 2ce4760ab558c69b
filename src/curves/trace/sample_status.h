#pragma once

#include "rcm/center_of_mass.h"

namespace karcher {

/// What a point of a curve is: a center of mass, the end of a search that found none
/// (rcm/center_of_mass.h), or a point of a bridge (bridge.h).
enum class SampleStatus {
  kConverged,
  kIndefinite,
  kBoundary,
  kNoProgress,
  kLimit,
  kJump,     ///< why an interval was bridged: from one local minimum to another
  kBridged,  ///< the sample lies on a bridge
  /// The sample lies on a piece that is its own subdivision, as it crosses faces larger than itself
  /// (Curve::findSubdivided); also why an interval is bridged.
  kSubdivided,
};
inline constexpr SampleStatus kLastSampleStatus = SampleStatus::kSubdivided;

/// The status of a sample whose search ended with `ofSearch`.
SampleStatus sampleStatus(Status ofSearch);

/// The name of a status in reports: "converged".
const char* statusName(SampleStatus status);

}  // namespace karcher

#pragma once

#include "curves/spec/segment_basis.h"
#include "curves/trace/segment.h"

namespace karcher {

/// The longest step, in mean edges, that is no jump: a jump stays longer however fine the division
/// of t is. Much shorter steps occur at every edge, where the interpolated field is discontinuous.
inline constexpr double kLongestStep = 0.05;

/// A step between two samples at which the curve of centers of mass breaks.
struct Jump {
  int step = 0;  ///< the index of the step's first sample
  SampleStatus reason = SampleStatus::kJump;
};

inline bool isConverged(const CurveSample& sample) {
  return sample.status == SampleStatus::kConverged;
}

/// Writes to `jumps` the steps between converged samples that break, in order. Steps well inside a
/// face, or shorter than half of `kLongestStep`, need no check; the function divides others until
/// their parts are such steps. `basis` and `pointWeights` give the weights (segment_basis.h).
/// `table` has the weights at the samples and in the middles between them; it is null if a
/// tolerance placed the samples. `weights` is scratch memory.
void findJumps(FieldBlend& fields, const SegmentBasis& basis, const Array<double>& pointWeights,
               const PieceWeights* table, Method method, const Array<CurveSample>& samples,
               Array<double>& weights, Array<Jump>& jumps);

}  // namespace karcher

#pragma once

#include "curves/spec/segment_basis.h"
#include "curves/trace/segment.h"

namespace karcher {

/// The longest step, in mean edges, that is no jump: at a jump a step stays longer than this,
/// however finely t is divided. Much shorter steps occur at every edge, where the interpolated
/// field is discontinuous.
inline constexpr double kLongestStep = 0.05;

/// A step between two samples at which the curve of centers of mass breaks.
struct Jump {
  int step = 0;  ///< the index of the step's first sample
  SampleStatus reason = SampleStatus::kJump;
};

inline bool isConverged(const CurveSample& sample) {
  return sample.status == SampleStatus::kConverged;
}

/// Writes to `jumps`, in order, the steps between converged samples at which the curve breaks. The
/// curve is continuous at a step shorter than half of `kLongestStep`. It is also continuous if the
/// weights in the middle of the step prove this, which they can do well inside a face and across
/// one edge. The function divides all other steps. `basis` and `pointWeights` give the weights
/// (segment_basis.h). `table` has the weights at the samples and in the middles between them; it is
/// null if a tolerance placed the samples. `weights` is scratch memory.
void findJumps(FieldBlend& fields, const SegmentBasis& basis, const Array<double>& pointWeights,
               const PieceWeights* table, Method method, const Array<CurveSample>& samples,
               Array<double>& weights, Array<Jump>& jumps);

}  // namespace karcher

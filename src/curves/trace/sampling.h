#pragma once

#include "curves/trace/segment.h"
#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Samples as dense as a tolerance asks for.
namespace karcher {

/// Throws Error kBadArgument for a tolerance that is not from 1e-7 to 1.
void checkTolerance(double tolerance);

/// Scratch memory; reuse one to spare the allocations.
struct SamplingWorkspace {
  Array<double> weights;
  SurfacePath path;
  StripWorkspace strip;
};

/// Samples of a segment by bisection of t, until between two neighbouring ones the curve lies
/// within the tolerance, as a part of the bounding box's diagonal, of the geodesic that joins them.
/// Where the curve jumps at an edge of the mesh (kLongestStep in jumps.h), samples come as near to
/// the jump as the tolerance needs and a geodesic leads over it. The curve is evaluated 12 to 256
/// times between two samples, three times for each face that the geodesic crosses, and more often
/// where it moves fast or between faces without a common edge; the largest change between two
/// evaluations counts as deviation too. This is no proof: a basis that goes out and back between
/// two evaluations is missed. In tests no curve exceeded a tolerance of 1e-3 or 1e-4, and one of
/// fifty exceeded 1e-5.
///
/// There is a sample at each of the `nodes` (segment_basis.h). The search for these and for the
/// ends starts as in `traceSegment`. Where converged samples meet others, the border between them
/// is found to 2^-11 of the segment or finer. Intervals are not divided further once there are
/// 100,000 samples. Written to `samples`, whose memory is used again.
void traceAdaptively(SegmentFields& fields, const BasisWriter& basis, const Array<double>& nodes,
                     Method method, double tolerance, SamplingWorkspace& workspace,
                     Array<CurveSample>& samples);

}  // namespace karcher

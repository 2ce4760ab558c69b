#pragma once

#include "curves/trace/segment.h"
#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"

/// Samples of a curve to a tolerance.
namespace karcher {

/// Throws Error kBadArgument for a tolerance outside 1e-7 to 1.
void checkTolerance(double tolerance);

/// Reusable scratch memory.
struct SamplingWorkspace {
  Array<double> weights;
  SurfacePath path;
  StripWorkspace strip;
};

/// Samples of a segment by bisection of t. The bisection stops when the curve between two
/// neighbouring samples deviates from the geodesic that joins them by no more than the tolerance,
/// which is relative to the bounding box's diagonal. If the curve jumps at an edge of the mesh
/// (kLongestStep in jumps.h), samples approach the jump as closely as the tolerance needs, and a
/// geodesic crosses it. Between two samples the curve is evaluated 12 to 256 times: three times for
/// each face that the geodesic crosses, and more often where the curve moves fast or passes between
/// faces without a common edge. The largest change between two evaluations counts as deviation,
/// too. This is no proof, since the basis may make an excursion between two evaluations. In tests
/// no curve exceeded a tolerance of 1e-3 or 1e-4, and one curve in fifty exceeded 1e-5.
///
/// There is a sample at each of the `nodes` (segment_basis.h). At the nodes and at the ends, the
/// search starts as in `traceSegment`. The border of a stretch without converged samples is exact
/// to 2^-11 of the segment or finer. The bisection ends at 100,000 samples. Writes to `samples`.
void traceAdaptively(SegmentFields& fields, const BasisWriter& basis, const Array<double>& nodes,
                     Method method, double tolerance, SamplingWorkspace& workspace,
                     Array<CurveSample>& samples);

}  // namespace karcher

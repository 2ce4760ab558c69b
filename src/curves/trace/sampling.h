#pragma once

#include "curves/trace/segment.h"

/// As many samples as a curve needs.
namespace karcher {

/// Throws Error kBadArgument for a tolerance that is not from 1e-7 to 1.
void checkTolerance(double tolerance);

/// Samples of a segment by bisection of t, until between two neighbouring ones the curve lies
/// within the tolerance, as a part of the bounding box's diagonal, of the geodesic that joins them.
/// Where the curve jumps at an edge of the mesh (kLongestStep in bridge.h), samples come as near to
/// the jump as the tolerance needs and a geodesic leads over it. The curve is looked at 12 to 256
/// times between two samples, three times for each face that the geodesic crosses, and more often
/// where it goes fast or from face to face without a common edge; its largest change between two
/// looks counts as deviation too. That is no proof: a basis that goes out and back between two
/// looks is missed. In tests no curve was off by more than a tolerance of 1e-3 or 1e-4, at 1e-5 one
/// of fifty was.
///
/// There is a sample at each of the `nodes` (segment_basis.h). They and the ends are found as
/// `traceSegment` finds the ends. Where some samples are converged and others not, the border
/// between them is found to 2^-11 of the segment or finer. Intervals are divided no further when
/// there are 100,000 samples.
Array<CurveSample> traceAdaptively(SegmentFields& fields, const Basis& basis,
                                   const Array<double>& nodes, Method method, double tolerance);

}  // namespace karcher

#pragma once

#include "curves/segment.h"

/// As many samples as a curve needs.
namespace karcher {

/// The tolerance that a caller gets who asks for adaptive samples without naming one.
inline constexpr double kDefaultTolerance = 1e-4;

/// Throws Error kBadArgument for a tolerance that is not from 1e-7 to 1.
void checkTolerance(double tolerance);

/// Samples of a segment by bisection of t, until each quarter of an interval lies within the
/// tolerance, as a part of the bounding box's diagonal, of the geodesic between the interval's
/// ends. The ends are found as `traceSegment` finds them. Where some samples are converged and
/// others not, the border between them is found to 2^-11 of the segment or finer.
Array<CurveSample> traceAdaptively(SegmentFields& fields, const Basis& basis, Method method,
                                   double tolerance);

}  // namespace karcher

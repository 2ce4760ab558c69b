#pragma once

#include "curves/trace/segment.h"

namespace karcher {

/// Improves the samples of a segment that has a gap or a jump. The samples were traced with
/// `table`. If control points lie far apart, one parameter may have several local minima. A search
/// that starts at the last sample stays with the minimum of this sample until the minimum vanishes.
/// This function also searches from the segment's end to its start, and takes the minimum with the
/// lower energy at each sample. So the curve is the same in both directions, and changes from one
/// minimum to another where both have the same energy. `back` is scratch memory.
void takeBestBranches(SegmentFields& fields, const WeightTable& table, Method method,
                      Array<CurveSample>& samples, Array<CurveSample>& back);

}  // namespace karcher

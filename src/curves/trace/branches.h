#pragma once

#include "curves/trace/segment.h"

namespace karcher {

/// Improves the samples of a segment that were traced with a table and have a gap or a jump. If
/// control points lie far apart, one parameter may have several local minima, and a search that
/// starts at the last sample stays with its minimum until that minimum vanishes. This function also
/// searches from the segment's end to its start, and takes the minimum with the lower energy at
/// each sample. So the curve is the same in both directions, and changes from one minimum to
/// another where both have the same energy. `back` is scratch memory.
void takeBestBranches(SegmentFields& fields, const WeightTable& table, Method method,
                      Array<CurveSample>& samples, Array<CurveSample>& back);

}  // namespace karcher

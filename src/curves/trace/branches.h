#pragma once

#include "curves/trace/segment.h"

namespace karcher {

/// For a segment whose trace broke: where control points lie far apart, there may be several local
/// minima over one parameter, and a search that goes on from sample to sample stays at its own
/// until it ends. Searches once more from the segment's end to its start, and takes at each sample
/// the minimum of lower energy: the same curve in both directions, which changes from one minimum
/// to another where they are equally good.
void takeBestBranches(SegmentFields& fields, const Basis& basis, Method method,
                      Array<CurveSample>& samples);

}  // namespace karcher

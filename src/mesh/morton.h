#pragma once

#include "mesh/types.h"

/// Order along a Morton (Z-order) curve, which brings neighbours in space together in memory.
namespace karcher {

/// Sorts `vertices`, numbers of entries of `positions` (all finite), by the Morton codes of their
/// positions, with 21 bits for each axis of their common bounding cube. Entries of equal position
/// follow one another, the smallest number first.
Array<int> mortonOrder(const Array<Vec3>& positions, Array<int> vertices);

}  // namespace karcher

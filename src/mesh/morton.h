#pragma once

#include "mesh/types.h"

/// The order along a Morton (Z-order) curve. It brings neighbours in space together in memory.
namespace karcher {

/// Sorts `vertices`, which are indices of finite `positions`, by Morton codes with 21 bits for each
/// axis of their common bounding cube. Vertices at the same position follow one another, the
/// smallest index first.
Array<int> mortonOrder(const Array<Vec3>& positions, Array<int> vertices);

}  // namespace karcher

#pragma once

#include "mesh/types.h"

namespace karcher {

/// Checks the positions of a mesh, and that lengths multiplied a few times stay doubles: no
/// coordinate beyond 1e30, and a mesh that is not a single point at least 1e-30 wide. Throws Error
/// kNotFinite, kBadArgument.
void checkPositions(const Array<Vec3>& positions);

}  // namespace karcher

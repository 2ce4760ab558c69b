#pragma once

#include "mesh/types.h"

namespace karcher {

/// Checks the positions of a mesh, or those of some vertices, and that lengths multiplied a few
/// times stay doubles: no coordinate beyond 1e30, and a mesh that is not a single point at least
/// 1e-30 wide. Returns the length of the diagonal of the box around them. Throws Error kNotFinite,
/// kBadArgument.
double checkPositions(const Array<Vec3>& positions, const Array<int>* vertices = nullptr);

/// Checks a place beside a mesh as `checkPositions` does. Throws Error kNotFinite, kBadArgument.
void checkPlace(const Vec3& place);

/// The middle of all; 0 without any.
Vec3 middleOf(const Array<Vec3>& positions);

/// Twice the largest distance of a position from the middle of all; 0 without any.
double extentOf(const Array<Vec3>& positions);

}  // namespace karcher

#pragma once

#include "mesh/types.h"

namespace karcher {

/// Checks the positions of a mesh, or of some of its vertices, so that products of a few lengths
/// neither overflow nor underflow. Coordinates must be within 1e30, and the mesh must be a single
/// point or at least 1e-30 wide. Returns the diagonal of the bounding box. Throws Error kNotFinite,
/// kBadArgument.
double checkPositions(const Array<Vec3>& positions, const Array<int>* vertices = nullptr);

/// Checks a point of space with the limits of `checkPositions` for coordinates. Throws Error
/// kNotFinite, kBadArgument.
void checkPlace(const Vec3& place);

/// Twice the largest distance of a position from the mean of all positions; 0 without positions.
double extentOf(const Array<Vec3>& positions);

}  // namespace karcher

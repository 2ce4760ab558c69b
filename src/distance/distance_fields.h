#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The distances of all vertices from each of several points, one array for each point: exact, or
/// with a tolerance (window_distance.h); kInfinity where no path leads. The given number of threads
/// share the points, each with its own solver. The number of threads does not change a bit of the
/// distances. Throws what WindowDistance throws for the first point for which it throws, and Error
/// kBadArgument for fewer than one thread.
Array<Array<double>> distanceFields(const Geometry& geometry, const Array<SurfacePoint>& points,
                                    double tolerance = 0, int threads = 1);

}  // namespace karcher

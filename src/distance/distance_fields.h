#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The distances of all vertices from each of several points, one array for each point; kInfinity
/// where no path leads. They are exact or have a tolerance (window_distance.h). The given number of
/// threads share the points, each with its own solver. No bit of the distances depends on the
/// number of threads. Throws Error kBadArgument for fewer than one thread. If WindowDistance throws
/// for several points, throws the error of the first of these points.
Array<Array<double>> distanceFields(const Geometry& geometry, const Array<SurfacePoint>& points,
                                    double tolerance = 0, int threads = 1);

}  // namespace karcher

#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The distances of all vertices from each of several points, one array a point: exact, or with a
/// tolerance (window_distance.h); kInfinity where no path leads. The points are shared out among so
/// many threads, each with a solver of its own. Distances are the same to the last bit in however
/// many. Throws what WindowDistance throws, of the first point where it does, and Error
/// kBadArgument for fewer than one thread.
Array<Array<double>> distanceFields(const Geometry& geometry, const Array<SurfacePoint>& points,
                                    double tolerance = 0, int threads = 1);

}  // namespace karcher

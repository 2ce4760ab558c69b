#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The exact distances of points from a source by one search; kInfinity for unreachable ones.
/// `likely` is an estimate of the largest distance. If points are farther away, the search goes on
/// until it reaches them. Throws what `WindowDistance` throws.
Array<double> exactLengths(const Geometry& geometry, const SurfacePoint& source,
                           const Array<SurfacePoint>& points, double likely);

}  // namespace karcher

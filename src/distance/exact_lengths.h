#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The exact distances of points from a source by one search; kInfinity for unreachable ones.
/// `likely` is a guess at the largest: points beyond it cost a continued search. Throws as
/// `WindowDistance` does.
Array<double> exactLengths(const Geometry& geometry, const SurfacePoint& source,
                           const Array<SurfacePoint>& points, double likely);

}  // namespace karcher

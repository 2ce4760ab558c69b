#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The exact distances of points from a source, all by one search; kInfinity where no path leads.
/// `likely` is how far they may be: points beyond it cost a second search that goes on from there.
/// Throws as `WindowDistance` does.
Array<double> exactLengths(const Geometry& geometry, const SurfacePoint& source,
                           const Array<SurfacePoint>& points, double likely);

}  // namespace karcher

#pragma once

#include "distance/window_distance.h"
#include "intrinsic/geometry.h"

namespace karcher {

/// The exact distances of points from a source by one search; kInfinity for unreachable ones.
/// `likely` is an estimate of the largest distance. If points are farther away, the search goes on
/// until it reaches them. Throws what `WindowDistance` throws.
Array<double> exactLengths(const Geometry& geometry, const SurfacePoint& source,
                           const Array<SurfacePoint>& points, double likely);

/// Writes the length of the shortest path that the search has found to each point. The path comes
/// from an image in the point's face, or over a corner of this face. The solver must keep the
/// images in these faces (WindowDistance::keepImagesIn).
void writeLengths(const Geometry& geometry, const WindowDistance& distance,
                  const Array<SurfacePoint>& points, Array<double>& lengths);

}  // namespace karcher

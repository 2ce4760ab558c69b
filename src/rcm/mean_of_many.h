#pragma once

#include <optional>

#include "rcm/mean.h"

/// The center of mass of many points without a field of each: K and its gradient are found at the
/// places where the search stands (one_source_energy.h), so that the work hardly grows with the
/// points.
///
/// K is compared at some of the points, evenly by weight. From the lowest few descents (BFGS) go on
/// by the distances of the options' solver. Where the best of them ends, K by exact distances is
/// compared on the circle that `converged` is told by (energy_ring.h), at as few places as foretell
/// those between them, and a quadratic leads to the minimum.
namespace karcher {

/// From so many different points on this is faster than fields over the whole surface.
inline constexpr int kMany = 64;

/// Whether the mean of these points can be found so: there are many, no weight is below 0,
/// distances are the fast or the exact ones of kKarcher, and nobody looks for other minima.
bool isOfMany(const Array<SurfacePoint>& points, const Array<double>& weights,
              const MeanOptions& options);

/// The center of points on one component with weights that sum to 1, held to exact distances where
/// `isChecked`; its energy is that of exact distances then. None where the search ends at a
/// boundary, of which fields tell more. The order of the points makes no difference.
std::optional<Mean> meanOfMany(Surface& surface, const Array<SurfacePoint>& points,
                               const Array<double>& weights, const MeanOptions& options);

}  // namespace karcher

#pragma once

#include "rcm/mean.h"
#include "rcm/one_source_energy.h"

/// The center of mass of many points without a field of each: K and its gradient are found at the
/// places where the search stands (one_source_energy.h), so that the work hardly grows with the
/// points.
///
/// K is compared at some of the points, evenly by weight; from the lowest a quasi-Newton descent
/// goes on by the distances of the options' solver, and ends by exact ones. There K is compared on
/// the circle that `converged` is told by.
namespace karcher {

/// From so many different points on this is the faster way on any mesh.
inline constexpr int kMany = 64;

/// Whether the mean of these points is found so: if no weight is below 0, distances are the fast or
/// the exact ones of kKarcher, nobody looks for other minima, and the points are many. A function
/// of the arguments alone.
bool isOfMany(const WeightedPoints& points, const MeanOptions& options);

/// The center, held to exact distances where `isChecked`; none where the search comes to a boundary
/// or does not end: then fields tell more. The points lie on one component; the weights sum to 1.
std::optional<Mean> meanOfMany(Surface& surface, const WeightedPoints& points,
                               const MeanOptions& options);

}  // namespace karcher

#pragma once

#include <optional>

#include "rcm/mean.h"
#include "rcm/one_source_energy.h"

/// The center of mass of many points without a field for each. K and its gradient are computed only
/// at the places of the search (one_source_energy.h), so that the work hardly grows with the number
/// of points.
///
/// K is compared at some of the points, spread evenly by weight. Descents (BFGS) start at the
/// lowest few; their distances are those of the options' solver.
namespace karcher {

/// The number of different points, near or far, from which on this is at least as fast as fields.
/// For 200 points all over 19,520 triangles with exact distances it takes 1.9 s, with fields 31 s.
inline constexpr int kMany = 64;

/// Whether the mean can be found in this way: there are at least kMany points, no weight is
/// negative, the method is kKarcher with fast or exact distances, and other minima are not
/// requested.
bool isOfMany(const Array<SurfacePoint>& points, const Array<double>& weights,
              const MeanOptions& options);

/// A minimum by the solver's distances for merged points (one_source_energy.h) on one component
/// with weights that sum to 1, and its energy. None if the search ends at a boundary, where fields
/// work better. The order of the points does not matter.
std::optional<Mean> meanOfMany(Surface& surface, const WeightedPoints& points,
                               const MeanOptions& options);

}  // namespace karcher

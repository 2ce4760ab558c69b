#pragma once

#include "rcm/mean.h"

/// The searches for the minima of K: their starts, and the choice of the mean among their results.
namespace karcher {

/// The index of the largest weight, the first if several are equal.
int firstLargest(const Array<double>& weights);

/// A center as a mean, with the fields' energy there.
Mean withEnergy(FieldBlend& fields, const Array<double>& weights, const CenterOfMass& center);

/// Inserts a minimum in ascending order of energy, after those of equal energy.
void insertByEnergy(Array<Minimum>& minima, const Minimum& minimum);

/// Sets the mean's `otherMinima` to the minima that are apart from the center and from each other.
/// Sets its `uniqueness` to kNotUnique if there are any, else to kNotLooked.
void setOtherMinima(const Geometry& geometry, const Array<Minimum>& minima, Mean& mean);

/// The mean in a blend of fields. Fields and points have separate weights, since one summed field
/// of many points has one weight. Without options.start the mean is the lowest minimum found. The
/// first search by kKarcher then starts at `shared` if present, else at the average of averages
/// (first_start.h). The first search by the paper's method starts at a control point.
Mean findMean(Surface& surface, FieldBlend& fields, const Array<double>& weights,
              const Array<SurfacePoint>& points, const Array<double>& ofPoints,
              const MeanOptions& options, const SurfacePoint* shared = nullptr);

}  // namespace karcher

#pragma once

#include "rcm/mean.h"

/// The searches for the minima of K: their starts, and the choice of the mean among their results.
namespace karcher {

/// The index of the largest weight, or of the first such weight if several are equal.
int firstLargest(const Array<double>& weights);

/// A center as a mean, with the fields' energy there.
Mean withEnergy(FieldBlend& fields, const Array<double>& weights, const SearchEnd& center);

/// Inserts a minimum in ascending order of energy, after minima of equal energy.
void insertByEnergy(Array<Minimum>& minima, const Minimum& minimum);

/// Sets the mean's `otherMinima` to the minima that are apart from the center and from each other.
/// Sets the mean's `uniqueness` to kNotUnique if there are such minima, else to kNotLooked.
void setOtherMinima(const Geometry& geometry, const Array<Minimum>& minima, Mean& mean);

/// The mean in a blend of fields. `blendWeights` are those of the fields and `pointWeights`
/// those of the points, since the fields may be a single summed field of all points. Without
/// options.start the mean is the lowest minimum found. The first search by kKarcher then starts at
/// `shared` if present, else at the average of averages (first_start.h). The first search by the
/// paper's method starts at a control point.
Mean findMean(Surface& surface, FieldBlend& fields, const Array<double>& blendWeights,
              const Array<SurfacePoint>& points, const Array<double>& pointWeights,
              const MeanOptions& options, const SurfacePoint* shared = nullptr);

}  // namespace karcher

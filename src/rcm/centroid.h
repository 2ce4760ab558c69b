#pragma once

#include "rcm/mean.h"
#include "regions/region.h"

/// Centroids of regions and of densities. The package `karcher/statistics` has the same function
/// under the same name.
namespace karcher {

/// The centroid of a region: the center of mass of its area, or of a density on it, where the
/// integral of the squared distances to all of the region has a minimum. It need not lie in the
/// region. `density` is the mass per area: a value of at least 0 for each vertex, linear in
/// triangles; without values it is 1 everywhere.
///
/// The mass of each triangle, or of its part in the region, lies at its own centroid. This is exact
/// to rounding on a plane and good to the square of the edges on smooth surfaces. The centroid is
/// the center of mass of these points, and the energy is the mean squared distance to them. The
/// options are those of centers of mass; the weights are always divided by their sum. On a large
/// mesh the check by exact distances (options.isChecked) takes most of the time.
///
/// Throws what `centerOfMass` throws (mean.h), such as kUnreachable for a region of several
/// components, and Error kBadArgument for a region without area or mass, and unless the density has
/// one value of at least 0 for each vertex.
Mean centroid(Surface& surface, const Arrangement& arrangement, const Region& region,
              const Array<double>& density = {}, MeanOptions options = {});

/// The centroid of the whole surface.
Mean centroid(Surface& surface, const Array<double>& density = {}, MeanOptions options = {});

}  // namespace karcher

#pragma once

#include "rcm/mean.h"
#include "regions/region.h"

/// Centroids of regions and of densities. The package `karcher/statistics` has the same function
/// under the same name.
namespace karcher {

/// The centroid of a region: the center of mass of its area or of a density on it. It minimizes the
/// integral of the squared distances to the points of the region, and may lie outside the region.
/// `density` is the mass per area: a value of at least 0 for each vertex, linear in triangles;
/// without values it is 1 everywhere.
///
/// The function replaces the mass of each triangle in the region, or of a triangle's part in it, by
/// a point mass at the centroid of this mass. On a plane this is exact up to rounding; on smooth
/// surfaces the error is of second order in the length of edges. The result is the center of mass
/// of these points, and its energy is the mean squared distance to them. The options are those of
/// centers of mass; the weights are always divided by their sum. On a large mesh the check by exact
/// distances (options.isChecked) takes most of the time.
///
/// Throws what `centerOfMass` throws (mean.h), such as kUnreachable for a region on several
/// components. Throws Error kBadArgument if the region has no area or mass, if the density does not
/// have one value for each vertex, or if a value is negative or not finite.
Mean centroid(Surface& surface, const Arrangement& arrangement, const Region& region,
              const Array<double>& density = {}, MeanOptions options = {});

/// The centroid of the whole surface.
Mean centroid(Surface& surface, const Array<double>& density = {}, MeanOptions options = {});

}  // namespace karcher

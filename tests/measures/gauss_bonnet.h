#pragma once

#include "regions/region.h"

namespace karcher {

/// Both sides of the Gauss-Bonnet theorem for a region, in which several corners at one vertex
/// count separately: the sum of angle defects inside and of turning angles on the boundary, and 2
/// pi times the Euler characteristic.
struct GaussBonnet {
  double curvature = 0;
  int euler = 0;
};
GaussBonnet gaussBonnet(const Geometry& geometry, const Arrangement& arrangement,
                        const Region& region);

}  // namespace karcher

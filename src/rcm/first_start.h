#pragma once

#include <optional>

#include "intrinsic/geometry.h"
#include "rcm/field_blend.h"

/// The start of the first search for a mean of few points, and bounds on the starts from which
/// other searches could find a lower mean.
namespace karcher {

/// The average of the first two points along the path between them, averaged with the third, and so
/// on: the mean itself on a plane, and near it elsewhere. It is empty if a weight is negative or no
/// path joins two of the points.
std::optional<SurfacePoint> averageOfAverages(const Geometry& geometry,
                                              const Array<SurfacePoint>& points, Weights weights);

/// The region where K may be low, for points with non-negative weights that sum to 1: the largest
/// distance in space from the points' mean in space at which the energy may be at most `energy`.
/// The energy in space is that of the mean plus the squared distance from it, and distances along
/// the surface are no shorter.
struct LowerPlaces {
  Vec3 middle = Vec3::Zero();
  double radius = 0;
};
LowerPlaces lowerPlaces(const TriangleMesh& mesh, const Array<SurfacePoint>& points,
                        Weights weights, double energy);

}  // namespace karcher

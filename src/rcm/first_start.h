#pragma once

#include <optional>

#include "intrinsic/geometry.h"
#include "rcm/field_blend.h"

/// Where the first search for a mean of few points starts, and from where others could find a lower
/// one.
namespace karcher {

/// The average of the first two points along the path between them, averaged with the third, and so
/// on: on a plane the mean itself, elsewhere near it. None where a weight is negative, or where no
/// path joins two of the points.
std::optional<SurfacePoint> averageOfAverages(const Geometry& geometry,
                                              const Array<SurfacePoint>& points, Weights weights);

/// Of points with weights, none negative, that sum to 1: how far in space a place may be from the
/// points' mean in space if the energy there is no higher than `energy`. Distances along the
/// surface are no shorter than in space, and there the energy is the mean's plus the square of the
/// distance from it.
struct LowerPlaces {
  Vec3 middle = Vec3::Zero();
  double radius = 0;
};
LowerPlaces lowerPlaces(const TriangleMesh& mesh, const Array<SurfacePoint>& points,
                        Weights weights, double energy);

}  // namespace karcher

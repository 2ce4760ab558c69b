#pragma once

#include <optional>

#include "intrinsic/geometry.h"
#include "rcm/field_blend.h"

/// For a mean of few points: the start of the first search, and a ball that contains all lower
/// means. Other searches start near this ball.
namespace karcher {

/// The weighted average of the first two points on the path between them, then the average of this
/// point and the third point, and so on. On a plane the last average is the mean; elsewhere it is
/// near the mean. The result is empty if a weight is negative, or if a search finds no path between
/// an average and the next point.
std::optional<SurfacePoint> averageOfAverages(const Geometry& geometry,
                                              const Array<SurfacePoint>& points, Weights weights);

/// The ball in space that contains all places where K is at most `energy`, for points with
/// non-negative weights that sum to 1. Its center is the points' mean in space. The reason: with
/// distances in space, K at a place is K at the mean plus the squared distance from the mean to the
/// place. Distances along the surface are no shorter than in space.
struct LowerPlaces {
  Vec3 middle = Vec3::Zero();
  double radius = 0;
};
LowerPlaces lowerPlaces(const TriangleMesh& mesh, const Array<SurfacePoint>& points,
                        Weights weights, double energy);

}  // namespace karcher

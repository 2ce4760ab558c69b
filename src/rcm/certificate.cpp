#include "rcm/certificate.h"

#include <numeric>

#include "distance/shortest_path.h"
#include "intrinsic/tangent.h"
#include "rcm/one_source_energy.h"

namespace karcher {
namespace {

/// The certificate of a point on an edge or at a vertex. It needs a path to each point, since a
/// search from one source needs a source inside a face.
Certificate byPaths(const Geometry& geometry, const WeightedPoints& points,
                    const SurfacePoint& point) {
  Certificate result;
  Vec2 sum = Vec2::Zero();
  for (int i = 0; i < points.points.count(); ++i) {
    const SurfacePath path = shortestPath(geometry, point, points.points[i]);
    result.energy += points.weights[i] * square(path.length());
    sum += points.weights[i] * logAlong(geometry, path);
  }
  result.residual = sum.norm();
  return result;
}

}  // namespace

Certificate certificateOf(const Geometry& geometry, const Array<SurfacePoint>& points,
                          Array<double> weights, bool normalize, const SurfacePoint& point) {
  if (normalize) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double& weight : weights) weight /= sum;
  }
  const WeightedPoints merged = mergedPoints(points, weights);
  if (locate(*geometry.mesh, point).simplex != Simplex::kFace) {
    return byPaths(geometry, merged, point);
  }
  const EnergyAt there = ExactOneSourceEnergy(geometry, merged).at(point);
  return {there.energy, there.step.norm()};
}

}  // namespace karcher

#include "rcm/first_start.h"

#include <algorithm>
#include <cmath>

#include "distance/find_path.h"

namespace karcher {

std::optional<SurfacePoint> averageOfAverages(const Geometry& geometry,
                                              const Array<SurfacePoint>& points, Weights weights) {
  std::optional<SurfacePoint> average;
  double sum = 0;
  FindPathWorkspace workspace;
  SurfacePath path;
  for (int i = 0; i < points.count(); ++i) {
    const double weight = weights.data()[i];
    if (weight < 0) return std::nullopt;
    if (weight == 0) continue;
    sum += weight;
    if (!average) {
      average = points[i];
      continue;
    }
    if (!findPath(geometry, *average, points[i], workspace, path)) return std::nullopt;
    average = pointAlong(*geometry.mesh, path, path.length() * weight / sum);
  }
  return average;
}

LowerPlaces lowerPlaces(const TriangleMesh& mesh, const Array<SurfacePoint>& points,
                        Weights weights, double energy) {
  LowerPlaces places;
  for (int i = 0; i < points.count(); ++i) {
    places.middle += weights.data()[i] * position(mesh, points[i]);
  }
  double least = 0;
  for (int i = 0; i < points.count(); ++i) {
    least += weights.data()[i] * (position(mesh, points[i]) - places.middle).squaredNorm();
  }
  places.radius = std::sqrt(std::max(energy - least, 0.0));
  return places;
}

}  // namespace karcher

#include "generators/random_points.h"

#include <cmath>

#include "distance/window_distance.h"

namespace karcher {

SurfacePoint randomPoint(const TriangleMesh& mesh, Random& random) {
  const int face = random.index(mesh.faceCount());
  const double s = std::sqrt(random.uniform());
  const double t = random.uniform();
  return {face, Vec3(1 - s, s * (1 - t), s * t)};
}

SurfacePoint randomPlace(const TriangleMesh& mesh, Random& random) {
  const int f = random.index(mesh.faceCount());
  const int kind = random.index(4);
  if (kind == 0) return edgePoint(3 * f + random.index(3), random.uniform(0.01, 0.99));
  if (kind == 1) return edgePoint(3 * f + random.index(3), 0);
  const double s = std::sqrt(random.uniform(0.01, 0.99));
  const double t = random.uniform(0.01, 0.99);
  return {f, Vec3(1 - s, s * (1 - t), s * t)};
}

Array<PointPair> randomPairs(const Geometry& geometry, Random& random, int count,
                             SurfacePoint (*choose)(const TriangleMesh&, Random&), double least,
                             double most) {
  const TriangleMesh& mesh = *geometry.mesh;
  WindowDistance distance(geometry);
  Array<PointPair> pairs;
  while (pairs.count() < count) {
    const SurfacePoint from = choose(mesh, random);
    distance.setSource(from);
    distance.grow(most * geometry.diagonal);
    for (int attempt = 0; attempt < 10'000; ++attempt) {
      const SurfacePoint to = choose(mesh, random);
      const double d = distance.distance(mesh.corner(to.face, 0));
      if (d < least * geometry.diagonal || d > most * geometry.diagonal) continue;
      pairs.push_back({from, to});
      break;
    }
  }
  return pairs;
}

}  // namespace karcher

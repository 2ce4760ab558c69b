#include "generators/region_drawings.h"

#include <utility>

#include "distance/find_path.h"
#include "generators/random_points.h"
#include "intrinsic/straightest.h"

namespace karcher {

Sheet::Sheet(TriangleMesh m) : mesh(std::move(m)), geometry(buildGeometry(mesh)) {}

SurfacePath chain(const Geometry& geometry, const Array<SurfacePoint>& points, bool closed) {
  FindPathWorkspace workspace;
  SurfacePath leg;
  Array<SurfacePoint> all;
  const int count = points.count();
  for (int i = 0; i < (closed ? count : count - 1); ++i) {
    if (!findPath(geometry, points[i], points[(i + 1) % count], workspace, leg)) continue;
    for (const SurfacePoint& point : leg.points) {
      if (all.empty() || !samePlace(*geometry.mesh, all.back(), point)) all.push_back(point);
    }
  }
  return pathThrough(*geometry.mesh, std::move(all));
}

SurfacePath polygonOn(const Geometry& geometry, const Array<Vec2>& corners, bool closed) {
  Array<SurfacePoint> points;
  for (const Vec2& corner : corners) {
    points.push_back(nearestPoint(*geometry.mesh, {corner.x(), corner.y(), 0}));
  }
  return chain(geometry, points, closed);
}

double surfaceArea(const Geometry& geometry) {
  double twice = 0;
  for (int f = 0; f < geometry.mesh->faceCount(); ++f) twice += doubleArea(geometry, f);
  return twice / 2;
}

Array<SurfacePath> randomDrawing(const Geometry& geometry, Random& random) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<SurfacePath> paths;
  const int count = 1 + random.index(4);
  for (int i = 0; i < count; ++i) {
    const SurfacePoint start = randomPlace(mesh, random);
    Array<SurfacePoint> points{start};
    const int corners = 3 + random.index(5);
    while (points.count() < corners) {
      const Vec2 way =
          random.uniform(0.02, 0.25) * geometry.diagonal * unitVector(random.uniform(0, 2 * kPi));
      points.push_back(traceStraightest(geometry, start, way).path.end());
      if (random.index(6) == 0) points.push_back(randomPlace(mesh, random));
      // At times the path repeats a stretch.
      if (random.index(8) == 0) points.push_back(points[random.index(points.count())]);
    }
    paths.push_back(chain(geometry, points, true));
  }
  return paths;
}

}  // namespace karcher

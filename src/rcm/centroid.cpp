#include "rcm/centroid.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/error.h"

namespace karcher {
namespace {

void checkDensity(const TriangleMesh& mesh, const Array<double>& density) {
  if (!density.empty() && density.count() != mesh.vertexCount()) {
    refuse("there are " + std::to_string(mesh.vertexCount()) + " vertices but " +
           std::to_string(density.count()) + " values of the density");
  }
  for (int v = 0; v < density.count(); ++v) {
    if (density[v] >= 0 && density[v] < kInfinity) continue;
    refuse("the density of vertex " + std::to_string(v) + " must be finite and at least 0, not " +
           inSentence(density[v]));
  }
}

/// A mass in a face and its first moment: the mass times the second and third barycentric weights
/// of its centroid.
struct Mass {
  double mass = 0;
  Vec2 moment = Vec2::Zero();
};

/// The mass of the part of a face that lies in a region, divided by twice the face's area. Each
/// side of the part adds the signed mass of the triangle between the side and the face's first
/// corner (Green's theorem).
Mass massIn(const TriangleMesh& mesh, const Arrangement& all, const Region& region, int face,
            const Array<double>& density) {
  Vec3 atCorners = Vec3::Ones();
  for (int k = 0; k < 3 && !density.empty(); ++k) atCorners[k] = density[mesh.corner(face, k)];
  const auto densityAt = [&](const Vec2& place) {
    return Vec3(1 - place.x() - place.y(), place.x(), place.y()).dot(atCorners);
  };
  Mass result;
  for (int h = all.firstOfFace[face]; h < all.firstOfFace[face + 1]; ++h) {
    if (region[all.cell(h)] == 0) continue;
    const Vec2 a = placeIn(mesh, all.added, face, all.tail[h]);
    const Vec2 b = placeIn(mesh, all.added, face, all.head(h));
    const double sum = atCorners[0] + densityAt(a) + densityAt(b);
    result.mass += cross(a, b) / 6 * sum;
    result.moment += cross(a, b) / 24 * ((densityAt(a) + sum) * a + (densityAt(b) + sum) * b);
  }
  return result;
}

}  // namespace

Mean centroid(Surface& surface, const Arrangement& arrangement, const Region& region,
              const Array<double>& density, MeanOptions options) {
  const TriangleMesh& mesh = surface.mesh();
  checkDensity(mesh, density);
  Array<SurfacePoint> points;
  Array<double> masses;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Mass part = massIn(mesh, arrangement, region, f, density);
    if (!(part.mass > 0)) continue;
    // In a sliver, rounding may lead out of the triangle.
    const double x = std::clamp(part.moment.x() / part.mass, 0.0, 1.0);
    const double y = std::clamp(part.moment.y() / part.mass, 0.0, 1 - x);
    points.push_back(clampedPoint(f, Vec3(1 - x - y, x, y)));
    masses.push_back(part.mass * doubleArea(surface.geometry(), f));
  }
  if (points.empty()) {
    refuse(std::string("the region has no ") + (density.empty() ? "area" : "mass") +
           ", so it has no centroid");
  }
  options.normalize = true;
  return centerOfMass(surface, points, masses, options);
}

Mean centroid(Surface& surface, const Array<double>& density, MeanOptions options) {
  const Arrangement whole = arrange(surface.geometry(), {});
  return centroid(surface, whole, Region(whole.cellArea.size(), 1), density, std::move(options));
}

}  // namespace karcher

#include "smooth_shapes.h"

#include "generators/plane.h"
#include "generators/sphere.h"
#include "generators/torus.h"

namespace karcher {

Array<SmoothShape> smoothShapes() {
  constexpr uint64_t kSeed = 5;
  const Vec3 halfAxes(1.4, 1, 0.7);
  constexpr double kHeight = 0.5;
  const auto ellipsoid = [halfAxes](int triangles) {
    TriangleSoup soup = relaxedSphere(triangles, kSeed);
    for (Vec3& p : soup.positions) p = halfAxes.cwiseProduct(p);
    return soup;
  };
  const auto saddle = [](int triangles) {
    TriangleSoup soup = tessellatedPlane(PlaneTessellation::kJitteredDelaunay, triangles, kSeed);
    for (Vec3& p : soup.positions) {
      const double x = 2 * p.x() - 1;
      const double y = 2 * p.y() - 1;
      p = Vec3(x, y, kHeight * (x * x - y * y));
    }
    return soup;
  };
  return {{"sphere", smoothSphere(), [](int n) { return relaxedSphere(n, kSeed); }},
          {"torus", smoothTorus(kTorusMajor, kTorusMinor),
           [](int n) { return irregularTorus(n, 1, kSeed); }},
          {"saddle", smoothSaddle(kHeight), saddle},
          {"ellipsoid", smoothEllipsoid(halfAxes), ellipsoid}};
}

}  // namespace karcher

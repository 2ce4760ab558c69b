#include "measures/plane_deviation.h"

#include <algorithm>

namespace karcher {

double planeDeviation(Surface& surface, const CurveOptions& options,
                      const Array<SurfacePoint>& points) {
  const TriangleMesh& mesh = surface.mesh();
  const Curve curve(surface, options, points);
  CurveOptions unrefined = options;
  unrefined.levels = 0;
  const Curve means(surface, unrefined, points);
  double largest = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      const Array<double> weights = means.weights(j, sample.t);
      Vec3 place = Vec3::Zero();
      for (int i = 0; i < weights.count(); ++i) {
        place += weights[i] * position(mesh, points[means.pointsOf(j)[i]]);
      }
      largest = std::max(largest, (position(mesh, sample.point) - place).norm());
    }
  }
  return largest;
}

}  // namespace karcher

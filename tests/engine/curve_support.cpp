#include "curve_support.h"

namespace karcher {

Array<SurfacePoint> pointsNear(const TriangleMesh& mesh, const Array<Vec3>& places) {
  Array<SurfacePoint> points;
  for (const Vec3& place : places) points.push_back(nearestPoint(mesh, place));
  return points;
}

CurveOptions levelsOptions(const CurveShape& shape, int samples, int levels, FieldOptions field) {
  CurveOptions options{shape, samples, field};
  options.levels = levels;
  return options;
}

double weightedSum(const Array<double>& weights, const Array<double>& values) {
  double sum = 0;
  for (int i = 0; i < weights.count(); ++i) sum += weights[i] * values[i];
  return sum;
}

}  // namespace karcher

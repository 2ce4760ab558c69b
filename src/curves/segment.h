#pragma once

#include <functional>

#include "rcm/center_of_mass.h"
#include "rcm/point_field.h"

/// One segment of a curve: the center of mass of its control points with weights that a basis
/// gives (Mancinelli, Puppo, Eq. 4).
namespace karcher {

struct CurveSample {
  double t = 0;
  SurfacePoint point;
  Status status = Status::kConverged;
};

/// From t in [0, 1] to the weights of the segment's control points, which sum to 1.
using Basis = std::function<Array<double>(double t)>;

/// Samples at t = i / (count - 1), count >= 2. The first starts at the control point of the largest
/// weight, each other where the last converged sample lies: the result depends on the fields and
/// the basis alone.
Array<CurveSample> traceSegment(Surface& surface, const Array<PointField*>& points,
                                const Basis& basis, int count, Method method);

/// The center of mass of the fields of `points`, by the search that belongs to the method.
CenterOfMass findCenter(FieldBlend& fields, const Array<double>& weights, const SurfacePoint& start,
                        Method method);

/// A polyline on the surface through the samples: consecutive points lie in one face. Points of
/// consecutive samples are joined by geodesics.
struct JoinedPath {
  Array<SurfacePoint> points;
  /// Per point the number of the sample that its piece leads to.
  Array<int> sample;
  double length = 0;
};

JoinedPath joinSamples(Surface& surface, const Array<CurveSample>& samples);

}  // namespace karcher

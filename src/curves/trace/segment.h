#pragma once

#include <functional>

#include "curves/trace/sample_status.h"
#include "rcm/point_field.h"

/// One segment of a curve: the center of mass of its control points with weights that a basis
/// gives (Mancinelli, Puppo, Eq. 4).
namespace karcher {

struct CurveSample {
  double t = 0;
  SurfacePoint point;
  SampleStatus status = SampleStatus::kConverged;
};

/// Of a segment of a curve, or an arc of a circle.
inline constexpr int kMostSamples = 100'000;

/// From t in [0, 1] to the weights of a segment's control points, which sum to 1.
using Basis = std::function<Array<double>(double t)>;

/// A basis at parameters: where they are evenly spaced, made once for all segments with it.
struct WeightTable {
  int points = 0;
  Array<double> t;
  Array<double> weights;  ///< row by row, `points` a sample

  Weights row(int sample) const {
    return {weights.data() + static_cast<ptrdiff_t>(sample) * points, static_cast<size_t>(points)};
  }
};

void append(WeightTable& table, const Basis& basis, double t);

/// At `count` >= 2 parameters, evenly spaced from 0 to 1.
WeightTable tabulate(const Basis& basis, int count);

/// At the middles between the `count` parameters.
WeightTable tabulateMiddles(const Basis& basis, int count);

/// The number of the largest weight; of several, the first.
int heaviest(Weights weights);

/// The control points of a segment with their fields, blended. What the blend knows of the faces
/// that the segment passes serves all steps of its making.
struct SegmentFields {
  SegmentFields(Surface& surface, const Array<PointField*>& ofPoints)
      : points(ofPoints), blend(surface.geometry(), controlFields(ofPoints)) {}

  /// Those of another segment, in the memory that is there.
  void setPoints(const Array<PointField*>& ofPoints);

  Array<PointField*> points;
  FieldBlend blend;
  Array<ControlField*> fields;  ///< scratch
};

/// Where a search for a center of mass starts once more if it failed: at control points of positive
/// weight, the heaviest first, which at the ends of a segment has been tried. Newton's method,
/// which is the paper's, stops at once where the Hessian is not positive definite, and tries them
/// all; our walk goes on there, and tries the heaviest alone.
Array<int> restarts(Weights weights, Method method, bool isEnd);

/// One sample a row of the table. The search for the first and the last starts at the control point
/// of the largest weight, for each other where the last converged sample lies, and again at the
/// control points of `restarts` where this fails: the result depends on the fields and the weights
/// alone, and the end of one segment is the start of the next. The result takes the memory of
/// `samples`.
Array<CurveSample> traceSegment(SegmentFields& fields, const WeightTable& table, Method method,
                                Array<CurveSample> samples = {});

/// The center of mass of the fields of `points`, by the search that belongs to the method.
CenterOfMass findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                        Method method);

}  // namespace karcher

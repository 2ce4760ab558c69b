#pragma once

#include <functional>

#include "curves/trace/sample_status.h"
#include "rcm/center_search.h"
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

/// The same, written to an array whose memory is used again.
using BasisWriter = std::function<void(double t, Array<double>& weights)>;

/// A basis at parameters: where they are evenly spaced, made once for all segments with it.
struct WeightTable {
  int points = 0;
  Array<double> t;
  Array<double> weights;  ///< row by row, `points` a sample

  Weights row(int sample) const {
    return {weights.data() + static_cast<ptrdiff_t>(sample) * points, static_cast<size_t>(points)};
  }
};

/// The weights at a piece's samples and in the middles between them.
struct PieceWeights {
  WeightTable samples;
  WeightTable middles;
};

void append(WeightTable& table, double t, const Array<double>& weights);

/// At `count` >= 2 parameters, evenly spaced from 0 to 1.
WeightTable tabulate(const Basis& basis, int count);

/// The number of the largest weight; of several, the first.
int heaviest(Weights weights);

/// The control points of a segment with their fields, blended. All stages of tracing share what the
/// blend has computed for the faces that the segment passes.
struct SegmentFields {
  SegmentFields(Surface& surface, const Array<PointField*>& ofPoints)
      : points(ofPoints), blend(surface.geometry(), controlFields(ofPoints)) {}

  /// Those of another segment, in the memory that is there.
  void setPoints(const Array<PointField*>& ofPoints);

  Array<PointField*> points;
  FieldBlend blend;
  // Scratch.
  Array<ControlField*> fields;
  Array<int> restarts;
};

/// Where a search for a center of mass that failed starts again: at control points of positive
/// weight, the heaviest first; at the ends of a segment that one has been tried. A search that goes
/// on where the Hessian is not positive definite tries the heaviest only. Written to `order`.
void findRestarts(Weights weights, Method method, bool isEnd, Array<int>& order);

/// One sample per row of the table. The search for the first and the last sample starts at the
/// control point of largest weight, each other one at the last converged sample; a search that
/// fails starts again at the control points of `findRestarts`. So the result depends only on the
/// fields and the weights, and the end of one segment is the start of the next. The result takes
/// the memory of `samples`. Backwards, the search goes from the last row to the first.
Array<CurveSample> traceSegment(SegmentFields& fields, const WeightTable& table, Method method,
                                Array<CurveSample> samples = {}, bool backwards = false);

}  // namespace karcher

#pragma once

#include <functional>
#include <optional>

#include "curves/trace/sample_status.h"
#include "rcm/center_search.h"
#include "rcm/point_field.h"

/// One segment of a curve. Its points are the centers of mass of its control points, with weights
/// that a basis gives (Mancinelli, Puppo, Eq. 4).
namespace karcher {

struct CurveSample {
  double t = 0;
  SurfacePoint point;
  SampleStatus status = SampleStatus::kConverged;
};

/// The largest number of samples of a curve's segment or a circle's arc.
inline constexpr int kMostSamples = 100'000;

/// A function from t in [0, 1] to the weights of a segment's control points, which sum to 1.
using Basis = std::function<Array<double>(double t)>;

/// The same function, but it writes the weights to an existing array.
using BasisWriter = std::function<void(double t, Array<double>& weights)>;

/// The weights of a basis at given parameters. All segments with the same basis share a table of
/// evenly spaced parameters.
struct WeightTable {
  int points = 0;
  Array<double> t;
  Array<double> weights;  ///< the weights row by row, `points` for each sample

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

/// The table at `count` >= 2 parameters, evenly spaced from 0 to 1.
WeightTable tabulate(const Basis& basis, int count);

/// The index of the largest weight, the first if several are equal.
int heaviest(Weights weights);

/// The control points of a segment and the blend of their fields. All stages of tracing share the
/// blend's values in the faces that the segment passes.
struct SegmentFields {
  SegmentFields(Surface& surface, const Array<PointField*>& ofPoints)
      : points(ofPoints), blend(surface.geometry(), controlFields(ofPoints)) {}

  /// Replaces the points by those of another segment, and forgets the known ends. Keeps the memory.
  void setPoints(const Array<PointField*>& ofPoints);

  /// The known center at t, which replaces a search. It is null if t is no end, or an end without a
  /// known center.
  const SurfacePoint* known(double t) const {
    const std::optional<SurfacePoint>& end = t == 0 ? first : last;
    return (t == 0 || t == 1) && end ? &*end : nullptr;
  }

  Array<PointField*> points;
  FieldBlend blend;
  /// The known centers at both ends.
  std::optional<SurfacePoint> first;
  std::optional<SurfacePoint> last;
  // Scratch memory.
  Array<ControlField*> fields;
  Array<int> restarts;
};

/// Writes to `order` the control points at which a failed search for a center of mass restarts: the
/// points of positive weight, the heaviest first. If the method goes on where the Hessian is not
/// positive definite, only the heaviest point is tried. At an end of a segment the heaviest point
/// is omitted, since the search began there.
void findRestarts(Weights weights, Method method, bool isEnd, Array<int>& order);

/// One sample for each row of the table. A known center at an end needs no search. Otherwise the
/// search for the first and the last sample starts at the control point of largest weight. Each
/// other search starts at the last converged sample. A failed search starts again at the control
/// points of `findRestarts`. So the result depends only on the fields and the weights, and the end
/// of one segment is the start of the next. If `backwards`, the search goes from the last row to
/// the first. The result reuses the memory of `samples`.
Array<CurveSample> traceSegment(SegmentFields& fields, const WeightTable& table, Method method,
                                Array<CurveSample> samples = {}, bool backwards = false);

}  // namespace karcher

#include "curves/segment.h"

#include <algorithm>

namespace karcher {

CenterOfMass findCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                        Method method) {
  return method == Method::kPaper ? newtonCenter(fields, weights, start)
                                  : walkToCenter(fields, weights, start);
}

int heaviest(Weights weights) {
  // Weights that should be equal may differ by rounding.
  constexpr double kEqual = 1e-9;
  const double most = *std::max_element(weights.begin(), weights.end());
  int i = 0;
  while (weights.data()[i] < most - kEqual) ++i;
  return i;
}

namespace {

void append(WeightTable& table, const Basis& basis, double t) {
  const Array<double> weights = basis(t);
  table.t.push_back(t);
  table.points = weights.count();
  table.weights.insert(table.weights.end(), weights.begin(), weights.end());
}

}  // namespace

WeightTable tabulate(const Basis& basis, int count) {
  WeightTable table;
  for (int i = 0; i < count; ++i) append(table, basis, static_cast<double>(i) / (count - 1));
  return table;
}

WeightTable tabulateMiddles(const Basis& basis, int count) {
  WeightTable table;
  for (int i = 0; i + 1 < count; ++i) append(table, basis, (i + 0.5) / (count - 1));
  return table;
}

Array<CurveSample> traceSegment(SegmentFields& fields, const WeightTable& table, Method method) {
  const Array<PointField*>& points = fields.points;
  Array<CurveSample> samples(table.t.size());
  SurfacePoint start;
  for (int i = 0; i < samples.count(); ++i) {
    // The ends are found from their control points alone: as the segments find them that meet
    // there.
    const bool isEnd = i == 0 || i == samples.count() - 1;
    if (isEnd) start = points[heaviest(table.row(i))]->point();
    CenterOfMass center = findCenter(fields.blend, table.row(i), start, method);
    if (center.status != Status::kConverged && !isEnd && method == Method::kKarcher) {
      center =
          findCenter(fields.blend, table.row(i), points[heaviest(table.row(i))]->point(), method);
    }
    samples[i] = {table.t[i], center.point, center.status};
    if (center.status == Status::kConverged) start = center.point;
  }
  return samples;
}

}  // namespace karcher

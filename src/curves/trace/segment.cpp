#include "curves/trace/segment.h"

#include <algorithm>

#include "mesh/rounding.h"

namespace karcher {

int heaviest(Weights weights) {
  const double most = *std::max_element(weights.begin(), weights.end());
  int i = 0;
  while (weights.data()[i] < most - kChainRounding) ++i;
  return i;
}

void append(WeightTable& table, double t, const Array<double>& weights) {
  table.t.push_back(t);
  table.points = weights.count();
  table.weights.insert(table.weights.end(), weights.begin(), weights.end());
}

WeightTable tabulate(const Basis& basis, int count) {
  WeightTable table;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    append(table, t, basis(t));
  }
  return table;
}

void findRestarts(Weights weights, Method method, bool isEnd, Array<int>& order) {
  order.clear();
  if (goesOnWhereIndefinite(method)) {
    if (!isEnd) order.push_back(heaviest(weights));
    return;
  }
  Array<double> left(weights.begin(), weights.end());
  for (size_t k = 0; k < left.size(); ++k) {
    const int next = heaviest({left.data(), left.size()});
    // Points of weight 0 are left out: they do not belong to the next segment, which must find the
    // same center at its start.
    if (left[next] <= kChainRounding) break;
    order.push_back(next);
    left[next] = -kInfinity;
  }
  if (isEnd) order.erase(order.begin());
}

void SegmentFields::setPoints(const Array<PointField*>& ofPoints) {
  points = ofPoints;
  fields.clear();
  for (PointField* point : points) fields.push_back(&point->field());
  blend.setFields(fields);
  first.reset();
  last.reset();
}

Array<CurveSample> traceSegment(SegmentFields& fields, const WeightTable& table, Method method,
                                Array<CurveSample> samples, bool backwards) {
  const Array<PointField*>& points = fields.points;
  samples.assign(table.t.size(), {});
  const SurfacePoint* start = nullptr;
  const int last = samples.count() - 1;
  for (int k = 0; k <= last; ++k) {
    const int i = backwards ? last - k : k;
    CurveSample& sample = samples[i];
    sample.t = table.t[i];
    // The search at an end starts at a control point, not at the last sample, so that adjacent
    // segments find the same point.
    const bool isEnd = i == 0 || i == last;
    if (const SurfacePoint* known = fields.known(sample.t)) {
      sample = {sample.t, *known};
      start = &sample.point;
      continue;
    }
    if (isEnd) start = &points[heaviest(table.row(i))]->point();
    SearchEnd center = findCenter(fields.blend, table.row(i), *start, method);
    if (center.status != Status::kConverged) {
      findRestarts(table.row(i), method, isEnd, fields.restarts);
      for (const int point : fields.restarts) {
        center = findCenter(fields.blend, table.row(i), points[point]->point(), method);
        if (center.status == Status::kConverged) break;
      }
    }
    sample.point = center.point;
    sample.status = sampleStatus(center.status);
    if (center.status == Status::kConverged) start = &sample.point;
  }
  return samples;
}

}  // namespace karcher

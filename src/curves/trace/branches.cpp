#include "curves/trace/branches.h"

#include <algorithm>

namespace karcher {

void takeBestBranches(SegmentFields& fields, const Basis& basis, Method method,
                      Array<CurveSample>& samples) {
  WeightTable table;
  for (const CurveSample& sample : samples) append(table, basis, sample.t);
  WeightTable backwards;
  for (int i = samples.count() - 1; i >= 0; --i) append(backwards, basis, samples[i].t);

  const Array<CurveSample> forth = traceSegment(fields, table, method);
  Array<CurveSample> back = traceSegment(fields, backwards, method);
  std::reverse(back.begin(), back.end());
  for (int i = 0; i < samples.count(); ++i) {
    const auto energy = [&](const CurveSample& sample) {
      return sample.status == SampleStatus::kConverged
                 ? fields.blend.energy(sample.point, table.row(i))
                 : kInfinity;
    };
    samples[i] = energy(back[i]) < energy(forth[i]) ? back[i] : forth[i];
  }
}

}  // namespace karcher

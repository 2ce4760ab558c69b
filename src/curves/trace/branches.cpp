#include "curves/trace/branches.h"

#include <utility>

namespace karcher {

void takeBestBranches(SegmentFields& fields, const WeightTable& table, Method method,
                      Array<CurveSample>& samples, Array<CurveSample>& back) {
  back = traceSegment(fields, table, method, std::move(back), true);
  for (int i = 0; i < samples.count(); ++i) {
    const auto energy = [&](const CurveSample& sample) {
      return sample.status == SampleStatus::kConverged
                 ? fields.blend.energy(sample.point, table.row(i))
                 : kInfinity;
    };
    if (energy(back[i]) < energy(samples[i])) samples[i] = back[i];
  }
}

}  // namespace karcher

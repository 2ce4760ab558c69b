#include <gtest/gtest.h>

#include "curves/spec/bases.h"
#include "curves/trace/segment.h"
#include "generators/random_points.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

TEST(SegmentRestart, ASampleIsLostOnlyIfEveryStartFails) {
  // Points spread over the sphere: too far apart for a center of mass at some samples.
  constexpr int kSegments = 40;
  Surface surface(meshOf(icosphere(6)));
  const TriangleMesh& mesh = surface.mesh();
  const WeightTable table = tabulate(uniformCubicBasis, 17);
  const FieldOptions options{Method::kPaper, Solver::kExact};
  Random random(44);
  int lost = 0;
  int converged = 0;
  for (int j = 0; j < kSegments; ++j) {
    Array<std::unique_ptr<PointField>> made;
    Array<PointField*> points;
    for (int k = 0; k < 4; ++k) {
      made.push_back(std::make_unique<PointField>(surface, options));
      made[k]->setPoint(randomPoint(mesh, random));
      points.push_back(made[k].get());
    }
    SegmentFields fields(surface, points);
    const Array<CurveSample> samples = traceSegment(fields, table, options.method);
    for (int i = 0; i < samples.count(); ++i) {
      if (samples[i].status == SampleStatus::kConverged) {
        ++converged;
        continue;
      }
      ++lost;
      for (int k = 0; k < 4; ++k) {
        if (table.row(i)[static_cast<size_t>(k)] < 1e-9) continue;
        const SearchEnd center =
            findCenter(fields.blend, table.row(i), points[k]->point(), options.method);
        EXPECT_NE(center.status, Status::kConverged)
            << "seed 44, segment " << j << ", sample " << i << ", point " << k;
      }
    }
  }
  EXPECT_GT(lost, 0);
  EXPECT_GT(converged, 0);
}

TEST(SegmentRestart, BeginsAtTheHeaviestUntriedPoint) {
  const Array<double> weights{0.2, 0.5, 0.3, 0, -1e-3};
  const auto restarts = [&](Method method, bool isEnd) {
    Array<int> order{7};
    findRestarts({weights.data(), weights.size()}, method, isEnd, order);
    return order;
  };
  EXPECT_EQ(restarts(Method::kPaper, false), (Array<int>{1, 2, 0}));
  EXPECT_EQ(restarts(Method::kPaper, true), (Array<int>{2, 0}));
  EXPECT_EQ(restarts(Method::kKarcher, false), (Array<int>{1}));
  EXPECT_EQ(restarts(Method::kKarcher, true), (Array<int>{}));
}

}  // namespace
}  // namespace karcher

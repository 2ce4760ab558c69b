#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "curve_support.h"
#include "distance/shortest_path.h"
#include "generators/random_points.h"
#include "intrinsic/surface_path.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

/// The center of mass of two points with weights 1 - w and w lies on their shortest path, at the
/// part w. (`npm run study -- two_points` measures it on larger meshes.)
namespace karcher {
namespace {

constexpr int kWeights = 21;

struct Outcome {
  int samples = 0;
  int converged = 0;
  double median = 0;  ///< the median distance of converged samples from the truth, in mean edges
};

Outcome measure(Surface& surface, const Array<PointPair>& pairs, const FieldOptions& options) {
  const Geometry& geometry = surface.geometry();
  const TriangleMesh& mesh = surface.mesh();
  const WeightTable table = tabulate([](double t) { return Array<double>{1 - t, t}; }, kWeights);
  PointField from(surface, options);
  PointField to(surface, options);
  Outcome outcome;
  Array<double> errors;
  for (const PointPair& pair : pairs) {
    const SurfacePath path = shortestPath(geometry, pair.from, pair.to);
    from.setPoint(pair.from);
    to.setPoint(pair.to);
    SegmentFields fields(surface, {&from, &to});
    for (const CurveSample& sample : traceSegment(fields, table, options.method)) {
      ++outcome.samples;
      const SurfacePoint& point = sample.point;
      EXPECT_TRUE(point.face >= 0 && point.face < mesh.faceCount());
      EXPECT_GE(point.bary.minCoeff(), 0);
      EXPECT_NEAR(point.bary.sum(), 1, 1e-12);
      if (sample.status != SampleStatus::kConverged) continue;
      ++outcome.converged;
      const SurfacePoint truth = pointAlong(mesh, path, sample.t * path.length());
      errors.push_back((position(mesh, point) - position(mesh, truth)).norm());
    }
  }
  std::sort(errors.begin(), errors.end());
  outcome.median = errors[errors.count() / 2] / geometry.meanEdge;
  return outcome;
}

/// Returns the median of the default method's errors with exact distances.
double checkTwoPoints(const std::string& name, TriangleMesh mesh, uint64_t seed) {
  SCOPED_TRACE(name + ", seed " + std::to_string(seed));
  Surface surface(std::move(mesh));
  Random random(seed);
  const Array<PointPair> pairs =
      randomPairs(surface.geometry(), random, longRun() ? 50 : 3, randomPlace);
  const FieldOptions paperGraph{Method::kPaper, Solver::kGraph, longRun() ? 6 : 3};
  double median = 0;
  for (const FieldOptions& options : {kPaperExact, paperGraph, kFast, kExact}) {
    const Outcome outcome = measure(surface, pairs, options);
    EXPECT_GE(outcome.converged, 0.95 * outcome.samples) << "of " << outcome.samples;
    std::printf("two points, %s, seed %d, %s fields, solver %d: median %.4f mean edges, %d of %d\n",
                name.c_str(), static_cast<int>(seed),
                options.method == Method::kPaper ? "the paper's" : "default",
                static_cast<int>(options.solver), outcome.median, outcome.converged,
                outcome.samples);
    median = outcome.median;
  }
  return median;
}

TEST(TwoPoints, HaveTheirCenterOfMassOnTheShortestPathOfTheIcosphere) {
  // The long run has 20,480 triangles.
  const int frequency = longRun() ? 32 : 10;
  EXPECT_LE(checkTwoPoints("icosphere", importMesh(icosphere(frequency)).mesh, 42), 0.02);
}

TEST(TwoPoints, HaveACenterOfMassOnTheBunny) { checkTwoPoints("bunny", bunnyMesh(), 43); }

}  // namespace
}  // namespace karcher

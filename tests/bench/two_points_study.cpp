#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/trace/segment.h"
#include "distance/shortest_path.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"

/// The center of mass of two points with weights 1 - w and w against the point at the fraction w of
/// their exact shortest path, in mean edges. It takes 50 random pairs, 5 to 20 % of the diagonal
/// apart, and 101 values of w. Errors across the path come from the fields' directions, those along
/// it from their lengths.
///
///   two_points_study [MESH.obj ...]
namespace karcher {
namespace {

constexpr uint64_t kSeed = 42;
constexpr int kPairs = 50;
constexpr int kWeights = 101;

struct Pair {
  SurfacePoint from;
  SurfacePoint to;
  SurfacePath path;
};

/// A point of a path, and the path's unit direction there.
struct PathPlace {
  Vec3 point;
  Vec3 along = Vec3::Zero();
};

/// The place at a length from the path's start.
PathPlace placeAtLength(const TriangleMesh& mesh, const SurfacePath& path, double length) {
  Vec3 before = position(mesh, path.points.front());
  Vec3 along = Vec3::Zero();
  for (const SurfacePoint& point : path.points) {
    const Vec3 here = position(mesh, point);
    const double step = (here - before).norm();
    if (step > 0) along = (here - before) / step;
    if (length <= step && step > 0) return {before + length * along, along};
    length -= step;
    before = here;
  }
  return {before, along};
}

Array<Pair> choosePairs(const Geometry& geometry) {
  Random random(kSeed);
  Array<Pair> pairs;
  for (const PointPair& pair : randomPairs(geometry, random, kPairs, randomPoint)) {
    pairs.push_back({pair.from, pair.to, shortestPath(geometry, pair.from, pair.to)});
  }
  return pairs;
}

struct Outcome {
  Array<double> errors;
  Array<double> along;  // the component of an error along the path, and the rest
  Array<double> across;
  int lost = 0;
};

Outcome measure(Surface& surface, const Array<Pair>& pairs, const FieldOptions& options) {
  const Geometry& geometry = surface.geometry();
  Outcome outcome;
  const WeightTable table = tabulate([](double t) { return Array<double>{1 - t, t}; }, kWeights);
  PointField from(surface, options);
  PointField to(surface, options);
  for (const Pair& pair : pairs) {
    from.setPoint(pair.from);
    to.setPoint(pair.to);
    SegmentFields fields(surface, {&from, &to});
    const Array<CurveSample> samples = traceSegment(fields, table, options.method);
    for (const CurveSample& sample : samples) {
      if (sample.status != SampleStatus::kConverged) {
        ++outcome.lost;
        continue;
      }
      const PathPlace expected =
          placeAtLength(surface.mesh(), pair.path, sample.t * pair.path.length());
      const Vec3 error =
          (position(surface.mesh(), sample.point) - expected.point) / geometry.meanEdge;
      const double along = error.dot(expected.along);
      outcome.errors.push_back(error.norm());
      outcome.along.push_back(std::abs(along));
      outcome.across.push_back((error - along * expected.along).norm());
    }
  }
  return outcome;
}

void study(const std::string& name, TriangleMesh mesh) {
  Surface surface(std::move(mesh));
  const Array<Pair> pairs = choosePairs(surface.geometry());
  struct Row {
    const char* name;
    FieldOptions options;
  };
  const Row rows[] = {
      {"paper, exact", {Method::kPaper, Solver::kExact, 6}},
      {"paper, graph", {Method::kPaper, Solver::kGraph, 6}},
      {"log, fast", {Method::kKarcher, Solver::kFast, 6}},
      {"log, exact", {Method::kKarcher, Solver::kExact, 6}},
  };
  for (const Row& row : rows) {
    const Outcome outcome = measure(surface, pairs, row.options);
    const int total = kPairs * kWeights;
    std::printf("| %s | %d | %s | %.4f | %.4f | %.4f | %.4f | %.4f | %.2f %% |\n", name.c_str(),
                surface.mesh().faceCount(), row.name, median(outcome.errors),
                quantile(outcome.errors, 0.95), quantile(outcome.errors, 1),
                quantile(outcome.along, 0.95), quantile(outcome.across, 0.95),
                100.0 * (total - outcome.lost) / total);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    std::printf("Two points, %d pairs (seed %d), %d weights: error in mean edges\n\n", kPairs,
                static_cast<int>(kSeed), kWeights);
    std::printf(
        "| mesh | triangles | fields | median | 95 %% | maximum | along the path, 95 %% | across, "
        "95 %% | "
        "converged |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
    study("icosphere", importMesh(icosphere(32)).mesh);
    for (int i = 1; i < argc; ++i) study(argv[i], loadBenchMesh(argv[i], "").mesh);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "bench_support.h"
#include "curves/bases.h"
#include "curves/curve.h"
#include "peers/affine_heat.h"
#include "peers/log_map_mean.h"
#include "peers/weighted_averages.h"

/// The peers on a mesh and a uniform cubic B-spline on it, as one JSON object a line: what they
/// cost, and how far they are from the spline of exact log vectors, in mean edges. A log map by
/// vector heat is timed beside its own triangular solves alone.
namespace karcher {
namespace {

/// Samples of segment j are averages of the points j to j + 3.
struct Spline {
  Array<SurfacePoint> points;
  int samples = 0;

  int segments() const { return points.count() - 3; }
  double t(int sample) const { return static_cast<double>(sample) / (samples - 1); }
};

using Average = std::function<CenterOfMass(int segment, const Array<double>& weights,
                                           const SurfacePoint& start)>;

Array<CurveSample> traceSpline(const Spline& spline, const Average& average) {
  Array<CurveSample> samples;
  SurfacePoint start = spline.points[1];
  for (int j = 0; j < spline.segments(); ++j) {
    for (int i = 0; i < spline.samples; ++i) {
      const double t = spline.t(i);
      const CenterOfMass center = average(j, uniformCubicBasis(t), start);
      start = center.point;
      samples.push_back({t, center.point, center.status});
    }
  }
  return samples;
}

Array<CurveSample> referenceSpline(Surface& surface, const Spline& spline) {
  Curve curve(surface,
              {{CurveKind::kBSpline}, spline.samples, {Method::kKarcher, Solver::kExact, 6}},
              spline.points);
  curve.updateFields();
  curve.trace();
  Array<CurveSample> samples;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    const Array<CurveSample>& segment = curve.samples(j);
    samples.insert(samples.end(), segment.begin(), segment.end());
  }
  return samples;
}

/// Times a peer's curve and compares it with the reference.
void printCurve(const Surface& surface, const char* name, const Spline& spline,
                const Array<CurveSample>& reference, double prepareMs, const Average& average) {
  Array<CurveSample> samples;
  const double traceMs = timed([&] { samples = traceSpline(spline, average); });
  int lost = 0;
  Array<double> deviations{0};
  for (int i = 0; i < samples.count(); ++i) {
    lost += samples[i].status != Status::kConverged;
    if (samples[i].status != Status::kConverged || reference[i].status != Status::kConverged) {
      continue;
    }
    const Vec3 difference =
        position(surface.mesh(), samples[i].point) - position(surface.mesh(), reference[i].point);
    deviations.push_back(difference.norm() / surface.geometry().meanEdge);
  }
  std::printf(
      "{\"method\":\"%s\",\"prepareMs\":%.1f,\"traceMs\":%.3f,\"sampleUs\":%.3f,\"samples\":%d,"
      "\"lost\":%d,\"deviation\":{\"median\":%.4f,\"max\":%.4f}}\n",
      name, prepareMs, traceMs, 1000 * traceMs / samples.count(), samples.count(), lost,
      median(deviations), quantile(deviations, 1));
}

/// The weights of a segment's points among all points of the spline.
Array<double> spread(const Spline& spline, int segment, const Array<double>& weights) {
  Array<double> all(spline.points.size(), 0);
  for (int k = 0; k < weights.count(); ++k) all[segment + k] = weights[k];
  return all;
}

void timeSolves(const HeatOperators& operators) {
  constexpr int kRuns = 15;
  Array<double> maps;
  Array<double> solves;
  for (int i = 0; i < kRuns; ++i) {
    const int v = i * (operators.vertexCount() / kRuns);
    maps.push_back(timed([&] { vectorHeatLogMap(operators, v); }));
    Columns<Complex, 2> vectors = Columns<Complex, 2>::Zero(operators.vertexCount(), 2);
    vectors.row(v).setOnes();
    Columns<double, 1> function = Columns<double, 1>::Ones(operators.vertexCount());
    solves.push_back(timed([&] {
      operators.vectorHeat().solveInOrder<2>(vectors);
      operators.poisson().solveInOrder<1>(function);
    }));
  }
  std::printf("{\"vertices\":%d,\"logMapMs\":%.3f,\"solvesMs\":%.3f,\"ratio\":%.3f}\n",
              operators.vertexCount(), median(maps), median(solves), median(maps) / median(solves));
}

void benchHeat(const Surface& surface, const Spline& spline, const Array<CurveSample>& reference) {
  for (const bool delaunay : {false, true}) {
    HeatOptions options;
    options.delaunay = delaunay;
    std::unique_ptr<HeatOperators> operators;
    const auto prepare = [&](const auto& factorise) {
      return timed([&] {
        operators = std::make_unique<HeatOperators>(surface.geometry(), options);
        factorise();
      });
    };
    const auto bench = [&](const std::string& name, double prepareMs, const auto& logMap) {
      LogMapMean mean(surface.geometry(), logMap, spline.points);
      printCurve(surface, (name + (delaunay ? ", Delaunay" : "")).c_str(), spline, reference,
                 prepareMs, [&](int j, const Array<double>& weights, const SurfacePoint& start) {
                   return mean.centerOfMass(spread(spline, j, weights), start);
                 });
    };
    const double vectorMs = prepare([&] {
      operators->vectorHeat();
      operators->poisson();
    });
    timeSolves(*operators);
    bench("vectorHeat", vectorMs, [&](int v) { return vectorHeatLogMap(*operators, v); });
    const double affineMs = prepare([&] {
      operators->vectorHeat();
      operators->scalarHeat();
    });
    bench("affineHeat", affineMs,
          [&](int v) { return affineHeatLogMap(*operators, v, AffineVariant::kLocal); });
    bench("affineHeat, adaptive", affineMs,
          [&](int v) { return affineHeatLogMap(*operators, v, AffineVariant::kAdaptive); });
  }
}

void benchWeightedAverages(const Surface& surface, const Spline& spline,
                           const Array<CurveSample>& reference, int landmarks) {
  ExactDistance solver(surface.geometry());
  const auto distancesFrom = [&](int v) {
    solver.setSource(vertexPoint(surface.mesh(), v));
    solver.grow(kInfinity);
    Array<double> distances;
    for (int w = 0; w < surface.mesh().vertexCount(); ++w) distances.push_back(solver.distance(w));
    return distances;
  };
  EmbeddingOptions options;
  options.landmarks = landmarks;
  Embedding embedding;
  const double prepareMs =
      timed([&] { embedding = embedSurface(surface.geometry(), distancesFrom, options); });
  std::printf("{\"landmarks\":%d,\"stress\":%.4f,\"foldedFaces\":%d}\n", embedding.landmarks,
              embedding.stress, embedding.foldedFaces);
  const WeightedAverages averages(surface.mesh(), embedding);
  printCurve(surface, "weightedAverages", spline, reference, prepareMs,
             [&](int j, const Array<double>& weights, const SurfacePoint& start) {
               const auto first = spline.points.begin() + j;
               return averages.centerOfMass({first, first + 4}, weights, start);
             });
}

void run(const std::string& meshPath, const std::string& pointsPath, int samples, int landmarks) {
  BenchMesh input = loadBenchMesh(meshPath, pointsPath);
  Surface surface(buildMesh(input.mesh.positions, input.mesh.faces));
  const Spline spline{input.points, samples};
  const Array<CurveSample> reference = referenceSpline(surface, spline);
  benchHeat(surface, spline, reference);
  if (landmarks > 0) benchWeightedAverages(surface, spline, reference, landmarks);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const int samples = argc > 3 ? std::atoi(argv[3]) : 16;
  const int landmarks = argc > 4 ? std::atoi(argv[4]) : 500;
  if (argc < 3 || argc > 5 || samples < 2) {
    std::fprintf(stderr,
                 "usage: peers_bench MESH.obj POINTS.txt [SAMPLES] [LANDMARKS]\n"
                 "LANDMARKS 0 leaves out weighted averages.\n");
    return 1;
  }
  try {
    karcher::run(argv[1], argv[2], samples, landmarks);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

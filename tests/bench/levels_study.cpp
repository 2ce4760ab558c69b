#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "generators/curve_shapes.h"
#include "mesh/mesh_import.h"
#include "smooth_shapes.h"
#include "steadiness.h"

/// The distance of curves with automatic levels from the curve of level 0 (Mancinelli, Puppo, Eq.
/// 4) where that is safe, and from the true curve on the smooth surface. The curves are cubic
/// Bezier curves of random polygons at .05 to .3 of the bounding box's diagonal. Each surface, size
/// and spacing has a row.
///
///   levels_study [--polygons 200] [--triangles 20000,80000] [PART_OF_A_NAME]
namespace karcher {
namespace {

constexpr double kFarthestOnSaddle = 0.2;
constexpr double kSpacings[] = {0.05, 0.1, 0.2, 0.3};
/// The number of samples of a curve for comparison, so that all pieces of up to 5 levels have one.
constexpr int kSamples = 65;
/// The factor of the indices of samples in the comparison with the truth, which takes long on some
/// surfaces.
constexpr int kTruthEvery = 16;
/// The excess of the turn of level 0, in degrees, that still counts as whole without a bridge.
constexpr double kLittleTurning = 3;

/// The curve's points at even parameters.
Array<Vec3> sampled(const Curve& curve) {
  const int pieces = curve.piecesPerSegment();
  Array<Vec3> positions;
  for (int i = 0; i < kSamples; ++i) {
    const double t = static_cast<double>(i) * pieces / (kSamples - 1);
    const int k = std::min(static_cast<int>(t), pieces - 1);
    const Array<CurveSample>& samples = curve.piece(0, k).samples();
    const auto at = static_cast<int>(std::lround((t - k) * (samples.count() - 1)));
    positions.push_back(position(curve.surface().mesh(), samples[at].point));
  }
  return positions;
}

double largestDistance(const Array<Vec3>& a, const Array<Vec3>& b) {
  double largest = 0;
  for (int i = 0; i < a.count(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

/// The largest distance of a curve from the true one; nothing if the true one has no center.
double fromTruth(const SmoothSurface& smooth, const Curve& curve, const Array<Vec3>& samples) {
  Array<Vec3> points;
  for (const SurfacePoint& p : curve.points()) {
    points.push_back(smooth.project(position(curve.surface().mesh(), p)));
  }
  double largest = 0;
  for (int i = kTruthEvery; i + 1 < kSamples; i += kTruthEvery) {
    const double t = static_cast<double>(i) / (kSamples - 1);
    const Array<double> weights = weightsAt({BasisForm::kBernstein, points.count() - 1}, t);
    const Vec3 here = smooth.project(samples[i]);
    largest = std::max(largest, (smoothCenter(smooth, points, weights, here) - here).norm());
  }
  return largest;
}

double turningOf(const TurningMeasure& measure, const Curve& curve) {
  Array<Vec3> polyline;
  for (const SurfacePoint& p : curve.path(0).line.points) {
    polyline.push_back(position(curve.surface().mesh(), p));
  }
  return turning(measure, polyline);
}

void printRow(const SmoothShape& shape, Surface& surface, const TurningMeasure& measure,
              double spacing, int polygons) {
  const Geometry& geometry = surface.geometry();
  Random random(1);
  Array<double> levels;
  Array<double> fromZero;
  Array<double> estimates;
  Array<double> truthOurs;
  Array<double> truthZero;
  Array<double> ms;
  Array<double> msZero;
  int zeros = 0;
  int jumping = 0;
  int unsafe = 0;
  int needlessly = 0;
  for (int i = 0; i < polygons; ++i) {
    const Array<SurfacePoint> points = randomControlPolygon(geometry, random, {.spacing = spacing});
    CurveOptions options = ofLevelZero({CurveKind::kBezier}, kSamples, {});
    const auto traced = [&](int asked, Array<double>* times) {
      options.levels = asked;
      const double start = processorMilliseconds();
      Curve curve(surface, options, points);
      if (times) times->push_back(processorMilliseconds() - start);
      return curve;
    };
    // The order alternates, since the second finds memory that the first has used.
    const auto first = i % 2 == 0 ? kAutomaticLevels : 0;
    Curve one = traced(first, first == 0 ? &msZero : &ms);
    Curve other = traced(kAutomaticLevels - first, first == 0 ? &ms : &msZero);
    Curve& ours = first == 0 ? other : one;
    const Curve& zero = first == 0 ? one : other;
    levels.push_back(ours.levels());
    zeros += ours.levels() == 0;
    jumping += ours.levels() == 0 && !ours.bridges(0).empty();
    const Array<Vec3> oursAt = sampled(ours);
    const Array<Vec3> zeroAt = sampled(zero);
    const double distance = largestDistance(oursAt, zeroAt) / geometry.meanEdge;
    const double estimate = ours.deviation() / geometry.meanEdge;
    if (std::isnan(estimate)) {
      ++unsafe;
      const Curve limit = traced(kLimitLevels, nullptr);
      needlessly += zero.bridges(0).empty() &&
                    turningOf(measure, zero) < turningOf(measure, limit) + kLittleTurning;
      continue;
    }
    fromZero.push_back(distance);
    estimates.push_back(estimate);
    try {
      truthOurs.push_back(fromTruth(shape.surface, ours, oursAt) / geometry.diagonal);
      truthZero.push_back(fromTruth(shape.surface, zero, zeroAt) / geometry.diagonal);
    } catch (const std::exception&) {
      // The search finds no shortest path on the smooth surface.
    }
  }
  const auto inPercent = [&](int count) { return 100.0 * count / polygons; };
  std::printf("| %s | %d | %g | %.1f | %.1f (%.1f) | %.1f (%.1f) |", shape.name.c_str(),
              surface.mesh().faceCount(), spacing, mean(levels), inPercent(zeros),
              inPercent(jumping), inPercent(unsafe), inPercent(needlessly));
  if (fromZero.empty()) {
    std::printf(" - | - | - | - |");
  } else {
    std::printf(" %.4f / %.4f / %.4f | %.4f |", median(fromZero), quantile(fromZero, 0.99),
                quantile(fromZero, 1), quantile(estimates, 1));
    if (truthOurs.empty()) {
      std::printf(" - | - |");
    } else {
      std::printf(" %.1e / %.1e | %.1e / %.1e |", median(truthOurs), quantile(truthOurs, 1),
                  median(truthZero), quantile(truthZero, 1));
    }
  }
  std::printf(" %.2f / %.2f |\n", median(ms), median(msZero));
  std::fflush(stdout);
}

struct Options {
  int polygons = 200;
  Array<int> triangles{20'000, 80'000};
  std::string name;
};

Options parse(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (argument == "--polygons") {
      options.polygons = std::atoi(value.c_str());
      ++i;
    } else if (argument == "--triangles") {
      options.triangles.clear();
      for (size_t at = 0; at < value.size(); at = value.find(',', at) + 1) {
        options.triangles.push_back(std::atoi(value.c_str() + at));
        if (value.find(',', at) == std::string::npos) break;
      }
      ++i;
    } else {
      options.name = argument;
    }
  }
  if (options.polygons < 1) throw std::runtime_error("--polygons takes at least 1");
  return options;
}

void study(const Options& options) {
  std::printf(
      "Cubic Bezier curves of %d random polygons a row, `levels: auto`. 'Level 0': the percentage "
      "that takes none, in brackets where it has a bridge all the same. 'Unsafe': the percentage "
      "for which level 0 is judged not to be safe, in "
      "brackets where it then has no bridge and turns no more than the limit. 'From level 0': how "
      "far the others lie from the curve of level 0, mean edges, median, 99 of 100 and largest; "
      "'estimate': its largest estimate. 'From truth': how far from the curve on the "
      "smooth surface, diagonals, median and largest. Milliseconds of the processor: the median "
      "first trace, beside that of level 0.\n\n"
      "| surface | triangles | spacing | levels | level 0 | unsafe | from level 0 | estimate | "
      "from "
      "truth | level 0 from truth | ms |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
      options.polygons);
  for (const SmoothShape& shape : smoothShapes()) {
    if (shape.name.find(options.name) == std::string::npos) continue;
    for (const int triangles : options.triangles) {
      Surface surface(importMesh(shape.mesh(triangles)).mesh);
      const TurningMeasure measure(surface.mesh());
      for (const double spacing : kSpacings) {
        // Distant points do not fit on the saddle.
        if (shape.name == "saddle" && spacing > kFarthestOnSaddle) continue;
        printRow(shape, surface, measure, spacing, options.polygons);
      }
    }
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    study(parse(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include "curve_times.h"

#include <sys/resource.h>

#include "generators/curve_shapes.h"

namespace karcher {
namespace {

/// The point at the next corner of the face: a drag by about an edge.
SurfacePoint neighbour(const SurfacePoint& p) {
  const int heaviest =
      p.bary[0] > p.bary[1] ? (p.bary[0] > p.bary[2] ? 0 : 2) : (p.bary[1] > p.bary[2] ? 1 : 2);
  return edgePoint(3 * p.face + (heaviest + 1) % 3, 0);
}

}  // namespace

CurveTimes timeCurve(Surface& surface, const Array<SurfacePoint>& points, int samples,
                     const FieldOptions& field) {
  CurveTimes result;
  Curve curve(surface, CurveValue{ofLevelZero({CurveKind::kBSpline}, samples, field), points, {}},
              milliseconds);
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      ++result.samples;
      result.lost += sample.status != SampleStatus::kConverged;
    }
  }
  const int moved = curve.pointCount() / 2;
  const SurfacePoint places[2] = {neighbour(curve.point(moved)), curve.point(moved)};
  const auto untilBridged = [&] {
    const StageTimes& times = curve.times();
    return times.polygon + times.fields + times.samples + times.bridges;
  };
  Array<double> traces;
  Array<double> drags;
  Array<double> bridges;
  Array<double> joins;
  for (int i = 0; i < (field.method == Method::kPaper ? kRuns : kQuickRuns); ++i) {
    curve.movePoint(moved, places[i % 2]);
    drags.push_back(untilBridged());
    // A second run with all fields known measures the searches alone. Equal weights change nothing
    // else.
    CurveValue again = curve.value();
    again.options.shape.weights.assign(points.size(), i % 2 == 0 ? 2 : 1);
    curve.set(std::move(again));
    traces.push_back(curve.times().samples);
    bridges.push_back(curve.times().bridges);
    joins.push_back(curve.times().joins);
  }
  Array<double> weights;
  for (int i = 0; i < (field.method == Method::kPaper ? kRuns : kQuickRuns); ++i) {
    curve.setWeight(moved, i % 2 == 0 ? 2 : 1);
    weights.push_back(untilBridged());
  }
  result.weightMs = median(weights);
  result.sampleUs = 1000 * median(traces) / (curve.segmentCount() * samples);
  result.dragMs = median(drags);
  result.bridgeMs = median(bridges);
  result.joinMs = median(joins);
  return result;
}

SteadyTimes timeSteadyDrag(Surface& surface, const Array<SurfacePoint>& points, int samples) {
  CurveOptions options = ofLevelZero({CurveKind::kBSpline}, samples, {});
  options.levels = kAutomaticLevels;
  options.levels = Curve(surface, options, points).levels();
  Curve curve(surface, options, points);
  const int moved = curve.pointCount() / 2;
  const SurfacePoint places[2] = {neighbour(curve.point(moved)), curve.point(moved)};
  Array<double> steps;
  for (int i = 0; i < kQuickRuns; ++i) {
    steps.push_back(timed([&] { curve.dragPoint(moved, places[i % 2]); }));
  }
  return {options.levels, median(steps)};
}

double peakMemoryMB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace karcher

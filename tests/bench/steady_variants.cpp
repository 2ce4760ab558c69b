#include "steady_variants.h"

#include "bench_support.h"
#include "curves/polygon/subdivision.h"
#include "distance/geodesic_line.h"

namespace karcher {
namespace {

constexpr int kSamples = 128;

CurveOptions cubicBezier() { return {{CurveKind::kBezier}, kSamples, {}}; }

TracedCurve described(const Curve& curve) {
  TracedCurve result;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const SurfacePoint& p : curve.path(j).points) {
      result.polyline.push_back(position(curve.surface().mesh(), p));
    }
    for (const CurveSample& sample : curve.samples(j)) {
      result.lost += sample.status != Status::kConverged && sample.status != Status::kBridged;
    }
    for (const Bridge& bridge : curve.bridges(j)) {
      result.bridged += (bridge.t1 - bridge.t0) / curve.segmentCount();
    }
  }
  return result;
}

/// With the stages of the last edit; of a curve that was just made none are known.
TracedCurve withStages(const Curve& curve) {
  TracedCurve traced = described(curve);
  const StageTimes& times = curve.times();
  traced.stages = {{"polygon", times.polygon},
                   {"fields", times.fields},
                   {"samples", times.samples},
                   {"bridges", times.bridges},
                   {"joins", times.joins}};
  return traced;
}

SteadyVariant means() {
  SteadyVariant variant;
  variant.name = "0";
  variant.trace = [](Surface& surface, const Array<SurfacePoint>& points) {
    return withStages(Curve(surface, cubicBezier(), points));
  };
  variant.hold = [](Surface& surface, const Array<SurfacePoint>& points) {
    const auto curve = std::make_shared<Curve>(surface, cubicBezier(), points);
    curve->setClock(processorMilliseconds);
    HeldCurve held;
    held.drag = [curve](int i, const SurfacePoint& place) {
      curve->movePoint(i, place);
      return withStages(*curve);
    };
    held.release = [curve] { return described(*curve); };
    return held;
  };
  return variant;
}

/// The curve of subdivision, whose paths are all searched for anew.
TracedCurve subdivided(Surface& surface, const Array<SurfacePoint>& points) {
  const Geometry& geometry = surface.geometry();
  ParametricLine line;
  const double ms = processorTimed([&] { appendBezier(geometry, points, 0, 1, line); });
  TracedCurve traced;
  traced.stages = {{"subdivision", ms}};
  for (const SurfacePoint& p : line.points) traced.polyline.push_back(position(surface.mesh(), p));
  for (int i = 1; i < points.count(); ++i) {
    traced.legs.push_back(geodesicLine(geometry, points[i - 1], points[i]).points);
  }
  return traced;
}

SteadyVariant limit() {
  SteadyVariant variant;
  variant.name = "limit";
  variant.trace = subdivided;
  variant.hold = [](Surface& surface, const Array<SurfacePoint>& points) {
    const auto polygon = std::make_shared<Array<SurfacePoint>>(points);
    HeldCurve held;
    held.drag = [polygon, &surface](int i, const SurfacePoint& place) {
      (*polygon)[i] = place;
      return subdivided(surface, *polygon);
    };
    held.release = [polygon, &surface] { return subdivided(surface, *polygon); };
    return held;
  };
  return variant;
}

}  // namespace

Array<SteadyVariant> steadyVariants() { return {means(), limit()}; }

}  // namespace karcher

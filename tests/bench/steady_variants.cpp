#include "steady_variants.h"

#include <algorithm>
#include <stdexcept>

#include "bench_support.h"
#include "curves/polygon/subdivision.h"
#include "distance/find_path.h"
#include "generators/curve_shapes.h"
#include "measures/allocations.h"
#include "measures/corner.h"

namespace karcher {
namespace {

CurveOptions cubicBezier(int levels) {
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, kSteadySamples, {});
  options.levels = levels;
  return options;
}

TracedCurve described(Curve& curve, int64_t allocations = 0) {
  TracedCurve result;
  result.allocations = allocations;
  result.levels = curve.levels();
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const SurfacePoint& p : curve.path(j).line.points) {
      result.polyline.push_back(position(curve.surface().mesh(), p));
    }
    for (const CurveSample& sample : curve.samples(j)) {
      result.lost += sample.status != SampleStatus::kConverged &&
                     sample.status != SampleStatus::kBridged &&
                     sample.status != SampleStatus::kSubdivided;
    }
    for (const Bridge& bridge : curve.bridges(j)) {
      result.bridged += (bridge.t1 - bridge.t0) / curve.segmentCount();
    }
    const int pieces = curve.piecesPerSegment();
    for (int k = 0; k < pieces; ++k) {
      const Curve::Piece& piece = curve.piece(j, k);
      const double part = 1.0 / (pieces * curve.segmentCount());
      if (piece.isSubdivided()) {
        result.piecesSubdivided += part;
      } else if (!piece.bridges().empty()) {
        result.piecesBridged += part;
      }
    }
  }
  const StageTimes& times = curve.times();
  result.stages = {{"polygon", times.polygon},
                   {"fields", times.fields},
                   {"samples", times.samples},
                   {"bridges", times.bridges},
                   {"joins", times.joins}};
  return result;
}

/// The largest angle at the joints between pieces of a segment.
double largestCorner(Curve& curve) {
  const int joints = curve.piecesPerSegment() * curve.segmentCount();
  double corner = 0;
  for (int i = 1; i < joints; ++i) {
    corner = std::max(corner, cornerAt(curve, static_cast<double>(i) / curve.piecesPerSegment()));
  }
  return corner;
}

SteadyVariant refined(const std::string& name, int levels) {
  SteadyVariant variant;
  variant.name = name;
  variant.trace = [levels](Surface& surface, const Array<SurfacePoint>& points) {
    Curve curve(surface, cubicBezier(levels), points);
    return described(curve);
  };
  variant.corner = [levels](Surface& surface, const Array<SurfacePoint>& points) {
    Curve curve(surface, cubicBezier(levels), points);
    return largestCorner(curve);
  };
  variant.hold = [levels](Surface& surface, const Array<SurfacePoint>& points) {
    // A read of the processor's clock takes a microsecond: too long for stages.
    const auto curve =
        std::make_shared<Curve>(surface, CurveValue{cubicBezier(levels), points, {}}, milliseconds);
    HeldCurve held;
    held.drag = [curve, levels](int i, const SurfacePoint& place) {
      const int64_t allocations = allocationsSoFar();
      const double ms = processorTimed([&] {
        if (levels == 0) {
          // Level 0 does not use legs.
          curve->movePoint(i, place);
          return;
        }
        CurveValue value = withPointDragged(curve->value(), i, place, curve->legs());
        // A drag shows drafts, as on the page, and keeps the most levels so far.
        if (levels == kAutomaticLevels) {
          value.options.leastLevels = curve->levels();
          value.options.levelsTolerance = kInfinity;
        }
        curve->set(std::move(value));
      });
      TracedCurve traced = described(*curve, allocationsSoFar() - allocations);
      traced.ms = ms;
      for (const SurfacePath& leg : curve->legs()) traced.legs.push_back(leg.points);
      return traced;
    };
    const auto release = [curve](int to) {
      CurveValue value = curve->value();
      value.options.levels = to;
      value.options.leastLevels = 0;
      value.options.levelsTolerance = kLevelsTolerance;
      curve->set(value);
      return described(*curve);
    };
    held.release = [release, levels] { return release(levels); };
    held.releaseToAutomatic = [release] { return release(kAutomaticLevels); };
    return held;
  };
  return variant;
}

/// The curve of subdivision, with a new search for every path.
TracedCurve subdivided(Surface& surface, const Array<SurfacePoint>& points) {
  const Geometry& geometry = surface.geometry();
  ParametricLine line;
  const int64_t allocations = allocationsSoFar();
  SubdivisionWorkspace workspace;
  const double ms = processorTimed([&] { appendBezier(geometry, points, 0, 1, workspace, line); });
  TracedCurve traced;
  traced.allocations = allocationsSoFar() - allocations;
  traced.ms = ms;
  traced.stages = {{"subdivision", ms}};
  for (const SurfacePoint& p : line.path.points)
    traced.polyline.push_back(position(surface.mesh(), p));
  for (int i = 1; i < points.count(); ++i) {
    findPath(geometry, points[i - 1], points[i], workspace.paths, workspace.line);
    traced.legs.push_back(workspace.line.points);
  }
  return traced;
}

SteadyVariant limit() {
  SteadyVariant variant;
  variant.name = "limit";
  variant.trace = subdivided;
  variant.corner = [](Surface&, const Array<SurfacePoint>&) { return 0.0; };
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

SteadyVariant steadyVariant(const std::string& name) {
  if (name == "limit") return limit();
  if (name == "auto") return refined(name, kAutomaticLevels);
  if (name == "averages") return refined(name, kLimitLevels);
  for (int levels = 0; levels <= kMostLevels; ++levels) {
    if (name == std::to_string(levels)) return refined(name, levels);
  }
  throw std::runtime_error("levels are 0 to " + std::to_string(kMostLevels) +
                           ", auto, averages or limit, not '" + name + "'");
}

}  // namespace karcher

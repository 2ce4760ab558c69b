#include "curves/query/measure.h"

#include <algorithm>
#include <string>

#include "curves/trace/bridge.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The place of a value in a nondecreasing array: between entries `piece` and `piece` + 1, at the
/// fraction s.
struct Place {
  int piece = 0;
  double s = 0;
};

Place placeOf(const Array<double>& values, double value) {
  const int k = pieceAt(values, value);
  const double width = values[k + 1] - values[k];
  return {k, width > 0 ? std::clamp((value - values[k]) / width, 0.0, 1.0) : 0};
}

double between(const Array<double>& values, const Place& place) {
  return values[place.piece] + place.s * (values[place.piece + 1] - values[place.piece]);
}

SampleStatus statusAt(const Curve& curve, double parameter) {
  const SegmentParameter at = segmentParameter(curve, parameter);
  const Bridge* bridge = bridgeOver(curve.bridges(at.segment), at.t);
  for (const CurveSample& sample : curve.samples(at.segment)) {
    if (sample.t < at.t) continue;
    return bridge && sample.t > at.t ? statusOn(*bridge) : sample.status;
  }
  return SampleStatus::kConverged;
}

CurvePoint pointOfLine(const Curve& curve, const CurveLine& line, const Place& place) {
  const double parameter = between(line.parameters, place);
  const TriangleMesh& mesh = curve.surface().mesh();
  const SurfacePoint point =
      pointBetween(mesh, line.path.points[place.piece], line.path.points[place.piece + 1], place.s);
  return {parameter, point, statusAt(curve, parameter)};
}

}  // namespace

CurveLine lineOf(const Curve& curve) {
  const TriangleMesh& mesh = curve.surface().mesh();
  CurveLine line;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    const Array<CurveSample>& samples = curve.samples(j);
    const JoinedPath& path = curve.path(j);
    int first = line.path.points.count();  // the index of the first point after the last sample
    for (int i = 0; i < path.line.points.count(); ++i) {
      const Vec3 here = position(mesh, path.line.points[i]);
      const double step = line.path.points.empty() ? 0 : (here - line.positions.back()).norm();
      line.path.lengths.push_back(line.path.points.empty() ? 0 : line.path.lengths.back() + step);
      line.path.points.push_back(path.line.points[i]);
      line.positions.push_back(here);
      line.parameters.push_back(j + samples[path.sample[i]].t);
      const bool atSample = i + 1 == path.sample.count() || path.sample[i + 1] != path.sample[i];
      if (!atSample) continue;
      const int last = line.path.points.count() - 1;
      if (first > 0 && i > 0) {
        const double start = line.path.lengths[first - 1];
        const double whole = line.path.lengths[last] - start;
        const double from = line.parameters[first - 1];
        const double to = line.parameters[last];
        for (int k = first; k < last; ++k) {
          const double part = whole > 0 ? (line.path.lengths[k] - start) / whole : 1;
          line.parameters[k] = from + part * (to - from);
        }
      }
      first = last + 1;
    }
  }
  return line;
}

double lengthAt(const Curve& curve, const CurveLine& line, double parameter) {
  const SegmentParameter at = segmentParameter(curve, parameter);
  const double inside = at.segment + at.t;
  // On a closed curve, a positive whole number of turns counts as the end, not as the start.
  if (parameter > 0 && inside == 0) return line.path.lengths.back();
  return between(line.path.lengths, placeOf(line.parameters, inside));
}

CurvePoint pointAtLength(const Curve& curve, const CurveLine& line, double length) {
  const double whole = line.path.lengths.back();
  double inside = length;
  if (curve.shape().closed && whole > 0 && std::isfinite(length)) {
    inside = length - whole * std::floor(length / whole);
  }
  // A caller may pass the sum of the segments' own lengths, which differs by rounding.
  if (!(inside >= 0 && inside <= (1 + kChainRounding) * whole)) {
    throw Error(ErrorCode::kBadArgument, "the curve has no point at the length " + inFull(length) +
                                             ": it is " + inFull(whole) + " long");
  }
  return pointOfLine(curve, line, placeOf(line.path.lengths, inside));
}

Array<CurvePoint> equallySpaced(const Curve& curve, const CurveLine& line, int count) {
  constexpr int kMost = 1'000'000;
  if (count < 2 || count > kMost) {
    throw Error(ErrorCode::kBadArgument,
                "a curve is divided by 2 to 1000000 points, not " + std::to_string(count));
  }
  const int parts = curve.shape().closed ? count : count - 1;
  Array<CurvePoint> points;
  for (int i = 0; i < count; ++i) {
    const double length = line.path.lengths.back() * i / parts;
    points.push_back(pointOfLine(curve, line, placeOf(line.path.lengths, length)));
  }
  return points;
}

}  // namespace karcher

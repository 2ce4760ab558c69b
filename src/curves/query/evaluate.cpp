#include "curves/query/evaluate.h"

#include <algorithm>

#include "curves/trace/bridge.h"
#include "intrinsic/along_path.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// The number of the first sample at or after t; at least 1.
int sampleAfter(const Array<CurveSample>& samples, double t) {
  const auto before = [](const CurveSample& sample, double value) { return sample.t < value; };
  const auto found = std::lower_bound(samples.begin(), samples.end(), t, before);
  return std::clamp(static_cast<int>(found - samples.begin()), 1, samples.count() - 1);
}

/// The path between the samples around t, and where in it t lies.
struct PathPiece {
  Array<SurfacePoint> points;
  Array<double> lengths;
  double s = 0;
  double duration = 1;  ///< between the samples, in t
};

PathPiece pieceAround(Curve& curve, const SegmentParameter& at) {
  const Array<CurveSample>& samples = curve.samples(at.segment);
  const JoinedPath& path = curve.path(at.segment);
  const int i = sampleAfter(samples, at.t);
  const auto begin = std::lower_bound(path.sample.begin(), path.sample.end(), i);
  const auto end = std::upper_bound(begin, path.sample.end(), i);
  PathPiece piece;
  piece.points.push_back(samples[i - 1].point);
  piece.points.insert(piece.points.end(), path.points.begin() + (begin - path.sample.begin()),
                      path.points.begin() + (end - path.sample.begin()));
  piece.lengths = lengthsAlong(curve.surface().mesh(), piece.points);
  piece.duration = samples[i].t - samples[i - 1].t;
  piece.s = (at.t - samples[i - 1].t) / piece.duration;
  return piece;
}

FieldBlend blendOf(Curve& curve, int segment) {
  return {curve.surface().geometry(), controlFields(curve.fieldsOf(segment))};
}

/// The center at a parameter between two samples, as the search for jumps (bridge.h) comes there:
/// by halves of t, each search starting at the earlier end of its part. From a sample further off
/// it might be another minimum's.
CenterOfMass centerBetween(const Curve& curve, FieldBlend& fields, const SegmentParameter& at,
                           CurveSample from, CurveSample to) {
  const TriangleMesh& mesh = curve.surface().mesh();
  const double shortest = kLongestStep / 2 * fields.geometry().meanEdge;
  const auto centerAt = [&](double t) {
    const CurveSample& start = from.status == Status::kConverged ? from : to;
    if (start.status != Status::kConverged) return CenterOfMass{start.point, start.status, 0};
    return findCenter(fields, curve.weights(at.segment, t), start.point,
                      curve.options().field.method);
  };
  while (to.t - from.t > kFinestDivision &&
         (position(mesh, to.point) - position(mesh, from.point)).norm() > shortest) {
    const double t = (from.t + to.t) / 2;
    CenterOfMass center = centerAt(t);
    if (center.status != Status::kConverged) return center;
    (at.t < t ? to : from) = {t, center.point, center.status};
  }
  return centerAt(at.t);
}

/// Derivatives of the segment's weights by t: differences of second order, inside [0, 1].
Array<double> weightDerivatives(const Curve& curve, const SegmentParameter& at) {
  constexpr double kStep = 1e-5;
  const double middle = std::clamp(at.t, kStep, 1 - kStep);
  const Array<double> before = curve.weights(at.segment, middle - kStep);
  const Array<double> here = curve.weights(at.segment, middle);
  const Array<double> after = curve.weights(at.segment, middle + kStep);
  // The parabola through the three, at t.
  const double away = (at.t - middle) / kStep;
  Array<double> result;
  for (int i = 0; i < here.count(); ++i) {
    const double slope = (after[i] - before[i]) / 2;
    const double bend = after[i] - 2 * here[i] + before[i];
    result.push_back((slope + away * bend) / kStep);
  }
  return result;
}

CurveTangent tangentOfPath(Curve& curve, const CurvePoint& at, const PathPiece& piece) {
  const Geometry& geometry = curve.surface().geometry();
  const int k = pieceAt(piece.lengths, piece.s * piece.lengths.back());
  const SurfacePoint& from = piece.points[k];
  const SurfacePoint& to = piece.points[k + 1];
  const int face = commonFace(*geometry.mesh, from, to);
  const double length = piece.lengths[k + 1] - piece.lengths[k];
  CurveTangent tangent{at};
  if (face < 0 || !(length > 0)) return tangent;
  tangent.at.point =
      pointAlong(*geometry.mesh, piece.points, piece.lengths, piece.s * piece.lengths.back());
  tangent.at.point = inFace(*geometry.mesh, tangent.at.point, face);
  const Vec2 along = pointInFace(geometry, inFace(*geometry.mesh, to, face)) -
                     pointInFace(geometry, inFace(*geometry.mesh, from, face));
  tangent.inFace = piece.lengths.back() / piece.duration / length * along;
  tangent.inSpace = toSpace(geometry, face, tangent.inFace);
  return tangent;
}

}  // namespace

SegmentParameter segmentParameter(const Curve& curve, double parameter) {
  const double end = curve.segmentCount();
  double inside = parameter;
  if (curve.shape().closed && std::isfinite(parameter)) {
    inside = parameter - end * std::floor(parameter / end);
  }
  if (!(inside >= 0 && inside <= end)) {
    throw Error(ErrorCode::kBadArgument, "the curve has no parameter " + inFull(parameter) +
                                             ": it runs from 0 to " + inFull(end));
  }
  const int segment = std::min(static_cast<int>(inside), curve.segmentCount() - 1);
  return {segment, inside - segment};
}

CurvePoint pointAt(Curve& curve, const SegmentParameter& at) {
  const double parameter = at.segment + at.t;
  const Array<CurveSample>& samples = curve.samples(at.segment);
  const int i = sampleAfter(samples, at.t);
  for (const CurveSample& sample : {samples[i - 1], samples[i]}) {
    if (sample.t == at.t) return {parameter, sample.point, sample.status};
  }
  if (const Bridge* bridge = bridgeOver(curve.bridges(at.segment), at.t)) {
    return {parameter, pointAt(curve.surface().mesh(), *bridge, at.t), Status::kBridged};
  }
  Status status = Status::kConverged;
  if (curve.shape().kind != CurveKind::kPolyline) {
    FieldBlend fields = blendOf(curve, at.segment);
    const CenterOfMass center = centerBetween(curve, fields, at, samples[i - 1], samples[i]);
    if (center.status == Status::kConverged) return {parameter, center.point, center.status};
    status = center.status;
  }
  const PathPiece piece = pieceAround(curve, at);
  const SurfacePoint point = pointAlong(curve.surface().mesh(), piece.points, piece.lengths,
                                        piece.s * piece.lengths.back());
  return {parameter, point, status};
}

CurveTangent tangentAt(Curve& curve, const SegmentParameter& at) {
  const CurvePoint point = pointAt(curve, at);
  if (curve.shape().kind == CurveKind::kPolyline || point.status != Status::kConverged) {
    return tangentOfPath(curve, point, pieceAround(curve, at));
  }
  const Geometry& geometry = curve.surface().geometry();
  const int face = point.point.face;
  FieldBlend fields = blendOf(curve, at.segment);
  const CellPoint place = fields.cells().at(point.point);
  const auto [alongX, alongY] =
      fields.jacobian(place.cell, fields.blend(place.cell, curve.weights(at.segment, at.t)));
  const Vec2 wanted = -fields.blend(place.cell, weightDerivatives(curve, at)).at(place.bary);
  const double determinant = cross(alongX, alongY);
  const Vec2 inFace = rotate(fields.axisInFace(place.cell),
                             Vec2(cross(wanted, alongY), cross(alongX, wanted)) / determinant);
  if (!std::isfinite(inFace.x()) || !std::isfinite(inFace.y())) {
    return tangentOfPath(curve, point, pieceAround(curve, at));
  }
  return {point, inFace, toSpace(geometry, face, inFace)};
}

}  // namespace karcher

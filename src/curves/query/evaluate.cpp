#include "curves/query/evaluate.h"

#include <algorithm>
#include <cmath>

#include "curves/trace/bridge.h"
#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The index of the first sample at or after t; at least 1.
int sampleAfter(const Array<CurveSample>& samples, double t) {
  const auto before = [](const CurveSample& sample, double value) { return sample.t < value; };
  const auto found = std::lower_bound(samples.begin(), samples.end(), t, before);
  return std::clamp(static_cast<int>(found - samples.begin()), 1, samples.count() - 1);
}

/// The path between the samples around t, and the place of t in it.
struct PathPiece {
  SurfacePath path;
  double s = 0;
  double duration = 1;  ///< the difference of t between the samples
};

/// A parameter as a piece of a segment and the piece's own t in [0, 1].
struct PieceParameter {
  int segment = 0;
  int piece = 0;
  double t = 0;
};

PieceParameter inPiece(const Curve& curve, const SegmentParameter& at) {
  const int count = curve.piecesPerSegment();
  const int piece = std::clamp(static_cast<int>(at.t * count), 0, count - 1);
  return {at.segment, piece, at.t * count - piece};
}

const Curve::Piece& pieceOf(const Curve& curve, const PieceParameter& at) {
  return curve.piece(at.segment, at.piece);
}

PathPiece pathAround(const Curve& curve, const PieceParameter& at) {
  const Array<CurveSample>& samples = pieceOf(curve, at).samples();
  const JoinedPath& path = pieceOf(curve, at).path();
  const int i = sampleAfter(samples, at.t);
  const auto begin = std::lower_bound(path.sample.begin(), path.sample.end(), i);
  const auto end = std::upper_bound(begin, path.sample.end(), i);
  PathPiece piece;
  const Array<SurfacePoint>& points = path.line.points;
  Array<SurfacePoint> between{samples[i - 1].point};
  between.insert(between.end(), points.begin() + (begin - path.sample.begin()),
                 points.begin() + (end - path.sample.begin()));
  piece.path = pathThrough(curve.surface().mesh(), std::move(between));
  piece.duration = samples[i].t - samples[i - 1].t;
  piece.s = (at.t - samples[i - 1].t) / piece.duration;
  return piece;
}

FieldBlend blendOf(Curve& curve, const PieceParameter& at) {
  return {curve.surface().geometry(), controlFields(curve.fieldsOf(at.segment, at.piece))};
}

/// The center at a parameter between two samples. As in the search for jumps (jumps.h), the
/// function bisects t. Each search starts at the earlier end of the remaining interval, or at the
/// later end if the earlier one is no center. A search from a more distant sample could find
/// another minimum.
CurveSample centerBetween(const Curve& curve, FieldBlend& fields, const PieceParameter& at,
                          CurveSample from, CurveSample to) {
  const TriangleMesh& mesh = curve.surface().mesh();
  const double shortest = kLongestStep / 2 * fields.geometry().meanEdge;
  const auto centerAt = [&](double t) {
    const CurveSample& start = from.status == SampleStatus::kConverged ? from : to;
    if (start.status != SampleStatus::kConverged) return CurveSample{t, start.point, start.status};
    const SearchEnd center = findCenter(fields, pieceOf(curve, at).weights(t), start.point,
                                        curve.options().field.method);
    return CurveSample{t, center.point, sampleStatus(center.status)};
  };
  while (to.t - from.t > kChainRounding &&
         (position(mesh, to.point) - position(mesh, from.point)).norm() > shortest) {
    const double t = (from.t + to.t) / 2;
    CurveSample center = centerAt(t);
    if (center.status != SampleStatus::kConverged) return center;
    (at.t < t ? to : from) = center;
  }
  return centerAt(at.t);
}

/// The derivatives of a piece's weights with respect to its t, by differences of second order that
/// stay inside [0, 1].
Array<double> weightDerivatives(const Curve::Piece& piece, double t) {
  // Central differences are most accurate if their step is about the cube root of the relative
  // rounding error.
  const double step = std::cbrt(kStepRounding);
  const double middle = std::clamp(t, step, 1 - step);
  const Array<double> before = piece.weights(middle - step);
  const Array<double> here = piece.weights(middle);
  const Array<double> after = piece.weights(middle + step);
  // The result is the derivative at t of the parabola through the three values.
  const double away = (t - middle) / step;
  Array<double> result;
  for (int i = 0; i < here.count(); ++i) {
    const double slope = (after[i] - before[i]) / 2;
    const double bend = after[i] - 2 * here[i] + before[i];
    result.push_back((slope + away * bend) / step);
  }
  return result;
}

CurveTangent tangentOfPath(Curve& curve, const CurvePoint& at, const PathPiece& piece) {
  const SurfacePath& path = piece.path;
  const Geometry& geometry = curve.surface().geometry();
  const int k = pieceAt(path.lengths, piece.s * path.length());
  const SurfacePoint& from = path.points[k];
  const SurfacePoint& to = path.points[k + 1];
  const int face = commonFace(*geometry.mesh, from, to);
  const double length = path.lengths[k + 1] - path.lengths[k];
  CurveTangent tangent{at};
  if (face < 0 || !(length > 0)) return tangent;
  tangent.at.point = pointAlong(*geometry.mesh, path, piece.s * path.length());
  tangent.at.point = inFace(*geometry.mesh, tangent.at.point, face);
  const Vec2 along = stepInFace(geometry, face, from, to);
  tangent.inFace = curve.piecesPerSegment() * path.length() / piece.duration / length * along;
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

CurvePoint pointAt(Curve& curve, const SegmentParameter& parameter) {
  const double whole = parameter.segment + parameter.t;
  const PieceParameter at = inPiece(curve, parameter);
  const Array<CurveSample>& samples = pieceOf(curve, at).samples();
  const int i = sampleAfter(samples, at.t);
  for (const CurveSample& sample : {samples[i - 1], samples[i]}) {
    if (sample.t == at.t) return {whole, sample.point, sample.status};
  }
  if (const Bridge* bridge = bridgeOver(pieceOf(curve, at).bridges(), at.t)) {
    return {whole, pointAt(curve.surface().mesh(), *bridge, at.t), statusOn(*bridge)};
  }
  SampleStatus status = SampleStatus::kConverged;
  if (curve.isOfCenters()) {
    FieldBlend fields = blendOf(curve, at);
    const CurveSample center = centerBetween(curve, fields, at, samples[i - 1], samples[i]);
    if (center.status == SampleStatus::kConverged) return {whole, center.point, center.status};
    status = center.status;
  }
  const auto [path, s, duration] = pathAround(curve, at);
  return {whole, pointAlong(curve.surface().mesh(), path, s * path.length()), status};
}

CurveTangent tangentAt(Curve& curve, const SegmentParameter& parameter) {
  const CurvePoint point = pointAt(curve, parameter);
  const PieceParameter at = inPiece(curve, parameter);
  if (!curve.isOfCenters() || pieceOf(curve, at).isSubdivided() ||
      point.status != SampleStatus::kConverged) {
    return tangentOfPath(curve, point, pathAround(curve, at));
  }
  const Geometry& geometry = curve.surface().geometry();
  const Curve::Piece& piece = pieceOf(curve, at);
  const int face = point.point.face;
  FieldBlend fields = blendOf(curve, at);
  const CellPoint place = fields.cells().at(point.point);
  const auto [alongX, alongY] =
      fields.jacobian(place.cell, fields.blend(place.cell, piece.weights(at.t)));
  const Vec2 wanted = -fields.blend(place.cell, weightDerivatives(piece, at.t)).at(place.bary);
  const double determinant = cross(alongX, alongY);
  const Vec2 inFace = curve.piecesPerSegment() *
                      rotate(fields.axisInFace(place.cell),
                             Vec2(cross(wanted, alongY), cross(alongX, wanted)) / determinant);
  if (!std::isfinite(inFace.x()) || !std::isfinite(inFace.y())) {
    return tangentOfPath(curve, point, pathAround(curve, at));
  }
  return {point, inFace, toSpace(geometry, face, inFace)};
}

}  // namespace karcher

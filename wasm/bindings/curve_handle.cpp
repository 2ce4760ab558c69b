#include "bindings/curve_handle.h"

#include <utility>

namespace karcher::bindings {

val samplesToJs(const MeshHandle& mesh, const Array<const Array<CurveSample>*>& segments) {
  Array<int> segment;
  Array<double> t;
  Array<int> face;
  Array<double> bary;
  Array<double> places;
  Array<uint8_t> status;
  for (int j = 0; j < segments.count(); ++j) {
    for (const CurveSample& sample : *segments[j]) {
      segment.push_back(j);
      t.push_back(sample.t);
      face.push_back(mesh.numbering().inputFace[sample.point.face]);
      append(bary, sample.point.bary);
      append(places, position(mesh.mesh(), sample.point));
      status.push_back(static_cast<uint8_t>(sample.status));
    }
  }
  val result = val::object();
  result.set("segment", toJs(segment));
  result.set("t", toJs(t));
  result.set("face", toJs(face));
  result.set("bary", toJs(bary));
  result.set("position", toJs(places));
  result.set("status", toJs(status));
  return result;
}

void appendSegment(const MeshHandle& mesh, const JoinedPath& segment, CurvePath& result) {
  const Array<int> kept =
      append(result.path, mesh.numbering(), mesh.mesh(), segment.points, segment.length);
  for (const int i : kept) result.unconverged.push_back(segment.unconverged[i]);
}

val bridgedToJs(const Array<const Array<Bridge>*>& segments) {
  val list = val::array();
  for (int j = 0; j < segments.count(); ++j) {
    for (const Bridge& bridge : *segments[j]) {
      val interval = val::object();
      interval.set("segment", j);
      interval.set("t0", bridge.t0);
      interval.set("t1", bridge.t1);
      interval.set("reason", std::string(statusName(bridge.reason)));
      list.call<void>("push", interval);
    }
  }
  return list;
}

void CurveHandle::movePoint(int i, const val& point) {
  curve_->movePoint(i, pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
}

void CurveHandle::dragPoint(int i, const val& point) {
  curve_->set(curve_->withPointDragged(i, pointFromJs(mesh_.numbering(), mesh_.mesh(), point)));
}

void CurveHandle::insertPoint(int i, const val& point) {
  curve_->insertPoint(i, pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
}

void CurveHandle::restore() {
  if (!kept_) return;
  curve_ = std::move(kept_);
  line_.reset();
}

void CurveHandle::join() { kept_.reset(); }

void CurveHandle::findSamples() { line_.reset(); }

val CurveHandle::points() const {
  Array<SurfacePoint> points;
  for (int i = 0; i < curve_->pointCount(); ++i) points.push_back(curve_->point(i));
  return toJs(mesh_.numbering(), points);
}

val CurveHandle::samples() const {
  Array<const Array<CurveSample>*> segments;
  for (int j = 0; j < curve_->segmentCount(); ++j) segments.push_back(&curve_->samples(j));
  return samplesToJs(mesh_, segments);
}

val CurveHandle::bridged() const {
  Array<const Array<Bridge>*> segments;
  for (int j = 0; j < curve_->segmentCount(); ++j) segments.push_back(&curve_->bridges(j));
  return bridgedToJs(segments);
}

val CurveHandle::path() const { return toJs(curvePath().path); }

val CurveHandle::polyline(bool inDouble) const {
  const Array<double> positions = curvePath().path.positions;
  if (inDouble) return toJs(positions);
  return toJs(std::vector<float>(positions.begin(), positions.end()));
}

val CurveHandle::unconverged() const { return toJs(curvePath().unconverged); }

double CurveHandle::length() const {
  double length = 0;
  for (int j = 0; j < curve_->segmentCount(); ++j) length += curve_->path(j).length;
  return length;
}

CurvePath CurveHandle::curvePath() const {
  CurvePath line;
  line.path.closed = curve_->shape().closed;
  for (int j = 0; j < curve_->segmentCount(); ++j) {
    appendSegment(mesh_, curve_->path(j), line);
  }
  return line;
}

void CurveHandle::setPoints(const val& points) {
  CurveValue value = curve_->value();
  value.points = pointsFromJs(mesh_.numbering(), mesh_.mesh(), points);
  value.legs.clear();
  curve_->set(std::move(value));
}

void CurveHandle::setWeights(const val& weights) {
  // Refuses kinds that have none.
  CurveValue value = withWeight(curve_->value(), 0, 1);
  value.options.shape.weights = fromJs<double>(weights);
  curve_->set(std::move(value));
}

void CurveHandle::setBetas(const val& betas) {
  CurveValue value = withBeta(curve_->value(), 0, 1);
  value.options.shape.betas = fromJs<double>(betas);
  curve_->set(std::move(value));
}

int CurveHandle::insertOnCurve(double parameter) {
  const RefinedCurve refined = withPointOnCurve(*curve_, parameter);
  CurveValue value = curve_->value();
  value.options.shape = refined.curve.shape;
  value.points = refined.curve.points;
  value.legs.clear();
  curve_->set(std::move(value));
  return refined.point;
}

val CurveHandle::splitAt(double parameter) {
  const Array<CurveParts> parts = karcher::splitAt(*curve_, parameter);
  val list = val::array();
  for (int i = 0; i < parts.count(); ++i) list.set(i, toJs(mesh_.numbering(), parts[i]));
  return list;
}

val CurveHandle::joined(const CurveHandle& other) {
  return toJs(mesh_.numbering(), karcher::joined(*curve_, *other.curve_));
}

val CurveHandle::pointAt(double parameter) {
  return curvePointToJs(karcher::pointAt(*curve_, parameter));
}

val CurveHandle::tangentAt(double parameter) {
  const CurveTangent tangent = karcher::tangentAt(*curve_, parameter);
  const SurfacePoint& point = tangent.at.point;
  const Geometry& geometry = mesh_.surface().geometry();
  val result = curvePointToJs(tangent.at);
  // In the face's own corners, since its frame is the engine's: changes of barycentric weights.
  const Vec3 weights = barycentric(geometry, point.face, tangent.inFace) -
                       barycentric(geometry, point.face, Vec2::Zero());
  result.set("inFace", toJs(weights));
  result.set("inSpace", toJs(tangent.inSpace));
  return result;
}

val CurveHandle::nearest(const val& place) {
  const Array<double> numbers = fromJs<double>(place);
  const NearestOnCurve nearest =
      nearestOnCurve(*curve_, line(), {numbers[0], numbers[1], numbers[2]});
  val result = curvePointToJs(nearest.at);
  result.set("distance", nearest.distance);
  return result;
}

double CurveHandle::lengthAt(double parameter) {
  return karcher::lengthAt(*curve_, line(), parameter);
}

val CurveHandle::pointAtLength(double length) {
  return curvePointToJs(karcher::pointAtLength(*curve_, line(), length));
}

val CurveHandle::equallySpaced(int count) {
  Array<double> parameters;
  Array<int> faces;
  Array<double> bary;
  Array<double> places;
  for (const CurvePoint& at : karcher::equallySpaced(*curve_, line(), count)) {
    parameters.push_back(at.parameter);
    faces.push_back(mesh_.numbering().inputFace[at.point.face]);
    append(bary, at.point.bary);
    append(places, position(mesh_.mesh(), at.point));
  }
  val result = val::object();
  result.set("parameter", toJs(parameters));
  result.set("face", toJs(faces));
  result.set("bary", toJs(bary));
  result.set("position", toJs(places));
  return result;
}

const CurveLine& CurveHandle::line() {
  if (!line_) line_ = lineOf(*curve_);
  return *line_;
}

val CurveHandle::curvePointToJs(const CurvePoint& at) const {
  val result = val::object();
  result.set("parameter", at.parameter);
  result.set("point", toJs(mesh_.numbering(), at.point));
  result.set("position", toJs(position(mesh_.mesh(), at.point)));
  result.set("status", std::string(statusName(at.status)));
  return result;
}

}  // namespace karcher::bindings

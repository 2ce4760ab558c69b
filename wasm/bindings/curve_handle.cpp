#include "bindings/curve_handle.h"

#include <emscripten/emscripten.h>

#include <utility>

#include "curves/kept_legs.h"
#include "curves/spec/knots.h"
#include "mesh/error.h"

namespace karcher::bindings {

CurveHandle::CurveHandle(MeshHandle& mesh, const val& value)
    : mesh_(mesh),
      curve_(mesh.fieldSets(), curveValueFromJs(mesh, value, legs_), emscripten_get_now) {}

val CurveHandle::set(const val& value, const val& options) {
  CurveValue next = curveValueFromJs(mesh_, value, legs_);
  checkGivenShape(next.options.shape, next.points.count());
  become(std::move(next));
  return view(options);
}

val CurveHandle::view(const val& options) const {
  const CurveShape& shape = curve_.shape();
  TracedLine line;
  line.closed = shape.closed;
  line.levels = curve_.levels();
  for (int j = 0; j < curve_.segmentCount(); ++j) {
    line.samples.push_back(&curve_.samples(j));
    line.bridges.push_back(&curve_.bridges(j));
    line.paths.push_back(&curve_.path(j));
  }
  for (const SurfacePath& leg : curve_.usedLegs()) line.legs.push_back(&leg);
  if (shape.kind == CurveKind::kBSpline) line.knots = knotsOf(shape, curve_.pointCount());
  const StageTimes& times = curve_.times();
  line.times = {times.polygon, times.fields, times.samples, times.bridges, times.joins};
  return viewToJs(mesh_, line, viewOptionsFromJs(options));
}

val CurveHandle::value() const {
  return toJs(mesh_, {curve_.shape(), curve_.points(), curve_.value().legs});
}

int CurveHandle::edit(const std::string& name, int i, const val& to) {
  const Numbering& numbering = mesh_.numbering();
  const TriangleMesh& mesh = mesh_.mesh();
  const auto number = [&] { return to.as<double>(); };
  if (name == "movePoint") {
    curve_.movePoint(i, pointFromJs(numbering, mesh, to));
  } else if (name == "dragPoint") {
    curve_.dragPoint(i, pointFromJs(numbering, mesh, to));
  } else if (name == "insertPoint") {
    curve_.insertPoint(i, pointFromJs(numbering, mesh, to));
  } else if (name == "removePoint") {
    curve_.removePoint(i);
  } else if (name == "movePointInOrder") {
    curve_.movePointInOrder(i, static_cast<int>(number()));
  } else if (name == "reverse") {
    curve_.reverse();
  } else if (name == "setKind") {
    curve_.setKind(curveKind(to.as<std::string>()));
  } else if (name == "setClosed") {
    curve_.setClosed(to.as<bool>());
  } else if (name == "setWeight") {
    curve_.setWeight(i, number());
  } else if (name == "setBeta") {
    curve_.setBeta(i, number());
  } else if (name == "setPoints") {
    curve_.set(withPoints(curve_.value(), pointsFromJs(numbering, mesh, to)));
  } else if (name == "setWeights") {
    // `withWeight` refuses kinds without weights.
    CurveValue value = withWeight(curve_.value(), 0, 1);
    value.options.shape.weights = fromJs<double>(to);
    curve_.set(std::move(value));
  } else if (name == "setBetas") {
    CurveValue value = withBeta(curve_.value(), 0, 1);
    value.options.shape.betas = fromJs<double>(to);
    curve_.set(std::move(value));
  } else if (name == "insertOnCurve") {
    return insertOnCurve(number());
  } else {
    throw Error(ErrorCode::kBadArgument, "there is no edit '" + name + "'");
  }
  line_.reset();
  return i;
}

int CurveHandle::insertOnCurve(double parameter) {
  RefinedCurve refined = withPointOnCurve(curve_, parameter);
  CurveValue value = curve_.value();
  value.options.shape = std::move(refined.curve.shape);
  value.points = std::move(refined.curve.points);
  value.legs = std::move(refined.curve.legs);
  become(std::move(value));
  return refined.point;
}

val CurveHandle::splitAt(double parameter) {
  const Array<CurveParts> parts = karcher::splitAt(curve_, parameter);
  val list = val::array();
  for (int i = 0; i < parts.count(); ++i) list.set(i, toJs(mesh_, parts[i]));
  return list;
}

val CurveHandle::joined(const CurveHandle& other) {
  return toJs(mesh_, karcher::joined(curve_, other.curve_));
}

val CurveHandle::pointAt(double parameter) {
  return curvePointToJs(karcher::pointAt(curve_, parameter));
}

val CurveHandle::tangentAt(double parameter) {
  const CurveTangent tangent = karcher::tangentAt(curve_, parameter);
  const SurfacePoint& point = tangent.at.point;
  const Geometry& geometry = mesh_.surface().geometry();
  val result = curvePointToJs(tangent.at);
  // JavaScript receives the derivative as changes of barycentric weights, since only the engine
  // knows the face's frame.
  const Vec3 weights = barycentric(geometry, point.face, tangent.inFace) -
                       barycentric(geometry, point.face, Vec2::Zero());
  result.set("inFace", toJs(changeToInput(mesh_.numbering(), point.face, weights)));
  result.set("inSpace", toJs(tangent.inSpace));
  return result;
}

val CurveHandle::nearest(const val& place) {
  const Array<double> numbers = fromJs<double>(place);
  const NearestOnCurve nearest =
      nearestOnCurve(curve_, line(), {numbers[0], numbers[1], numbers[2]});
  val result = curvePointToJs(nearest.at);
  result.set("distance", nearest.distance);
  return result;
}

double CurveHandle::lengthAt(double parameter) {
  return karcher::lengthAt(curve_, line(), parameter);
}

val CurveHandle::pointAtLength(double length) {
  return curvePointToJs(karcher::pointAtLength(curve_, line(), length));
}

val CurveHandle::equallySpaced(int count) {
  Array<double> parameters;
  Array<int> faces;
  Array<double> bary;
  Array<double> places;
  for (const CurvePoint& at : karcher::equallySpaced(curve_, line(), count)) {
    parameters.push_back(at.parameter);
    const SurfacePoint input = toInput(mesh_.numbering(), at.point);
    faces.push_back(input.face);
    append(bary, input.bary);
    append(places, position(mesh_.mesh(), at.point));
  }
  val result = val::object();
  result.set("parameter", toJs(parameters));
  result.set("face", toJs(faces));
  result.set("bary", toJs(bary));
  result.set("position", toJs(places));
  return result;
}

void CurveHandle::become(CurveValue value) {
  curve_.set(std::move(value));
  line_.reset();
}

const CurveLine& CurveHandle::line() {
  if (!line_) line_ = lineOf(curve_);
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

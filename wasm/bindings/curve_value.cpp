#include "bindings/curve_value.h"

#include <utility>

#include "bindings/field_options.h"
#include "mesh/error.h"

namespace karcher::bindings {

CurveKind curveKind(const std::string& name) {
  for (const CurveKind kind : kCurveKinds) {
    if (name == curveKindName(kind)) return kind;
  }
  throw Error(ErrorCode::kBadArgument, "there is no kind of curve '" + name + "'");
}

namespace {

val plain(const CurveShape& shape) {
  val result = val::object();
  result.set("kind", std::string(curveKindName(shape.kind)));
  result.set("closed", shape.closed);
  result.set("degree", shape.degree);
  result.set("clamped", shape.knotRule == KnotRule::kClamped);
  result.set("knots", toJs(shape.knots));
  result.set("weights", toJs(shape.weights));
  result.set("betas", toJs(shape.betas));
  result.set("centripetal", shape.centripetal);
  return result;
}

CurveShape shapeFromJs(const val& shape) {
  CurveShape result;
  result.kind = curveKind(shape["kind"].as<std::string>());
  result.closed = shape["closed"].as<bool>();
  result.degree = shape["degree"].as<int>();
  result.knots = fromJs<double>(shape["knots"]);
  result.knotRule = shape["clamped"].as<bool>() ? KnotRule::kClamped
                    : result.knots.empty()      ? KnotRule::kUniform
                                                : KnotRule::kOwn;
  result.centripetal = shape["centripetal"].as<bool>();
  result.weights = fromJs<double>(shape["weights"]);
  result.betas = fromJs<double>(shape["betas"]);
  const val basis = shape["basis"];
  if (!basis.isUndefined()) {
    result.basis = std::make_shared<const OwnBasis>(
        [basis](int points, double t) { return fromJs<double>(basis(points, t)); });
  }
  return result;
}

}  // namespace

CurveValue curveValueFromJs(const MeshHandle& mesh, const val& value, Legs& legs) {
  const val sampling = value["sampling"];
  CurveOptions options{
      shapeFromJs(value["shape"]), sampling["samples"].as<int>(),
      fieldOptionsFromJs(value["field"]), sampling["tolerance"].as<double>(),
      sampling["exact"].as<bool>() ? CurveGeometry::kExact : CurveGeometry::kGeodesic};
  options.levels = sampling["levels"].as<int>();
  options.leastLevels = sampling["leastLevels"].as<int>();
  options.levelsTolerance = sampling["levelsTolerance"].as<double>();
  Array<SurfacePoint> points = pointsFromJs(mesh.numbering(), mesh.mesh(), value["points"]);
  Array<SurfacePath> paths = legs.fromJs(mesh, points, value["legs"], value["areDrawn"]);
  return {std::move(options), std::move(points), std::move(paths)};
}

val toJs(const MeshHandle& mesh, const CurveParts& parts) {
  val result = plain(parts.shape);
  result.set("points", toJs(mesh.numbering(), parts.points));
  // The shortest legs of a polyline are exact shortest paths, so the search must be certified.
  const bool isPolyline = parts.shape.kind == CurveKind::kPolyline;
  result.set("legs", legsToJs(mesh, parts.legs, {.certified = isPolyline}));
  return result;
}

}  // namespace karcher::bindings

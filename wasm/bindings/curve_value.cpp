#include "bindings/curve_value.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bindings/field_options.h"
#include "bindings/path.h"
#include "distance/find_path.h"
#include "distance/waypoints.h"
#include "mesh/error.h"

namespace karcher::bindings {

CurveKind curveKind(const std::string& name) {
  for (const CurveKind kind : kCurveKinds) {
    if (name == curveKindName(kind)) return kind;
  }
  throw Error(ErrorCode::kBadArgument, "there is no kind of curve '" + name + "'");
}

namespace {

/// Paths count as equally short if the relative difference of their lengths is below this.
constexpr double kSameLength = 1e-9;

/// Weights below this limit come from rounding. For example, a link may have only two weights of a
/// point; the third weight is then computed.
constexpr double kNoWeight = 1e-15;

/// The same points, but points that are on an edge up to rounding are moved onto the edge.
Array<SurfacePoint> onEdges(Array<SurfacePoint> points) {
  for (SurfacePoint& point : points) {
    for (int k = 0; k < 3; ++k) {
      if (point.bary[k] < kNoWeight) point.bary[k] = 0;
    }
  }
  return points;
}

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

/// The legs of a curve's value in the form for JavaScript (see Legs). A search with the options
/// `shortest` recognises the shortest legs.
val legsToJs(const MeshHandle& mesh, const Array<SurfacePath>& legs,
             const FindPathOptions& shortest) {
  val list = val::array();
  FindPathWorkspace workspace;
  for (int i = 0; i < legs.count(); ++i) {
    Array<SurfacePoint> waypoints;
    if (!legs[i].points.empty()) {
      waypoints = waypointsOf(mesh.geometry(), legs[i], workspace, shortest);
    }
    list.set(i, toJs(mesh.numbering(), waypoints));
  }
  return list;
}

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

Array<SurfacePath> Legs::fromJs(const MeshHandle& mesh, const Array<SurfacePoint>& points,
                                const val& legs, const val& areDrawn) {
  const Geometry& geometry = mesh.geometry();
  const Array<int> drawn = bindings::fromJs<int>(areDrawn);
  Array<SurfacePath> paths;
  Array<Leg> known;
  FindPathWorkspace workspace;
  const int count = legs["length"].as<int>();
  for (int i = 0; i < count; ++i) {
    paths.emplace_back();
    // The engine rejects a curve with more legs than points.
    if (i >= points.count()) continue;
    Array<SurfacePoint> given = pointsFromJs(mesh.numbering(), mesh.mesh(), legs[i]);
    if (given.count() < (drawn[i] ? 2 : 1)) continue;
    Leg leg{points[i], points[(i + 1) % points.count()], {}, {}};
    if (drawn[i]) {
      leg.from = given.front();
      leg.to = given.back();
      given.erase(given.begin());
      given.pop_back();
    }
    leg.waypoints = onEdges(std::move(given));
    const auto isIt = [&](const Leg& other) {
      return isSame(other.from, leg.from) && isSame(other.to, leg.to) &&
             std::equal(other.waypoints.begin(), other.waypoints.end(), leg.waypoints.begin(),
                        leg.waypoints.end(), isSame);
    };
    const auto before = std::find_if(known_.begin(), known_.end(), isIt);
    if (before != known_.end()) {
      leg.path = before->path;
    } else if (!findPathBy(geometry, leg.from, leg.waypoints, leg.to, workspace, leg.path)) {
      throw Error(ErrorCode::kUnreachable,
                  "leg " + std::to_string(i) +
                      " goes through a point on another component than one of its ends");
    }
    paths.back() = leg.path;
    known.push_back(std::move(leg));
  }
  known_ = std::move(known);
  return paths;
}

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

val legsAndShorterToJs(const MeshHandle& mesh, Curve& curve) {
  val list = val::array();
  FindPathWorkspace workspace;
  const auto pathOf = [&](const SurfacePath& path) {
    return pathToJs(mesh.numbering(), mesh.mesh(), path.points, path.length());
  };
  const Array<SurfacePath>& legs = curve.legs();
  const Array<SurfacePath>& given = curve.value().legs;
  for (int i = 0; i < legs.count(); ++i) {
    val leg = val::object();
    leg.set("path", pathOf(legs[i]));
    SurfacePath shorter;
    if (!given.empty() && !given[i].points.empty() &&
        findPath(mesh.geometry(), legs[i].start(), legs[i].end(), workspace, shorter) &&
        shorter.length() < legs[i].length() * (1 - kSameLength)) {
      leg.set("shorter", pathOf(shorter));
    }
    list.set(i, leg);
  }
  return list;
}

}  // namespace karcher::bindings

#include "curves/refine/refine.h"

#include <algorithm>
#include <string>

#include "curves/query/evaluate.h"
#include "curves/refine/knot_insertion.h"
#include "curves/spec/knots.h"
#include "distance/find_path.h"
#include "intrinsic/straighten.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

bool isBezier(CurveKind kind) { return kind == CurveKind::kBezier || kind == CurveKind::kRational; }

Array<WeightedPoint> weightedPoints(const Curve& curve) {
  const bool weighted = takesWeights(curve.shape().kind) && !curve.shape().weights.empty();
  Array<WeightedPoint> points;
  for (int i = 0; i < curve.pointCount(); ++i) {
    points.push_back({curve.point(i), weighted ? curve.shape().weights[i] : 1});
  }
  return points;
}

/// Sets points and weights. Weights that are all 1 are omitted.
void setPoints(CurveParts& parts, const Array<WeightedPoint>& points) {
  parts.points.clear();
  parts.shape.weights.clear();
  bool weighted = false;
  for (const WeightedPoint& point : points) {
    parts.points.push_back(point.point);
    parts.shape.weights.push_back(point.weight);
    weighted = weighted || point.weight != 1;
  }
  if (!weighted) parts.shape.weights.clear();
}

/// Whether the curve uses legs and its value gives at least one of them.
bool followsLegs(const Curve& curve) {
  const auto isGiven = [](const SurfacePath& leg) { return !leg.points.empty(); };
  const Array<SurfacePath>& given = curve.value().legs;
  return !curve.usedLegs().empty() && std::any_of(given.begin(), given.end(), isGiven);
}

/// The legs on which new points lie: the legs that the curve uses, or the fast paths between its
/// points if it uses none.
Array<SurfacePath> legsOf(const Curve& curve) {
  if (!curve.usedLegs().empty()) return curve.usedLegs();
  const int points = curve.pointCount();
  Array<SurfacePath> legs(static_cast<size_t>(legCount(curve.shape(), points)));
  FindPathWorkspace workspace;
  for (int i = 0; i < legs.count(); ++i) {
    // The points lie on one component.
    findPath(curve.surface().geometry(), curve.point(i), curve.point((i + 1) % points), workspace,
             legs[i]);
  }
  return legs;
}

ControlPolygon polygonOf(const Curve& curve) {
  const CurveShape& shape = curve.shape();
  return {weightedPoints(curve), legsOf(curve), knotsOf(shape, curve.pointCount()), shape.degree,
          shape.closed};
}

CurveParts partsOf(ControlPolygon polygon) {
  CurveParts parts{{CurveKind::kBSpline, polygon.closed, polygon.degree, KnotRule::kOwn},
                   {},
                   std::move(polygon.legs)};
  parts.shape.knots = std::move(polygon.knots);
  setPoints(parts, polygon.points);
  return parts;
}

/// The given parts, without their legs if the curve does not follow given legs.
CurveParts alike(const Curve& curve, CurveParts parts) {
  if (!followsLegs(curve)) parts.legs.clear();
  return parts;
}

/// The segment parameter of a parameter. Beside a joint within rounding, it is that of the joint.
SegmentParameter snappedParameter(const Curve& curve, double parameter) {
  SegmentParameter at = segmentParameter(curve, parameter);
  if (at.t <= kLocalRounding) at.t = 0;
  if (at.t >= 1 - kLocalRounding) at.t = 1;
  return at;
}

/// The knot of a B-spline at a parameter; segments are the nonempty spans. For the end of a closed
/// curve it is the first knot.
double knotAtParameter(const ControlPolygon& polygon, const SegmentParameter& at) {
  const auto knot = [&](int j) {
    return knotOfSpan(polygon.knots, polygon.degree, polygon.closed, j);
  };
  int span = -1;
  for (int segment = -1; segment < at.segment;) segment += knot(span + 2) > knot(span + 1), ++span;
  const double end = knot(span + 1);
  const double u = at.t == 1 ? end : knot(span) + at.t * (end - knot(span));
  return polygon.closed && u == polygon.knots.back() ? polygon.knots.front() : u;
}

/// The polygon of a Bezier curve. If the curve is closed, its polygon ends at the first point.
LeggedPolygon bezierPolygon(const Curve& curve) {
  LeggedPolygon bezier{weightedPoints(curve), legsOf(curve)};
  if (curve.shape().closed) bezier.points.push_back(WeightedPoint(bezier.points[0]));
  return bezier;
}

/// A Bezier curve as a clamped B-spline of one segment.
ControlPolygon splineOf(LeggedPolygon bezier) {
  const int points = bezier.points.count();
  return {std::move(bezier.points), std::move(bezier.legs), clampedKnots(points, points - 1),
          points - 1, false};
}

/// Replaces the logarithms of betas by the betas. A common factor, which does not change the curve,
/// makes the largest beta 1. If the smallest beta would then be too small, the factor makes the
/// product of the smallest and the largest beta 1. Throws Error kBadArgument if this does not
/// suffice.
void setBetas(Array<double>& logs) {
  const auto [least, most] = std::minmax_element(logs.begin(), logs.end());
  const double range = *most - *least;
  const double limit = -std::log(kLeastWeight);
  if (!(range <= 2 * limit)) {
    refuse("a barycentric curve of these " + std::to_string(logs.count()) +
           " points would need betas that differ by a factor of 1e" +
           inSentence(std::ceil(range / std::log(10.0))) + "; betas go from 1e-12 to 1e12");
  }
  const double unit = range <= limit ? *most : (*least + *most) / 2;
  // Rounding must not exceed the limits.
  for (double& beta : logs) {
    beta = std::clamp(std::exp(beta - unit), kLeastWeight, 1 / kLeastWeight);
  }
}

/// The part of a barycentric curve from `from` to `to`, with `nodes` evenly spaced nodes. The curve
/// is p / q with polynomials p and q. In barycentric form with the new nodes, the control points
/// are the curve's points at the nodes. The beta of a node is |q| there, times the binomial
/// coefficient, which is the beta of a polynomial.
CurveParts barycentricPart(Curve& curve, double from, double to, int nodes) {
  Array<double> betas = curve.shape().betas;
  betas.resize(static_cast<size_t>(curve.pointCount()), 1);
  if (curve.shape().closed) betas.push_back(double(betas[0]));
  const int degree = betas.count() - 1;
  // log |q| at t, up to a constant.
  const auto logDenominator = [&](double t) {
    double product = 0;
    double sum = 0;
    for (int i = 0; i <= degree; ++i) {
      const double gap = t - static_cast<double>(i) / degree;
      if (std::abs(gap) < 1e-14) {
        double others = std::log(betas[i]);
        for (int k = 0; k <= degree; ++k) {
          if (k != i) others += std::log(std::abs(i - k) / static_cast<double>(degree));
        }
        return others;
      }
      product += std::log(std::abs(gap));
      sum += (i % 2 == 0 ? betas[i] : -betas[i]) / gap;
    }
    return product + std::log(std::abs(sum));
  };
  CurveParts parts{{CurveKind::kBarycentric}, {}};
  const int last = nodes - 1;
  double binomial = 0;
  for (int k = 0; k <= last; ++k) {
    const double t = k == last ? to : from + (to - from) * k / last;
    parts.points.push_back(pointAt(curve, {0, t}).point);
    parts.shape.betas.push_back(binomial + logDenominator(t));
    binomial += std::log(static_cast<double>(last - k) / (k + 1));
  }
  setBetas(parts.shape.betas);
  return parts;
}

[[noreturn]] void refuseOwnBasis() {
  refuse("a curve with its own basis can be neither refined, split nor joined");
}

/// A point of a Catmull-Rom curve or polyline, and the two parts of the leg that it cuts. If the
/// leg is omitted, and so stands for the shortest path, the parts are omitted, too.
struct CutThroughPoints {
  SurfacePoint point;
  SurfacePath before;
  SurfacePath after;
};

/// Writes the two parts of a leg before and after the fraction t of its length. The parts meet on
/// the leg, or at a point `cut` near the leg if one is given. A part that cannot lead to `cut` has
/// no points.
void cutLeg(const Geometry& geometry, const SurfacePath& leg, double t, const SurfacePoint* cut,
            SurfacePath& before, SurfacePath& after) {
  const double at = t * leg.length();
  takePart(*geometry.mesh, leg, 0, at, before);
  takePart(*geometry.mesh, leg, at, leg.length(), after);
  if (!cut) return;
  StripWorkspace strip;
  if (!moveEnd(geometry, *cut, before, strip)) before = {};
  if (!moveStart(geometry, *cut, after, strip)) after = {};
}

CutThroughPoints cutThroughPoints(Curve& curve, const SegmentParameter& at) {
  CutThroughPoints cut{pointAt(curve, at).point, {}, {}};
  if (!followsLegs(curve)) return cut;
  const SurfacePath& leg = curve.value().legs[at.segment];
  if (leg.points.empty()) return cut;
  // A polyline's points lie on the leg.
  const bool isOnLeg = curve.shape().kind == CurveKind::kPolyline;
  const SurfacePoint point = cut.point;
  cutLeg(curve.surface().geometry(), leg, at.t, isOnLeg ? nullptr : &point, cut.before, cut.after);
  if (isOnLeg) cut.point = cut.before.end();
  return cut;
}

/// The part of a Catmull-Rom curve or polyline from point `from` to point `to`. On a closed curve,
/// `to` may go past the last point.
CurveParts partThrough(const Curve& curve, int from, int to) {
  CurveParts part{{curve.shape().kind}, {}};
  part.shape.centripetal = curve.shape().centripetal;
  const bool hasLegs = followsLegs(curve);
  for (int i = from; i <= to; ++i) part.points.push_back(curve.point(i % curve.pointCount()));
  for (int i = from; hasLegs && i < to; ++i) {
    part.legs.push_back(curve.value().legs[i % curve.pointCount()]);
  }
  return part;
}

void lengthen(const Curve& curve, CurveParts& part, bool atStart, const SurfacePoint& point,
              const SurfacePath& leg) {
  part.points.insert(atStart ? part.points.begin() : part.points.end(), point);
  if (followsLegs(curve)) part.legs.insert(atStart ? part.legs.begin() : part.legs.end(), leg);
}

/// The parts of a Catmull-Rom curve or polyline before and after a parameter.
Array<CurveParts> splitThroughPoint(Curve& curve, const SegmentParameter& at) {
  const int before = at.segment + (at.t == 1 ? 1 : 0);
  const bool atPoint = at.t == 0 || at.t == 1;
  const int last = curve.pointCount() - 1;
  CutThroughPoints cut;
  if (!atPoint) cut = cutThroughPoints(curve, at);
  Array<CurveParts> parts;
  if (curve.shape().closed) {
    // The part leads from the cut once around the curve, back to the cut.
    parts.push_back(partThrough(curve, atPoint ? before : before + 1, before + last + 1));
  } else {
    parts.push_back(partThrough(curve, 0, before));
    parts.push_back(partThrough(curve, atPoint ? before : before + 1, last));
  }
  if (!atPoint) {
    lengthen(curve, parts.front(), false, cut.point, cut.before);
    lengthen(curve, parts.back(), true, cut.point, cut.after);
  }
  return parts;
}

/// Whether two points of one component are one place of the surface up to rounding. If not,
/// `between` is a geodesic from one to the other. On both banks of a slit, points at one place in
/// space are two places.
bool doMeet(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
            SurfacePath& between) {
  FindPathWorkspace workspace;
  findPath(geometry, from, to, workspace, between);
  return between.length() <= kChainRounding * geometry.diagonal;
}

/// The legs of two joined curves, with `between` shortest paths between them. If `between` is 0,
/// the second curve starts at `end`, the end of the first. The result is empty if neither curve has
/// legs.
Array<SurfacePath> joinedLegs(const Geometry& geometry, Array<SurfacePath> first, int firstCount,
                              Array<SurfacePath> second, int secondCount, int between,
                              const SurfacePoint& end) {
  if (first.empty() && second.empty()) return {};
  first.resize(static_cast<size_t>(firstCount + between));
  second.resize(static_cast<size_t>(secondCount));
  SurfacePath& next = second.front();
  if (between == 0 && !next.points.empty() &&
      position(*geometry.mesh, next.start()) != position(*geometry.mesh, end)) {
    StripWorkspace strip;
    if (!moveStart(geometry, end, next, strip)) next = {};
  }
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Joins two B-splines of the same degree to one, the first clamped at its end, the second at its
/// start. If they do not meet, a geodesic connects them.
ControlPolygon joinedPolygons(const Geometry& geometry, const ControlPolygon& first,
                              const ControlPolygon& second) {
  const int p = first.degree;
  ControlPolygon result = first;
  Array<WeightedPoint> points = second.points;
  const double factor = first.points.back().weight / points.front().weight;
  for (WeightedPoint& point : points) point.weight *= factor;
  const WeightedPoint from = first.points.back();
  const WeightedPoint to = points.front();
  result.knots.pop_back();
  double start = first.knots.back();
  SurfacePath between;
  const bool meet = doMeet(geometry, from.point, to.point, between);
  if (!meet) {
    for (int k = 1; k < p; ++k) {
      const double s = static_cast<double>(k) / p;
      result.points.push_back(
          averageOn(*geometry.mesh, between, (1 - s) * from.weight, s * to.weight).point);
    }
    // The new span has the mean length of the first curve's spans.
    start += (first.knots.back() - first.knots[p]) / (first.knots.count() - 2 * p - 1);
    result.knots.insert(result.knots.end(), static_cast<size_t>(p), start);
  }
  result.points.insert(result.points.end(), points.begin() + (meet ? 1 : 0), points.end());
  for (int k = p + 1; k < second.knots.count(); ++k) {
    result.knots.push_back(start + second.knots[k] - second.knots[p]);
  }
  result.legs = joinedLegs(geometry, first.legs, first.points.count() - 1, second.legs,
                           points.count() - 1, meet ? 0 : p, from.point);
  return result;
}

/// Joins two B-splines to one: clamps the first at its end and the second at its start.
CurveParts joinedSplines(const Curve& first, const Curve& second, ControlPolygon a,
                         ControlPolygon b) {
  const Geometry& geometry = first.surface().geometry();
  const double end = a.knots[a.points.count()];
  const double start = b.knots[b.degree];
  a = partBefore(geometry, std::move(a), end);
  b = partAfter(geometry, std::move(b), start);
  if (!followsLegs(first)) a.legs.clear();
  if (!followsLegs(second)) b.legs.clear();
  return partsOf(joinedPolygons(geometry, a, b));
}

}  // namespace

RefinedCurve withPointOnCurve(Curve& curve, double parameter) {
  const SegmentParameter at = snappedParameter(curve, parameter);
  const CurveShape& shape = curve.shape();
  const Geometry& geometry = curve.surface().geometry();
  if (shape.kind == CurveKind::kOwn) refuseOwnBasis();
  if (shape.kind == CurveKind::kBSpline) {
    ControlPolygon polygon = polygonOf(curve);
    const double knot = knotAtParameter(polygon, at);
    const int repeats = multiplicity(polygon, knot);
    if (repeats >= shape.degree) {
      refuse("the curve has a knot there that is repeated " + std::to_string(repeats) +
             " times; in degree " + std::to_string(shape.degree) + " it takes no more");
    }
    const int first = insertKnot(geometry, polygon, knot);
    const int points = polygon.points.count();
    return {alike(curve, partsOf(std::move(polygon))),
            (first + (shape.degree - repeats - 1) / 2) % points};
  }
  if (isBezier(shape.kind) || shape.kind == CurveKind::kBarycentric) {
    RefinedCurve refined;
    const int points = curve.pointCount() + (shape.closed ? 1 : 0) + 1;
    if (isBezier(shape.kind)) {
      LeggedPolygon more = elevated(geometry, bezierPolygon(curve));
      refined.curve.shape = {shape.kind, shape.closed};
      setPoints(refined.curve, more.points);
      if (followsLegs(curve)) refined.curve.legs = std::move(more.legs);
    } else {
      refined.curve = barycentricPart(curve, 0, 1, points);
      refined.curve.shape.closed = shape.closed;
    }
    if (shape.closed) {
      refined.curve.points.pop_back();
      if (!refined.curve.shape.weights.empty()) refined.curve.shape.weights.pop_back();
      if (!refined.curve.shape.betas.empty()) refined.curve.shape.betas.pop_back();
    }
    refined.point = std::clamp(static_cast<int>(std::lround(at.t * (points - 1))), 1, points - 2);
    return refined;
  }
  if (at.t == 0 || at.t == 1) refuse("the curve has a control point there");
  CutThroughPoints cut = cutThroughPoints(curve, at);
  RefinedCurve refined{{withPoint(shape, at.segment + 1), curve.points()}, at.segment + 1};
  Array<SurfacePoint>& points = refined.curve.points;
  points.insert(points.begin() + refined.point, cut.point);
  if (followsLegs(curve)) {
    Array<SurfacePath>& legs = refined.curve.legs;
    legs = curve.value().legs;
    legs[at.segment] = std::move(cut.before);
    legs.insert(legs.begin() + refined.point, std::move(cut.after));
  }
  return refined;
}

Array<CurveParts> splitAt(Curve& curve, double parameter) {
  const SegmentParameter at = snappedParameter(curve, parameter);
  const CurveShape& shape = curve.shape();
  const Geometry& geometry = curve.surface().geometry();
  if (shape.kind == CurveKind::kOwn) refuseOwnBasis();
  const bool atStart = at.segment == 0 && at.t == 0;
  const bool atEnd = at.segment == curve.segmentCount() - 1 && at.t == 1;
  const bool onePiece = isBezier(shape.kind) || shape.kind == CurveKind::kBarycentric;
  // A closed curve of one segment begins and ends at the same point, where it is continuous but not
  // smooth.
  const auto refuseEnd = [&] {
    refuse("the curve cannot be split at " + inSentence(parameter) +
           ", its end; it runs from 0 to " + std::to_string(curve.segmentCount()));
  };
  if ((!shape.closed || onePiece) && (atStart || atEnd)) refuseEnd();
  if (shape.kind == CurveKind::kBSpline) {
    const ControlPolygon polygon = polygonOf(curve);
    const double knot = knotAtParameter(polygon, at);
    // A knot inside a tiny span at an end may round to the end.
    if (!shape.closed &&
        (knot == polygon.knots[shape.degree] || knot == polygon.knots[curve.pointCount()])) {
      refuseEnd();
    }
    if (shape.closed) return {alike(curve, partsOf(cutOpen(geometry, polygon, knot)))};
    return {alike(curve, partsOf(partBefore(geometry, polygon, knot))),
            alike(curve, partsOf(partAfter(geometry, polygon, knot)))};
  }
  if (isBezier(shape.kind)) {
    const ControlPolygon bezier = splineOf(bezierPolygon(curve));
    Array<CurveParts> parts(2, {{shape.kind}, {}});
    ControlPolygon halves[] = {partBefore(geometry, bezier, at.t),
                               partAfter(geometry, bezier, at.t)};
    for (int k = 0; k < 2; ++k) {
      setPoints(parts[k], halves[k].points);
      if (followsLegs(curve)) parts[k].legs = std::move(halves[k].legs);
    }
    return parts;
  }
  if (shape.kind == CurveKind::kBarycentric) {
    const int nodes = curve.pointCount() + (shape.closed ? 1 : 0);
    return {barycentricPart(curve, 0, at.t, nodes), barycentricPart(curve, at.t, 1, nodes)};
  }
  return splitThroughPoint(curve, at);
}

CurveParts joined(const Curve& first, const Curve& second) {
  const CurveShape& shape = first.shape();
  const Geometry& geometry = first.surface().geometry();
  if (shape.kind == CurveKind::kOwn || second.shape().kind == CurveKind::kOwn) refuseOwnBasis();
  if (shape.closed || second.shape().closed) refuse("a closed curve has no end to join");
  if (shape.kind != second.shape().kind) {
    refuse(std::string("curves of different kinds cannot be joined: ") + curveKindName(shape.kind) +
           " and " + curveKindName(second.shape().kind));
  }
  checkOneComponent(first.surface(), {first.point(0), second.point(0)});
  if (shape.kind == CurveKind::kBSpline) {
    if (shape.degree != second.shape().degree) {
      refuse("B-splines of different degrees cannot be joined: " + std::to_string(shape.degree) +
             " and " + std::to_string(second.shape().degree));
    }
    return joinedSplines(first, second, polygonOf(first), polygonOf(second));
  }
  if (isBezier(shape.kind)) {
    LeggedPolygon ends[2] = {bezierPolygon(first), bezierPolygon(second)};
    const int points = std::max(first.pointCount(), second.pointCount());
    if (points > kMostSplineDegree + 1) {
      refuse("Bezier curves can be joined up to degree 5, as a B-spline, not of degree " +
             std::to_string(points - 1));
    }
    for (LeggedPolygon& bezier : ends) {
      while (bezier.points.count() < points) bezier = elevated(geometry, bezier);
    }
    return joinedSplines(first, second, splineOf(ends[0]), splineOf(ends[1]));
  }
  CurveParts parts{shape, first.points()};
  const Array<SurfacePoint>& more = second.points();
  SurfacePath between;
  const int from = doMeet(geometry, parts.points.back(), more.front(), between) ? 1 : 0;
  const auto given = [](const Curve& curve) {
    return followsLegs(curve) ? curve.value().legs : Array<SurfacePath>();
  };
  parts.legs = joinedLegs(geometry, given(first), first.pointCount() - 1, given(second),
                          second.pointCount() - 1, from == 1 ? 0 : 1, first.points().back());
  parts.points.insert(parts.points.end(), more.begin() + from, more.end());
  parts.shape.weights.clear();
  parts.shape.betas.clear();
  if (takesBetas(shape.kind)) {
    for (const Curve* curve : {&first, &second}) {
      Array<double> betas = curve->shape().betas;
      betas.resize(static_cast<size_t>(curve->pointCount()), 1);
      const int skipped = curve == &second ? from : 0;
      parts.shape.betas.insert(parts.shape.betas.end(), betas.begin() + skipped, betas.end());
    }
  }
  return parts;
}

}  // namespace karcher

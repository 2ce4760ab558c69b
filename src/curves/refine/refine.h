#pragma once

#include "curves/curve.h"

/// Insertion of control points on a curve, and splits and joins of curves. On the plane an
/// operation leaves the curve unchanged whenever that is possible (knot_insertion.h).
namespace karcher {

/// A curve's shape, control points and legs (curve_value.h). If the original curve follows given
/// legs, the new legs lie along these (knot_insertion.h).
struct CurveParts {
  CurveShape shape;
  Array<SurfacePoint> points;
  Array<SurfacePath> legs = {};
};

struct RefinedCurve {
  CurveParts curve;
  int point = 0;  ///< the index of the new control point nearest to the parameter
};

/// The curve with one more control point, at a parameter (curve.h):
/// - B-splines: the curve gets a knot there, and its knots become KnotRule::kOwn;
/// - Bezier curves: the degree grows by one, whatever the parameter; all inner points are new;
/// - barycentric curves: the degree grows by one; all inner points are new points on the curve,
///   with betas that leave it unchanged;
/// - Catmull-Rom curves and polylines: the new point lies on the curve; it changes a Catmull-Rom
///   curve a little.
///
/// Throws Error kBadArgument if the curve cannot have such a point: the knot is repeated too often,
/// a control point lies there already, the betas would differ too much, or the basis is the
/// caller's own.
RefinedCurve withPointOnCurve(Curve& curve, double parameter);

/// The curves before and after a parameter. A closed B-spline, Catmull-Rom curve or polyline
/// becomes one open curve instead. B-splines are clamped at the cut. Bezier curves divide by de
/// Casteljau's algorithm. Barycentric curves get new control points on the curve, with betas that
/// leave it unchanged. Catmull-Rom curves change a little next to the cut. Throws Error
/// kBadArgument if the parameter is an end of an open curve or of a closed curve of one segment, if
/// betas would differ too much, or if the basis is the caller's own.
Array<CurveParts> splitAt(Curve& curve, double parameter);

/// Joins two open curves of the same kind to one. If the end of the first and the start of the
/// second meet, the result has this point once. Two B-splines of the same degree become one
/// B-spline. Two Bezier curves of degree 1 to 5 are elevated to the same degree and become one
/// B-spline, too. In both cases, a geodesic connects the two curves if they do not meet. For other
/// kinds, the result is the curve through the points of both. Throws Error kBadArgument if the
/// kinds or the degrees of B-splines differ, a Bezier curve has a higher degree than 5, a curve is
/// closed, or a basis is the caller's own; kUnreachable if the points lie on several components.
CurveParts joined(const Curve& first, const Curve& second);

}  // namespace karcher

#pragma once

#include "curves/curve.h"

/// Control points put in on a curve, curves cut in two and put together. Where the mathematics has
/// a way that leaves the curve as it is on the plane, that way is taken (knot_insertion.h).
namespace karcher {

/// What a curve is on its surface.
struct CurveParts {
  CurveShape shape;
  Array<SurfacePoint> points;
};

struct RefinedCurve {
  CurveParts curve;
  int point = 0;  ///< the number of the new control point that is nearest to the parameter
};

/// The curve with one more control point, at a parameter (curve.h):
/// - B-splines: a knot is inserted there; the knots become the curve's own;
/// - Bezier curves: the degree is raised, whatever the parameter; all inner points are new;
/// - barycentric curves: the degree is raised; all inner points are new points of the curve, and
///   the betas those that leave it as it is;
/// - Catmull-Rom curves and polylines: a point of the curve, which changes a Catmull-Rom curve a
///   little.
/// Throws Error kBadArgument where none can be put in: a knot that is repeated too often, a control
/// point that is there already, a caller's own basis.
RefinedCurve withPointOnCurve(Curve& curve, double parameter);

/// The curves before and after a parameter; a closed B-spline, Catmull-Rom curve or polyline gives
/// one open curve instead. B-splines are clamped where they are cut, Bezier curves divided by de
/// Casteljau's algorithm, barycentric ones by new points on them and the betas that leave them as
/// they are; Catmull-Rom curves change a little next to the cut.
/// Throws Error kBadArgument at the ends of an open curve and for a caller's own basis.
Array<CurveParts> splitAt(Curve& curve, double parameter);

/// One curve that runs along two open ones of one kind. A point where both meet is kept once.
/// B-splines, and Bezier curves of degree 1 to 5, become one B-spline that runs along both, with a
/// geodesic between them where they do not meet; the others are the curve through the points of
/// both. Throws Error kBadArgument where kinds or degrees differ, or a curve is closed or has its
/// own basis, kUnreachable.
CurveParts joined(const Curve& first, const Curve& second);

}  // namespace karcher

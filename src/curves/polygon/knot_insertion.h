#pragma once

#include "distance/geodesic_line.h"

/// The classical refinements of B-splines and Bezier curves, with averages of two points along
/// shortest paths. On the plane they do not change the curve. On a curved surface they change it by
/// an amount that vanishes with the curvature, since averages of averages depend on their order
/// there.
namespace karcher {

/// A control point with its weight. The average of two is weighted, too.
struct WeightedPoint {
  SurfacePoint point;
  double weight = 1;
};

/// The control points and knots of a B-spline (knots.h).
struct ControlPolygon {
  Array<WeightedPoint> points;
  Array<double> knots;
  int degree = 3;
  bool closed = false;
};

/// (1 - s) a + s b of weighted points, s in [0, 1].
WeightedPoint average(const Geometry& geometry, const WeightedPoint& a, const WeightedPoint& b,
                      double s);

/// The multiplicity of a knot. Knots of a closed curve are equal if they differ by the period.
int multiplicity(const ControlPolygon& polygon, double knot);

/// Inserts a knot u between the first and the last of the spans (W. Boehm, "Inserting new knots
/// into B-spline curves", 1980). For degree p, new points, p minus the knot's multiplicity in
/// number, replace the inner ones. Returns the number of the first of them. The multiplicity must
/// be less than p.
int insertKnot(const Geometry& geometry, ControlPolygon& polygon, double u);

/// The same curve of a degree higher by one, with one more point.
Array<WeightedPoint> elevated(const Geometry& geometry, const Array<WeightedPoint>& bezier);

/// The parts of a Bezier curve before and after t, by de Casteljau's algorithm.
struct BezierParts {
  Array<WeightedPoint> before;
  Array<WeightedPoint> after;
};
BezierParts divided(const Geometry& geometry, const Array<WeightedPoint>& bezier, double t);

/// The parts of an open B-spline before and after knot u, clamped there. At an end of the spans,
/// one of them is the whole curve, clamped.
ControlPolygon partBefore(const Geometry& geometry, ControlPolygon open, double u);
ControlPolygon partAfter(const Geometry& geometry, ControlPolygon open, double u);

/// A closed B-spline cut at knot u: an open, clamped curve from u once around.
ControlPolygon cutOpen(const Geometry& geometry, ControlPolygon closed, double u);

}  // namespace karcher

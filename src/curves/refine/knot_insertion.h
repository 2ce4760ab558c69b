#pragma once

#include "curves/polygon/leg_average.h"

/// The classical refinements of B-splines and Bezier curves, with averages of two points along the
/// legs of the control polygon. A new leg is part of an old one, or consists of parts of two
/// adjacent old legs, pulled tight. On the plane the refinements do not change the curve. On a
/// curved surface averages of averages depend on their order, so that the curve changes by an
/// amount that vanishes with the curvature.
namespace karcher {

/// The control points, legs and knots of a B-spline (knots.h).
struct ControlPolygon {
  Array<WeightedPoint> points;
  /// A leg from each point to the next, and for a closed curve also from the last to the first.
  Array<SurfacePath> legs;
  Array<double> knots;
  int degree = 3;
  bool closed = false;
};

/// The multiplicity of a knot. Knots of a closed curve are equal if they differ by the period.
int multiplicity(const ControlPolygon& polygon, double knot);

/// Inserts a knot u, which lies in the spans (W. Boehm, "Inserting new knots into B-spline curves",
/// 1980). If the degree is p and the knot's multiplicity before the insertion is m < p, then p - m
/// new points replace p - m - 1 old points. Returns the index of the first new point.
int insertKnot(const Geometry& geometry, ControlPolygon& polygon, double u);

/// The same Bezier curve with one more point, in a degree higher by one.
LeggedPolygon elevated(const Geometry& geometry, const LeggedPolygon& bezier);

/// The parts of an open B-spline before and after knot u, clamped there. If u is an end of the
/// spans, one part is the whole curve, clamped at this end. For a Bezier curve, which is a B-spline
/// of one span, this is de Casteljau's algorithm.
ControlPolygon partBefore(const Geometry& geometry, ControlPolygon open, double u);
ControlPolygon partAfter(const Geometry& geometry, ControlPolygon open, double u);

/// A closed B-spline cut at knot u: an open, clamped curve from u once around.
ControlPolygon cutOpen(const Geometry& geometry, ControlPolygon closed, double u);

}  // namespace karcher

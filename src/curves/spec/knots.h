#pragma once

#include "mesh/types.h"

/// Knot vectors of B-splines of degree p: numbers that do not decrease. An open curve of n points
/// has n + p + 1 knots, and its spans lie between knots p and n. A closed curve has n + 1 knots,
/// which repeat with the period knots[n] - knots[0]. Span j, from 0, blends the points j to j + p
/// (mod n).
namespace karcher {

/// Consecutive integers as knots, with span 0 from 0 to 1.
Array<double> uniformKnots(int points, int degree, bool closed);

/// Open knots 0, ..., 0, 1, 2, ..., n - p, ..., n - p with p + 1 equal ones at each end, so that
/// the curve starts at its first and ends at its last point.
Array<double> clampedKnots(int points, int degree);

/// Throws Error: kBadArgument (a wrong number of knots, decreasing knots, no span longer than 0, a
/// knot repeated so often that the curve would break, a knot with an absolute value above 1e100, or
/// two different knots less than 1e-100 apart), kNotFinite.
void checkKnots(const Array<double>& knots, int points, int degree, bool closed);

/// The number of spans, empty ones included.
int spanCount(const Array<double>& knots, int degree, bool closed);

/// The knot at the start of span j. j may lie outside the spans as long as the knot exists.
double knotOfSpan(const Array<double>& knots, int degree, bool closed, int j);

/// The knots with a new control point before point i: a new knot halves the span at the middle of
/// the new point's support, or the nearest span that is not empty.
Array<double> knotsWithPoint(const Array<double>& knots, int degree, bool closed, int i);

/// The knots without control point i: the knot at the middle of its support is removed.
Array<double> knotsWithoutPoint(const Array<double>& knots, int degree, bool closed, int i);

/// The knots of the reversed curve, whose points are in reverse order. The first point of a closed
/// curve stays the first.
Array<double> reversedKnots(const Array<double>& knots, int degree, bool closed);

/// Closed knots: first the spans of the open knots, then `degree` spans across the join, each as
/// long as the mean of the others.
Array<double> closedKnots(const Array<double>& open, int degree);

/// The open knots for the same number of points. Their spans are the first spans of the closed
/// knots.
Array<double> openKnots(const Array<double>& closed, int degree);

}  // namespace karcher

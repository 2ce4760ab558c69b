#pragma once

#include "mesh/types.h"

/// Knot vectors of B-splines of degree p: numbers that do not fall. An open curve of n points has
/// n + p + 1 of them, and its spans lie between knots p and n. A closed curve has n + 1, which
/// repeat with the period knots[n] - knots[0]. Span j, from 0, blends the points j to j + p (mod
/// n).
namespace karcher {

/// The integers, with span 0 from 0 to 1.
Array<double> uniformKnots(int points, int degree, bool closed);

/// Open knots 0, ..., 0, 1, 2, ..., n - p, ..., n - p with p + 1 equal ones at each end, so that
/// the curve starts at its first and ends at its last point.
Array<double> clampedKnots(int points, int degree);

/// Throws Error: kBadArgument (a wrong number of knots, knots that fall, none that differ, one that
/// repeats so often that the curve would break, one beyond 1e100, or two less than 1e-100 apart but
/// not equal), kNotFinite.
void checkKnots(const Array<double>& knots, int points, int degree, bool closed);

/// How many spans the knots have, empty ones included.
int spanCount(const Array<double>& knots, int degree, bool closed);

/// The knot at the start of span j; also beyond the spans, where there are knots.
double knotOfSpan(const Array<double>& knots, int degree, bool closed, int j);

/// The knots after control point i was put in before the one of that number: a span in its middle
/// is halved.
Array<double> knotsWithPoint(const Array<double>& knots, int degree, bool closed, int i);

/// The knots after control point i was taken out: the knot in its middle goes.
Array<double> knotsWithoutPoint(const Array<double>& knots, int degree, bool closed, int i);

/// The knots of the curve run backwards: its points in reverse order, but that a closed one keeps
/// its first.
Array<double> reversedKnots(const Array<double>& knots, int degree, bool closed);

/// Closed knots with the spans of the open ones, and further spans of their mean length across the
/// join.
Array<double> closedKnots(const Array<double>& open, int degree);

/// Open knots with the first spans of the closed ones.
Array<double> openKnots(const Array<double>& closed, int degree);

}  // namespace karcher

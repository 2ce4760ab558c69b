#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "mesh/types.h"

/// A curve's description without its control points: plain data and its edits, which do not depend
/// on surfaces.
namespace karcher {

enum class CurveKind {
  kBSpline,      ///< a B-spline of degree 1 to 5; with weights, a NURBS curve
  kBezier,       ///< one segment of degree points - 1, or points if closed
  kRational,     ///< a Bezier curve with a weight for each point
  kBarycentric,  ///< one rational segment through the points, with a beta for each point
  kCatmullRom,   ///< a C1 curve through the points, one segment between each two
  kPolyline,     ///< shortest paths from point to point
  kOwn,          ///< one segment with the caller's basis
};
inline constexpr CurveKind kCurveKinds[] = {
    CurveKind::kBSpline,    CurveKind::kBezier,   CurveKind::kRational, CurveKind::kBarycentric,
    CurveKind::kCatmullRom, CurveKind::kPolyline, CurveKind::kOwn};

/// The name of a kind in the interface, such as "catmullrom".
const char* curveKindName(CurveKind kind);

inline constexpr int kMostSplineDegree = 5;

/// The least weight and beta. The largest is 1 divided by it. Products and sums of weights and
/// betas stay finite.
inline constexpr double kLeastWeight = 1e-12;

/// The knots of a B-spline (knots.h).
enum class KnotRule {
  kUniform,  ///< evenly spaced knots
  kClamped,  ///< knots evenly spaced inside and repeated at the ends; open curves only
  kOwn,      ///< the caller's knots
};

/// A caller's basis: a function from the number of points and t in [0, 1] to one weight for each
/// control point, summing to 1.
using OwnBasis = std::function<Array<double>(int points, double t)>;

struct CurveShape {
  CurveKind kind = CurveKind::kBSpline;
  bool closed = false;
  int degree = 3;  ///< the degree of a B-spline
  KnotRule knotRule = KnotRule::kUniform;
  Array<double> knots = {};  ///< the knots with KnotRule::kOwn
  /// Whether the knots of a Catmull-Rom curve are spaced by the square roots of the distances
  /// between consecutive points. Otherwise they are evenly spaced.
  bool centripetal = true;
  /// one positive weight for each point of kBSpline and kRational; if empty, all are 1
  Array<double> weights = {};
  /// one positive beta for each point of kBarycentric; if empty, all are 1 (Berrut)
  Array<double> betas = {};
  std::shared_ptr<const OwnBasis> basis = {};  ///< the basis of kOwn
  /// Whether the weights are those of the basis at 1 - t, in reverse order, as after a reversal.
  bool isBasisMirrored = false;
};

inline bool takesWeights(CurveKind kind) {
  return kind == CurveKind::kBSpline || kind == CurveKind::kRational;
}
inline bool takesBetas(CurveKind kind) { return kind == CurveKind::kBarycentric; }

/// The number of a control polygon's legs.
inline int legCount(const CurveShape& shape, int points) {
  return shape.closed ? points : points - 1;
}

/// Throws Error if a curve of this shape cannot have this number of points, or if one of its
/// numbers is out of range: kTooFewPoints, kNotFinite, kBadArgument.
void checkShape(const CurveShape& shape, int points);

/// Checks a shape as `checkShape` does. Also throws kBadArgument if the shape sets a property that
/// its kind does not use.
void checkGivenShape(const CurveShape& shape, int points);

/// The knots of a B-spline with this number of points, by its rule.
Array<double> knotsOf(const CurveShape& shape, int points);

// The shape after an edit of a curve of `points` points. Weights and betas stay with their points.
// A new point has the weight and the beta 1. A caller's own knots stay as far as possible
// (knots.h).
CurveShape withPoint(CurveShape shape, int i);
CurveShape withoutPoint(CurveShape shape, int points, int i);
CurveShape withPointMoved(CurveShape shape, int from, int to);
/// The shape with another kind, without properties that the kind does not use.
CurveShape withKind(CurveShape shape, CurveKind kind);
CurveShape withClosed(CurveShape shape, bool closed);
CurveShape withWeight(CurveShape shape, int points, int i, double weight);
CurveShape withBeta(CurveShape shape, int points, int i, double beta);
CurveShape reversed(CurveShape shape);

/// Reorders entries for the reversed curve. A closed curve keeps its first point.
template <class T>
void reverseEntries(Array<T>& array, bool closed) {
  std::reverse(array.begin() + (closed && !array.empty() ? 1 : 0), array.end());
}

/// Moves entry `from` so that it becomes entry `to`.
template <class T>
void moveEntry(Array<T>& array, int from, int to) {
  T entry = array[from];
  array.erase(array.begin() + from);
  array.insert(array.begin() + to, entry);
}

}  // namespace karcher

#include "curves/spec/curve_shape.h"

#include <algorithm>
#include <utility>

#include "curves/spec/knots.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// The largest number of points of a curve of one segment. Each sample weighs all points.
constexpr int kMostPointsASegment = 1000;

/// The shape's name in a sentence, such as "a cubic B-spline".
std::string nameInSentence(const CurveShape& shape) {
  constexpr const char* kDegrees[] = {"linear", "quadratic", "cubic", "quartic", "quintic"};
  const std::string closed = shape.closed ? "closed " : "";
  switch (shape.kind) {
    case CurveKind::kBSpline:
      return "a " + closed + kDegrees[shape.degree - 1] + " B-spline";
    case CurveKind::kBezier:
      return "a " + closed + "Bezier curve";
    case CurveKind::kRational:
      return "a " + closed + "rational Bezier curve";
    case CurveKind::kBarycentric:
      return "a " + closed + "barycentric curve";
    case CurveKind::kCatmullRom:
      return "a " + closed + "Catmull-Rom curve";
    case CurveKind::kPolyline:
      return "a " + closed + "geodesic polyline";
    case CurveKind::kOwn:
      break;
  }
  return "a curve with its own basis";
}

int fewestPoints(const CurveShape& shape) {
  if (shape.closed) return 3;
  if (shape.kind == CurveKind::kBSpline) return shape.degree + 1;
  return shape.kind == CurveKind::kOwn ? 1 : 2;
}

bool isOneSegment(CurveKind kind) {
  return kind == CurveKind::kBezier || kind == CurveKind::kRational ||
         kind == CurveKind::kBarycentric || kind == CurveKind::kOwn;
}

void checkPositive(const Array<double>& values, const std::string& what, int points) {
  if (values.empty()) return;
  if (values.count() != points) {
    refuse("there are " + std::to_string(points) + " control points but " +
           std::to_string(values.count()) + " " + what + "s");
  }
  for (int i = 0; i < points; ++i) {
    // This check runs at every step of a drag, so only a failure builds the name.
    const auto entry = [&] { return "the " + what + " of point " + std::to_string(i); };
    if (!std::isfinite(values[i])) {
      throw Error(ErrorCode::kNotFinite, entry() + " is not a finite number");
    }
    if (!(values[i] >= kLeastWeight && values[i] <= 1 / kLeastWeight)) {
      refuse(entry() + " must be from 1e-12 to 1e12, not " + inSentence(values[i]));
    }
  }
}

void setEntry(Array<double>& values, int points, int i, double value) {
  values.resize(static_cast<size_t>(points), 1);
  values[i] = value;
}

bool hasOwnKnots(const CurveShape& shape) {
  return shape.kind == CurveKind::kBSpline && shape.knotRule == KnotRule::kOwn;
}

}  // namespace

const char* curveKindName(CurveKind kind) {
  switch (kind) {
    case CurveKind::kBSpline:
      return "bspline";
    case CurveKind::kBezier:
      return "bezier";
    case CurveKind::kRational:
      return "rational";
    case CurveKind::kBarycentric:
      return "barycentric";
    case CurveKind::kCatmullRom:
      return "catmullrom";
    case CurveKind::kPolyline:
      return "polyline";
    case CurveKind::kOwn:
      return "custom";
  }
  return "unknown";
}

void checkShape(const CurveShape& shape, int points) {
  if (shape.degree < 1 || shape.degree > kMostSplineDegree) {
    refuse("a B-spline has degree 1 to 5, not " + std::to_string(shape.degree));
  }
  // This check runs at every step of a drag, so only a failure builds the name.
  const auto name = [&] { return nameInSentence(shape); };
  const int fewest = fewestPoints(shape);
  if (points < fewest) {
    throw Error(ErrorCode::kTooFewPoints, name() + " needs at least " + std::to_string(fewest) +
                                              " control points, not " + std::to_string(points));
  }
  if (isOneSegment(shape.kind) && points > kMostPointsASegment) {
    refuse(name() + " takes at most " + std::to_string(kMostPointsASegment) +
           " control points, not " + std::to_string(points));
  }
  if (shape.kind == CurveKind::kOwn && (shape.closed || !shape.basis)) {
    refuse(shape.closed ? "a curve with its own basis cannot be closed"
                        : "a curve of the kind 'custom' needs a basis");
  }
  checkPositive(shape.weights, "weight", points);
  checkPositive(shape.betas, "beta", points);
  if (shape.kind != CurveKind::kBSpline) return;
  if (shape.closed && shape.knotRule == KnotRule::kClamped) {
    refuse("a closed B-spline has no ends to clamp");
  }
  if (shape.knotRule == KnotRule::kOwn) {
    checkKnots(shape.knots, points, shape.degree, shape.closed);
  }
}

void checkGivenShape(const CurveShape& shape, int points) {
  checkShape(shape, points);
  const std::string name = nameInSentence(shape);
  if (!shape.weights.empty() && !takesWeights(shape.kind)) refuse(name + " has no weights");
  if (!shape.betas.empty() && !takesBetas(shape.kind)) refuse(name + " has no betas");
  if (shape.knotRule != KnotRule::kUniform && shape.kind != CurveKind::kBSpline) {
    refuse(name + " has no knots");
  }
}

Array<double> knotsOf(const CurveShape& shape, int points) {
  switch (shape.knotRule) {
    case KnotRule::kOwn:
      return shape.knots;
    case KnotRule::kClamped:
      return clampedKnots(points, shape.degree);
    case KnotRule::kUniform:
      break;
  }
  return uniformKnots(points, shape.degree, shape.closed);
}

CurveShape withPoint(CurveShape shape, int i) {
  if (hasOwnKnots(shape)) {
    shape.knots = knotsWithPoint(shape.knots, shape.degree, shape.closed, i);
  }
  if (!shape.weights.empty()) shape.weights.insert(shape.weights.begin() + i, 1);
  if (!shape.betas.empty()) shape.betas.insert(shape.betas.begin() + i, 1);
  return shape;
}

CurveShape withoutPoint(CurveShape shape, int points, int i) {
  // `checkShape` reports too few points, whatever the knots.
  if (hasOwnKnots(shape) && points > fewestPoints(shape)) {
    shape.knots = knotsWithoutPoint(shape.knots, shape.degree, shape.closed, i);
  }
  if (!shape.weights.empty()) shape.weights.erase(shape.weights.begin() + i);
  if (!shape.betas.empty()) shape.betas.erase(shape.betas.begin() + i);
  return shape;
}

CurveShape withPointMoved(CurveShape shape, int from, int to) {
  if (!shape.weights.empty()) moveEntry(shape.weights, from, to);
  if (!shape.betas.empty()) moveEntry(shape.betas, from, to);
  return shape;
}

CurveShape withKind(CurveShape shape, CurveKind kind) {
  if (kind == shape.kind) return shape;
  CurveShape result;
  result.kind = kind;
  result.closed = shape.closed;
  if (takesWeights(kind)) result.weights = std::move(shape.weights);
  if (takesBetas(kind)) result.betas = std::move(shape.betas);
  result.basis = std::move(shape.basis);
  result.isBasisMirrored = shape.isBasisMirrored;
  return result;
}

CurveShape withClosed(CurveShape shape, bool closed) {
  if (closed == shape.closed) return shape;
  if (hasOwnKnots(shape)) {
    shape.knots =
        closed ? closedKnots(shape.knots, shape.degree) : openKnots(shape.knots, shape.degree);
  } else {
    shape.knotRule = KnotRule::kUniform;
  }
  shape.closed = closed;
  return shape;
}

CurveShape withWeight(CurveShape shape, int points, int i, double weight) {
  if (!takesWeights(shape.kind)) refuse(nameInSentence(shape) + " has no weights");
  setEntry(shape.weights, points, i, weight);
  return shape;
}

CurveShape withBeta(CurveShape shape, int points, int i, double beta) {
  if (!takesBetas(shape.kind)) refuse(nameInSentence(shape) + " has no betas");
  setEntry(shape.betas, points, i, beta);
  return shape;
}

CurveShape reversed(CurveShape shape) {
  if (hasOwnKnots(shape)) shape.knots = reversedKnots(shape.knots, shape.degree, shape.closed);
  reverseEntries(shape.weights, shape.closed);
  reverseEntries(shape.betas, shape.closed);
  shape.isBasisMirrored = shape.basis && !shape.isBasisMirrored;
  return shape;
}

}  // namespace karcher

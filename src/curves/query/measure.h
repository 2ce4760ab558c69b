#pragma once

#include "curves/query/evaluate.h"

/// Lengths along a curve and the point nearest to another, by the path that joins its samples.
namespace karcher {

/// The vertices of a joined curve, each with its position, the curve's parameter there (in
/// proportion to the length between samples) and the length from the curve's start.
struct CurveLine {
  SurfacePath path;
  // Per point of the path.
  Array<Vec3> positions;
  Array<double> parameters;
};

CurveLine lineOf(const Curve& curve);

/// The length from the start to a parameter, as `segmentParameter` takes it; once around a closed
/// curve it is the whole length.
double lengthAt(const Curve& curve, const CurveLine& line, double parameter);

/// The point at a length from the start, on the line. Throws Error kBadArgument outside the curve;
/// a closed one's length may go round.
CurvePoint pointAtLength(const Curve& curve, const CurveLine& line, double length);

/// `count` points with the same length between consecutive ones: the ends of an open curve
/// included, around a closed one from its start. Throws Error kBadArgument for less than 2 or more
/// than 1,000,000.
Array<CurvePoint> equallySpaced(const Curve& curve, const CurveLine& line, int count);

struct NearestOnCurve {
  CurvePoint at;
  double distance = 0;  ///< in space
};

/// The point of the curve nearest in space to a place, its parameter to 1e-13 of itself: that of
/// the lowest of the minima that the intervals between samples hold (nearest.cpp). It is
/// `pointAt` its parameter.
NearestOnCurve nearestOnCurve(Curve& curve, const CurveLine& line, const Vec3& place);

}  // namespace karcher

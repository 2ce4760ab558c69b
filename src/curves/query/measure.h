#pragma once

#include "curves/query/evaluate.h"

/// Lengths along a curve, on the path that joins its samples, and the curve's point nearest to a
/// place.
namespace karcher {

/// The path that joins a curve's samples, with the position and the parameter of each of its
/// points. Between samples, parameters grow in proportion to length.
struct CurveLine {
  SurfacePath path;
  // The positions of the path's points.
  Array<Vec3> positions;
  Array<double> parameters;
};

CurveLine lineOf(const Curve& curve);

/// The length from the curve's start to a parameter that `segmentParameter` accepts. On a closed
/// curve, a whole number of turns above 0 gives the length of one turn.
double lengthAt(const Curve& curve, const CurveLine& line, double parameter);

/// The point at a length from the start of the line. On a closed curve the length may be negative
/// or exceed a turn. Throws Error kBadArgument for a length that is not finite or lies outside an
/// open curve.
CurvePoint pointAtLength(const Curve& curve, const CurveLine& line, double length);

/// `count` points with equal lengths between consecutive ones. They include both ends of an open
/// curve, and begin at the start of a closed one. Throws Error kBadArgument for a count below 2 or
/// above 1,000,000.
Array<CurvePoint> equallySpaced(const Curve& curve, const CurveLine& line, int count);

struct NearestOnCurve {
  CurvePoint at;
  double distance = 0;  ///< the distance in space
};

/// The point of the curve nearest in space to a place: the lowest of the minima in the intervals
/// between samples (nearest.cpp). The search narrows the parameter u to an interval of the length
/// 1e-12 (1 + u). The point is `pointAt` of the parameter.
NearestOnCurve nearestOnCurve(Curve& curve, const CurveLine& line, const Vec3& place);

}  // namespace karcher

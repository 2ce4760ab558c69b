#pragma once

#include "curves/query/evaluate.h"

/// Lengths along a curve and its point nearest to a given place, on the path that joins its
/// samples.
namespace karcher {

/// The vertices of a joined curve. Each has its position, the curve's parameter (between samples,
/// in proportion to length) and the length from the curve's start.
struct CurveLine {
  SurfacePath path;
  // The positions of the path's points.
  Array<Vec3> positions;
  Array<double> parameters;
};

CurveLine lineOf(const Curve& curve);

/// The length from the start to a parameter, as for `segmentParameter`. After a whole turn of a
/// closed curve it is the whole length.
double lengthAt(const Curve& curve, const CurveLine& line, double parameter);

/// The point at a length from the start of the line. On a closed curve the length may be negative
/// or exceed a turn. Throws Error kBadArgument for a length that is not finite or lies outside an
/// open curve.
CurvePoint pointAtLength(const Curve& curve, const CurveLine& line, double length);

/// `count` points with equal lengths between consecutive ones. They include both ends of an open
/// curve, and begin at the start of a closed one. Throws Error kBadArgument for less than 2 or more
/// than 1,000,000.
Array<CurvePoint> equallySpaced(const Curve& curve, const CurveLine& line, int count);

struct NearestOnCurve {
  CurvePoint at;
  double distance = 0;  ///< the distance in space
};

/// The point of the curve nearest in space to a place: the lowest of the minima in the intervals
/// between samples (nearest.cpp). The relative error of its parameter is 1e-13. The point is
/// `pointAt` of that parameter.
NearestOnCurve nearestOnCurve(Curve& curve, const CurveLine& line, const Vec3& place);

}  // namespace karcher

#pragma once

#include <span>

#include "curves/polygon/levels.h"
#include "distance/find_path.h"
#include "intrinsic/straightest.h"

/// Curves by repeated geodesic averages of two points. They are continuous for any control points.
/// Source: C. Mancinelli, G. Nazzaro, F. Pellacini, E. Puppo, "b/Surf: Interactive Bezier Splines
/// on Surface Meshes" (2022).
namespace karcher {

/// Reusable scratch memory.
struct SubdivisionWorkspace {
  FindPathWorkspace paths;
  SurfacePath line;
  StraightestPath beyond;  ///< the continuation beyond the end of the line
  Array<WeightedPoint> positive;
  Array<WeightedPoint> negative;
  LeggedPolygon polygon;
  AveragingWorkspace averaging;
};

/// The point at the fraction s of the fast path (find_path.h) from a to b. For s outside [0, 1],
/// the path continues straight, up to the surface's boundary.
SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s, SubdivisionWorkspace& workspace);

/// The repeated average of weighted points, two at a time. It goes from both ends of the list
/// towards its middle, so that neighbours meet first and the reversed list gives the same point.
/// With the weights of a knot insertion the result is the new point of this insertion. The points
/// of negative weight have an average of their own. The result then lies on the path from this
/// average to the average of the other points, extended beyond the end. The weights sum to 1, and
/// at least one is positive.
SurfacePoint repeatedAverage(const Geometry& geometry, const Array<SurfacePoint>& points,
                             const Array<double>& weights, SubdivisionWorkspace& workspace);

/// A curve on the surface as a path, with a nondecreasing parameter for each point.
struct ParametricLine {
  SurfacePath path;
  Array<double> t;
};

/// Appends the Bezier curve of at least two control points, with parameters from t0 to t1. The legs
/// of their polygon are fast paths (find_path.h). The function halves the polygon (levels.h) until
/// each part is short, has one leg, or is 2^-6 of the curve. The control polygons of the parts
/// approximate the curve. If `line` is not empty, it must end at the first point, which is not
/// repeated.
void appendBezier(const Geometry& geometry, std::span<const SurfacePoint> points, double t0,
                  double t1, SubdivisionWorkspace& workspace, ParametricLine& line);

}  // namespace karcher

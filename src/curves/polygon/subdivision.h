#pragma once

#include <array>
#include <span>

#include "curves/polygon/knot_insertion.h"
#include "distance/geodesic_line.h"
#include "intrinsic/straightest.h"

/// Curves by repeated geodesic averages of two points, which are continuous wherever their control
/// points lie: C. Mancinelli, G. Nazzaro, F. Pellacini, E. Puppo, "b/Surf: Interactive Bezier
/// Splines on Surface Meshes" (2022).
namespace karcher {

/// Scratch memory, which can be reused.
struct SubdivisionWorkspace {
  static constexpr int kDeepest = 6;
  /// The edges of the two polygons of a subdivision; the lists may be longer than needed.
  struct Parts {
    Array<SurfacePath> first;
    Array<SurfacePath> second;
  };

  GeodesicWorkspace geodesics;
  SurfacePath line;
  StraightestPath beyond;  ///< the continuation beyond the end of the line
  Array<WeightedPoint> positive;
  Array<WeightedPoint> negative;
  Array<SurfacePath> polygon;
  Array<SurfacePath> row;  ///< a row of de Casteljau's triangle
  Array<LineHalves> halves;
  std::array<Parts, kDeepest> parts;  ///< the parts at each depth of the subdivision
};

/// The point at the part s of a geodesic from a to b. Outside [0, 1] the geodesic continues
/// straight, up to the surface's boundary.
SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s, SubdivisionWorkspace& workspace);

/// Weighted points as repeated averages of two: from both ends of the list towards its middle, so
/// that neighbours meet first and the reversed list gives the same. With the weights of a knot
/// insertion the result is that knot insertion. Points of negative weight are averaged separately.
/// Seen from their average, the result lies beyond the average of the others. The weights sum to 1,
/// and at least one is positive.
SurfacePoint repeatedAverage(const Geometry& geometry, const Array<SurfacePoint>& points,
                             const Array<double>& weights, SubdivisionWorkspace& workspace);

/// A curve on the surface as a path, with a nondecreasing parameter for each point.
struct ParametricLine {
  SurfacePath path;
  Array<double> t;
};

/// Appends the Bezier curve over [t0, t1] of the control points, at least two. De Casteljau's
/// algorithm halves it along geodesics until it has 2^6 parts or they are short, whose control
/// polygons approximate the curve. The first point is not repeated if `line` already ends there.
void appendBezier(const Geometry& geometry, std::span<const SurfacePoint> points, double t0,
                  double t1, SubdivisionWorkspace& workspace, ParametricLine& line);

}  // namespace karcher

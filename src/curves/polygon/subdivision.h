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

/// Scratch memory; reuse one to spare the allocations.
struct SubdivisionWorkspace {
  static constexpr int kDeepest = 6;
  /// The edges of both polygons that one is cut into; there may be more of them than it has.
  struct Parts {
    Array<SurfacePath> first;
    Array<SurfacePath> second;
  };

  GeodesicWorkspace geodesics;
  SurfacePath line;
  StraightestPath beyond;  ///< the end of the line
  Array<WeightedPoint> positive;
  Array<WeightedPoint> negative;
  Array<SurfacePath> polygon;
  Array<SurfacePath> row;  ///< of de Casteljau's triangle
  Array<LineHalves> halves;
  std::array<Parts, kDeepest> parts;  ///< by depth
};

/// The point at the part s of a geodesic from a to b. Beyond [0, 1] it goes on straight, as far as
/// the surface's boundary lets it.
SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s, SubdivisionWorkspace& workspace);

/// Weighted points as repeated averages of two: from both ends of the list towards its middle, so
/// that neighbours meet first and the reversed list gives the same. With the weights of a knot
/// insertion it is that knot insertion. The points of negative weight are averaged apart, and the
/// result lies beyond the average of the others as seen from theirs.
/// The weights sum to 1, at least one of them is positive.
SurfacePoint repeatedAverage(const Geometry& geometry, const Array<SurfacePoint>& points,
                             const Array<double>& weights, SubdivisionWorkspace& workspace);

/// A curve on the surface as a path with a parameter per point, which does not fall.
struct ParametricLine {
  SurfacePath path;
  Array<double> t;
};

/// Appends the Bezier curve over [t0, t1] of the control points, at least two, by de Casteljau's
/// subdivision in the middle along geodesics, until it is cut in 2^6 or shorter than an edge.
/// Its last control polygons stand for the curve. The first point is not repeated where `line`
/// already ends there.
void appendBezier(const Geometry& geometry, std::span<const SurfacePoint> points, double t0,
                  double t1, SubdivisionWorkspace& workspace, ParametricLine& line);

}  // namespace karcher

#pragma once

#include <optional>

#include "curves/trace/joined_path.h"

namespace karcher {

inline constexpr int kMostArcs = 64;
inline constexpr int kMostFittingArcs = 128;

struct CircleOptions {
  /// 3 to 64 equally wide arcs. None: as many as the tolerance needs, or 7 for an ellipse.
  std::optional<int> arcs = {};
  /// The samples of each arc, both ends included. Of fitting arcs, those of a seventh of the turn
  /// have this number; narrower ones have proportionally fewer, but at least 5.
  int samples = 32;
  FieldOptions field;
  /// The levels, as for a curve (curve_value.h).
  int levels = 0;
  /// The largest deviation of fitting arcs from the radius, as a part of it.
  double tolerance = 1e-3;
};

struct GeodesicCircle {
  /// The samples of each arc and their joined path.
  Array<Array<CurveSample>> samples;
  Array<Array<Bridge>> bridges;
  Array<JoinedPath> paths;
  int levels = 0;  ///< the number of levels
  /// The numbers of the arcs with a geodesic from the center that is not the shortest.
  Array<int> notShortest;
  /// For circles, the largest difference of a sample's exact distance from the center and the
  /// radius, as a part of the radius.
  std::optional<double> deviation;
};

/// The circle of the given radius about a point of the surface, by rational quadratic arcs
/// (Mancinelli, Puppo, section 5): with the total angle Theta of the center and a = Theta / (2 n),
/// the arcs' ends lie at the radius and their middle points, of weight cos a, at radius / cos a,
/// along straightest geodesics in equally spaced directions. If no other vertex is as near to the
/// center as these points, the arcs are those of the plane, or of the cone about a vertex.
///
/// Fitting arcs begin as seven. Arcs that deviate from the radius by more than the tolerance are
/// cut into narrower ones, whose number assumes that deviations fall with the square of the width.
/// This is repeated up to four times and to 128 arcs in all; the result is the circle of the least
/// deviation. It helps wherever geodesics from the center stay the shortest and spread little
/// between one and the next. Beyond the center's cut locus no arcs keep to the radius; then, and
/// where saddles spread the geodesics apart, `deviation` is larger than the tolerance. Throws
/// Error: kBadArgument (radius not positive and finite, or less than a billionth of the longest
/// edge at the center, or than a million roundings of its coordinates; arcs, samples), kBoundary
/// (the center lies there, or naming the arc whose geodesic meets it), kRadiusTooLarge if no point
/// of the component is that far.
GeodesicCircle traceCircle(Surface& surface, const SurfacePoint& center, double radius,
                           const CircleOptions& options);

/// The ellipse whose axes have these radii, along and across a direction, by the rational quadratic
/// arcs of the plane's ellipse mapped to the surface: control points lie along straightest
/// geodesics, in the direction and at the distance that they have from the plane's center. With
/// equal radii it is the circle (except about a vertex with curvature). `direction` is a nonzero
/// vector in the frame of the center's face, and points into it if the center is a vertex. Throws
/// as `traceCircle` does.
GeodesicCircle traceEllipse(Surface& surface, const SurfacePoint& center, double along,
                            double across, const Vec2& direction, const CircleOptions& options);

}  // namespace karcher

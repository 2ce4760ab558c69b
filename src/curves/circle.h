#pragma once

#include <optional>

#include "curves/trace/joined_path.h"

namespace karcher {

inline constexpr int kMostArcs = 64;
inline constexpr int kMostFittingArcs = 128;

struct CircleOptions {
  /// 3 to 64, all as wide. None: as many as the tolerance takes, of an ellipse 7.
  std::optional<int> arcs = {};
  /// An arc, both ends included. Of fitting arcs these are those of a seventh of the turn; narrower
  /// ones have as many less, but at least 5.
  int samples = 32;
  FieldOptions field;
  /// As those of a curve (curve_value.h).
  int levels = 0;
  /// A part of the radius: how far fitting arcs may be from it.
  double tolerance = 1e-3;
};

struct GeodesicCircle {
  /// Per arc its samples and their joined path.
  Array<Array<CurveSample>> samples;
  Array<Array<Bridge>> bridges;
  Array<JoinedPath> paths;
  int levels = 0;  ///< how many there are
  /// The numbers of the arcs with a geodesic from the center that is not the shortest.
  Array<int> notShortest;
  /// Of circles, as a part of the radius: the largest difference of a sample's exact distance from
  /// the center and the radius.
  std::optional<double> deviation;
};

/// The circle of the given radius about a point of the surface, by rational quadratic arcs
/// (Mancinelli, Puppo, section 5): with the total angle Theta of the center and a = Theta / (2 n),
/// the arcs' ends lie at the radius and their middle points, of weight cos a, at radius / cos a,
/// along straightest geodesics in equally spaced directions. Where no other vertex is as near to
/// the center as these points, the arcs are those of the plane, or of the cone about a vertex.
///
/// Fitting arcs begin as seven. Those that are farther from the radius than the tolerance are cut
/// into narrower ones, as many as a deviation takes that falls with the square of the width, up to
/// four times and to 128 arcs in all; of these circles it is the one that keeps nearest. That helps
/// wherever geodesics from the center stay the shortest and spread little between one and the next.
/// Beyond the center's cut locus no arcs keep to the radius; then, and where saddles spread the
/// geodesics apart, `deviation` is larger than the tolerance.
/// Throws Error: kBadArgument (radius not positive and finite, or less than a billionth of the
/// longest edge at the center, or than a million roundings of its coordinates; arcs, samples),
/// kBoundary (the center lies there, or naming the arc whose geodesic meets it), kRadiusTooLarge
/// where no point of the component is as far.
GeodesicCircle traceCircle(Surface& surface, const SurfacePoint& center, double radius,
                           const CircleOptions& options);

/// The ellipse whose axes have these radii, along and across a direction, by the rational quadratic
/// arcs of the plane's ellipse carried to the surface: control points along straightest geodesics,
/// in the direction and at the distance that they have from the plane's center. With equal radii it
/// is the circle (but about a vertex with an angle that is not flat).
/// `direction` is a vector, not 0, in the frame of the center's face, and points into it where the
/// center is a vertex. Throws as `traceCircle` does.
GeodesicCircle traceEllipse(Surface& surface, const SurfacePoint& center, double along,
                            double across, const Vec2& direction, const CircleOptions& options);

}  // namespace karcher

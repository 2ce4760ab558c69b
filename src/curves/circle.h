#pragma once

#include <optional>

#include "curves/trace/joined_path.h"

namespace karcher {

inline constexpr int kMostArcs = 64;
inline constexpr int kMostFittingArcs = 2 * kMostArcs;

struct CircleOptions {
  /// The number of equally wide arcs, 3 to 64. By default as many as the tolerance needs, or 7 for
  /// an ellipse.
  std::optional<int> arcs = {};
  /// The number of samples of each arc, both ends included. Without `arcs`, it is the number for an
  /// arc of a seventh of the turn. If a circle's widest arc is narrower, all arcs have
  /// proportionally fewer samples, but at least 5, or this number if it is less.
  int samples = 32;
  FieldOptions field;
  /// The levels, as for a curve (curve_value.h).
  int levels = 0;
  /// Without `arcs`, a circle's arcs are divided if they deviate from the radius by more than this,
  /// relative to the radius.
  double tolerance = 1e-3;
};

struct GeodesicCircle {
  /// The samples and the bridges of each arc, and the path that joins the samples.
  Array<Array<CurveSample>> samples;
  Array<Array<Bridge>> bridges;
  Array<JoinedPath> paths;
  int levels = 0;  ///< the number of levels
  /// The indices of the arcs with a control point to which the geodesic from the center is not a
  /// shortest path.
  Array<int> notShortest;
  /// For circles, the largest difference between a sample's exact distance from the center and the
  /// radius, relative to the radius.
  std::optional<double> deviation;
};

/// The circle of the given radius about a point of the surface, as n rational quadratic arcs
/// (Mancinelli, Puppo, section 5). The control points lie along straightest geodesics from the
/// center in equally spaced directions. The ends of the arcs lie at the radius. The middle points
/// lie at the distance radius / cos a and have the weight cos a, where a is the total angle of the
/// center divided by 2 n. If no other vertex is as near to the center as these points, the arcs are
/// those of the plane, or of the cone about a vertex.
///
/// If the options set no number of arcs, the circle begins with seven arcs in a full turn. Up to
/// four rounds divide the arcs that deviate from the radius by more than the tolerance, up to 128
/// arcs in all. The number of an arc's parts assumes that the deviation falls with the square of
/// the width. The result is the circle with the least deviation. Division helps where geodesics
/// from the center are shortest paths and adjacent geodesics spread little. Beyond the center's cut
/// locus, and where saddles spread the geodesics apart, `deviation` stays larger than the
/// tolerance.
///
/// Throws Error: kBadArgument (a radius that is not positive and finite, or less than a billionth
/// of the longest edge at the center or of the center's largest coordinate; invalid options; too
/// few arcs for the center's total angle), kBoundary (the center lies on the boundary, or a
/// geodesic to a control point meets the boundary), kRadiusTooLarge (no vertex of the component is
/// that far away).
GeodesicCircle traceCircle(Surface& surface, const SurfacePoint& center, double radius,
                           const CircleOptions& options);

/// The ellipse with these radii along and across a direction. It maps the rational quadratic arcs
/// of a planar ellipse to the surface: each control point lies on a straightest geodesic from the
/// center, in the same direction and at the same distance as in the plane. With equal radii it is
/// the circle (except about a vertex with curvature). `direction` is a nonzero vector in the frame
/// of the center's face; if the center is a vertex, it must point into that face. Throws what
/// `traceCircle` throws.
GeodesicCircle traceEllipse(Surface& surface, const SurfacePoint& center, double along,
                            double across, const Vec2& direction, const CircleOptions& options);

}  // namespace karcher

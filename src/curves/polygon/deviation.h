#pragma once

#include "curves/polygon/levels.h"

/// An estimate of the distance by which subdivision of a control polygon moves its curve of centers
/// of mass.
namespace karcher {

/// Reusable scratch memory.
struct DeviationWorkspace {
  Array<Vec2>
      unrolled;  ///< a segment's polygon in the plane, with the turning angles of the surface
  Array<double> weights;
  // A row of the pyramid of averages, relative to the center of mass: the points, their moves by
  // the curvature, and their weights.
  Array<Vec2> row;
  Array<Vec2> moves;
  Array<double> rowWeights;
};

/// The largest distance between the curve of a segment's centers of mass and its subdivision curve,
/// to the first order in the curvature. The function assumes a constant curvature: the largest
/// absolute value of the legs' mean curvatures. The distance vanishes where the polygon is straight
/// or the surface is developable.
///
/// In normal coordinates about the center of mass the points' weighted sum is 0, so that the center
/// does not move. The point at the fraction s of the path from p to q is p + s (q - p), moved by K
/// / 3 s (1 - s) |p x q| across the path, since d^2(p, q) = |q - p|^2 - K / 3 |p x q|^2. The
/// averages of de Casteljau's or de Boor's triangle add up their moves.
double segmentDeviation(const Geometry& geometry, const Array<SurfacePath>& legs,
                        const SegmentLayout& segment, const Array<double>& pointWeights,
                        DeviationWorkspace& workspace);

}  // namespace karcher

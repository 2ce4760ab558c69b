#pragma once

#include "curves/polygon/levels.h"

/// How far the subdivision of a control polygon moves its curve of centers of mass, estimated.
namespace karcher {

/// Scratch memory; reuse one to spare the allocations.
struct DeviationWorkspace {
  Array<Vec2> unrolled;  ///< a segment's polygon, its legs turned by as much as on the surface
  Array<double> weights;
  // Of a row of averages about the center: the points, how curvature moves them, their weights.
  Array<Vec2> row;
  Array<Vec2> moves;
  Array<double> rowWeights;
};

/// The largest distance between the curve of a segment's centers of mass and its subdivision curve,
/// to the first order in the curvature, as if that were the same all over: the largest mean along
/// one of the legs. It vanishes where the polygon is straight or the surface unrolls.
///
/// In normal coordinates about the center of mass the points' weighted sum is 0, so that nothing
/// moves the center. The point at the part s from p to q is p + s (q - p) and, with d^2(p, q) =
/// |q - p|^2 - K / 3 |p x q|^2, moved by K / 3 s (1 - s) |p x q| across the way. The averages of de
/// Casteljau's or de Boor's triangle add up their moves.
double segmentDeviation(const Geometry& geometry, const Array<SurfacePath>& legs,
                        const SegmentLayout& segment, const Array<double>& pointWeights,
                        DeviationWorkspace& workspace);

}  // namespace karcher

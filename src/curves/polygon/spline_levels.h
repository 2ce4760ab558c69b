#pragma once

#include "curves/polygon/leg_average.h"
#include "curves/spec/curve_layout.h"

/// Levels of B-splines: a knot in the middle of each span.
namespace karcher {

/// A control polygon with its legs, and its relation to that of the level before.
struct SplineLevel {
  /// The consecutive points of the level before that a point averages.
  struct Parents {
    int first = 0;  ///< may continue past the end of a closed curve, or be negative
    Array<double> weights;
  };
  /// A path from a point to one of its parents, along which legs are led.
  struct Anchor {
    SurfacePath path;
    int parent = 0;  ///< counted as `Parents::first`
  };

  Array<WeightedPoint> points;
  Array<SurfacePath> legs;
  Array<Parents> parents;
  /// Two anchors for each point, to the last parents averaged from either end of their row: one for
  /// the leg that arrives at the point, and one for the leg that leaves it.
  Array<Anchor> anchors;
};

/// Scratch memory of a B-spline's levels. Knots and weights are kept for the next curve of the same
/// shape: a drag changes neither.
struct SplineWorkspace {
  /// The average so far, from one end of the parents.
  struct Side {
    WeightedPoint point;
    int parent = 0;        ///< the last one averaged
    SurfacePath toParent;  ///< of no length at first
  };

  CurveShape shape;
  int points = 0;  ///< 0: `levels` and `pieces` are of no shape yet
  /// The levels, from the control polygon itself on.
  Array<SplineLevel> levels;
  /// The segments of the last level.
  Array<SegmentLayout> pieces;
  SurfacePath path;
  Side near;
  Side far;
};

/// Subdivides a B-spline's control polygon `levels` times by a knot in the middle of each span. A
/// new point is the repeated average of its parents, with the weights of the knot insertion. `legs`
/// are those of `refinePolygon` (levels.h), which this is a part of. Writes to the workspace's
/// levels and pieces.
void refineSpline(const Geometry& geometry, const CurveShape& shape,
                  const Array<WeightedPoint>& points, const Array<SurfacePath>& legs, int levels,
                  StripWorkspace& strip, SplineWorkspace& workspace);

}  // namespace karcher

#pragma once

#include "curves/polygon/leg_average.h"
#include "curves/spec/curve_layout.h"

/// Levels of B-splines: a knot in the middle of each span.
namespace karcher {

/// A control polygon with its legs, and its relation to the polygon of the previous level.
struct SplineLevel {
  /// The parents of a point: the consecutive points of the previous level that it averages.
  struct Parents {
    /// the index of the first parent; on a closed curve it may be negative or past the last point
    int first = 0;
    Array<double> weights;
  };
  /// A path from a point to one of its parents. The new legs follow such paths.
  struct Anchor {
    SurfacePath path;
    int parent = 0;  ///< the parent's index, as in `Parents::first`
  };

  Array<WeightedPoint> points;
  Array<SurfacePath> legs;
  Array<Parents> parents;
  /// Two anchors for each point: the first for the leg that arrives at the point, the second for
  /// the leg that leaves it. The first leads to the parent averaged last from the start of the
  /// parents' row, the second to the parent averaged last from its end.
  Array<Anchor> anchors;
};

/// Scratch memory of a B-spline's levels. It keeps knots and weights for the next curve of the same
/// shape, since a drag changes neither.
struct SplineWorkspace {
  /// The average of the parents included so far, from one end of their row.
  struct Side {
    WeightedPoint point;
    int parent = 0;        ///< the index of the parent included last
    SurfacePath toParent;  ///< the path to that parent, initially without length
  };

  CurveShape shape;
  int points = 0;  ///< the number of control points of `levels`; 0 before these exist
  /// The levels; the first is the control polygon itself.
  Array<SplineLevel> levels;
  /// The segments of the last level.
  Array<SegmentLayout> pieces;
  SurfacePath path;
  Side near;
  Side far;
};

/// Subdivides a B-spline's control polygon `levels` times, as `refinePolygon` (levels.h) does, with
/// the same `legs`. Each level adds a knot in the middle of each span. A new point is the repeated
/// average of its parents, with the weights of the knot insertion. Writes to the workspace's levels
/// and pieces.
void refineSpline(const Geometry& geometry, const CurveShape& shape,
                  const Array<WeightedPoint>& points, const Array<SurfacePath>& legs, int levels,
                  StripWorkspace& strip, SplineWorkspace& workspace);

}  // namespace karcher

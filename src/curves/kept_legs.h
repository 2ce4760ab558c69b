#pragma once

#include "curves/curve_value.h"

/// The legs of a control polygon that stay after a change of its points.
namespace karcher {

/// The move of one point of a polygon from one index to another. The point is new if `from` is -1,
/// and removed if `to` is -1. By default no point moves.
struct PointChange {
  int from = -1;
  int to = -1;
};

/// Updates a value's legs after a change of its points; `points` is the number of points before the
/// change. A leg stays if its two ends are still neighbours. It is reversed if the order of its
/// ends has changed. If two new legs join the same two points, only one of them takes the old leg.
/// All other legs become shortest paths; if all do, the list of legs becomes empty.
void keepLegs(CurveValue& value, int points, const PointChange& change);

/// The value with other control points. A leg stays if the two points that it joins keep their
/// indices and places.
CurveValue withPoints(CurveValue value, Array<SurfacePoint> points);

}  // namespace karcher

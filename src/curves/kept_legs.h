#pragma once

#include "curves/curve_value.h"

/// The legs of a control polygon that stay after a change of its points.
namespace karcher {

/// The change of one point of a polygon from one number to another. The point is new if `from` is
/// -1, and removed if `to` is. By default no point changes.
struct PointChange {
  int from = -1;
  int to = -1;
};

/// Updates a value's legs after a change of its points; `points` is their number before. A leg
/// stays as long as its two ends are neighbours. If they changed places, the leg is reversed; if
/// they form two pairs, one has it. All other legs become shortest paths; if all are, the value has
/// no legs.
void keepLegs(CurveValue& value, int points, const PointChange& change);

/// The value with other control points. A leg stays if both its ends, by number, are unchanged.
CurveValue withPoints(CurveValue value, Array<SurfacePoint> points);

}  // namespace karcher

#pragma once

#include "curves/curve_value.h"

/// Legs of a control polygon that are kept when its points change.
namespace karcher {

/// The change of one point of a polygon from one number to another. The point is new if `from` is
/// -1, and removed if `to` is. By default no point changes.
struct PointChange {
  int from = -1;
  int to = -1;
};

/// Updates a value's legs after a change of its points; `points` is the number before. A leg stays
/// with its two ends as long as they are neighbours, is reversed if they changed places, and goes
/// to one pair at most. All others become the shortest; if all are, the value has no legs.
void keepLegs(CurveValue& value, int points, const PointChange& change);

/// The value with other control points. A leg is kept if both its ends, by number, are unchanged.
CurveValue withPoints(CurveValue value, Array<SurfacePoint> points);

}  // namespace karcher

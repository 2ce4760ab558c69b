#pragma once

#include "curves/curve_value.h"

/// Which legs of a control polygon stay when its points are changed.
namespace karcher {

/// One point of a polygon goes from one number to another; it is new where `from` is -1, and taken
/// out where `to` is. By default none.
struct PointChange {
  int from = -1;
  int to = -1;
};

/// Makes a value's legs, which are those before a change of its points, `points` in number, those
/// after it. A leg goes with its two ends as long as they are neighbours, turned round where these
/// have changed places, and to one pair at most. The others are the shortest; without legs where
/// all are.
void keepLegs(CurveValue& value, int points, const PointChange& change);

/// The value with other control points. A leg is kept where both its ends stay, by their numbers.
CurveValue withPoints(CurveValue value, Array<SurfacePoint> points);

}  // namespace karcher

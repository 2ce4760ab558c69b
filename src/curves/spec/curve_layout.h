#pragma once

#include "curves/spec/segment_basis.h"

/// The segments of a curve: which control points each one blends, and with which basis. This
/// depends on counts and numbers only, not on the surface.
namespace karcher {

struct SegmentLayout {
  Array<int> points;  ///< numbers of different control points
  SegmentBasis basis;
};

/// The lengths of a Catmull-Rom curve's knot spans, up to a common factor: the square roots of the
/// distances between consecutive points if the curve is centripetal, otherwise 1.
void catmullRomSpacings(const Array<double>& gaps, bool centripetal, Array<double>& spacings);

/// The segments of a curve with a shape that `checkShape` passes. A segment runs from t = 0 to 1,
/// and its end is the start of the next one; spans without length are left out. `gaps`, for
/// centripetal curves: the distance from each point to the next, at a closed curve also from the
/// last to the first; without them knots are even.
Array<SegmentLayout> layOut(const CurveShape& shape, int points, const Array<double>& gaps = {});

/// Whether two shapes give the same segments to as many points without gaps.
bool layAlike(const CurveShape& a, const CurveShape& b);

}  // namespace karcher

#pragma once

#include "curves/spec/segment_basis.h"

/// The segments of a curve: the control points that each one blends, and the basis. They depend
/// only on the curve's shape and number of points, not on the surface.
namespace karcher {

struct SegmentLayout {
  Array<int> points;  ///< the indices of distinct control points
  SegmentBasis basis;
};

/// The lengths of a Catmull-Rom curve's knot spans, up to a common factor: the square roots of the
/// distances between consecutive points if the curve is centripetal, otherwise 1. Distances below
/// 1e-4 of the largest count as 1e-4 of it.
void catmullRomSpacings(const Array<double>& gaps, bool centripetal, Array<double>& spacings);

/// The segments of a curve with a shape that `checkShape` accepts. A segment runs from t = 0 to 1,
/// and its end is the start of the next one. The result omits empty spans. A Catmull-Rom curve has
/// evenly spaced knots until `spaceKnots` spaces them.
Array<SegmentLayout> layOut(const CurveShape& shape, int points);

/// Spaces the knots of a Catmull-Rom curve's segments by the lengths of its spans, one length for
/// each segment.
void spaceKnots(const Array<double>& spacings, bool closed, Array<SegmentLayout>& segments);

/// Whether two shapes have the same segments for equal numbers of points, up to the spacing of
/// knots.
bool layAlike(const CurveShape& a, const CurveShape& b);

}  // namespace karcher

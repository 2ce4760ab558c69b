#pragma once

#include "curves/polygon/subdivision.h"
#include "curves/spec/segment_basis.h"
#include "curves/trace/segment.h"

/// Curves that do not break.
///
/// Where control points lie too far apart, there is no center of mass, or it jumps from one local
/// minimum to another. Over the interval from the last sample before to the first one after, the
/// curve follows a bridge instead: the subdivision curve of the segment's own control points
/// (subdivision.h), with its ends moved to those two samples. So the curve is continuous
/// everywhere, and its samples tell where and why it is no center of mass.
namespace karcher {

/// A step is a jump if it stays longer than this, in mean edges, however finely t is divided. Much
/// shorter steps occur at every edge, where the interpolated field is discontinuous.
inline constexpr double kLongestStep = 0.05;
/// The finest division of t.
inline constexpr double kFinestDivision = 1e-9;

struct Bridge {
  double t0 = 0;
  double t1 = 1;
  /// kJump, or the status of the first sample in the interval.
  SampleStatus reason = SampleStatus::kJump;
  /// Over [t0, t1].
  ParametricLine line;
};

/// Scratch memory of the search for jumps.
struct JumpWorkspace {
  Array<double> weights;
};

/// The bridge's point at t, clamped to [t0, t1].
SurfacePoint pointAt(const TriangleMesh& mesh, const Bridge& bridge, double t);

/// Appends the bridge's points between two parameters, excluding the first and including the last.
void appendPart(const TriangleMesh& mesh, const Bridge& bridge, double from, double to,
                Array<SurfacePoint>& out);

/// The bridge over t, or none.
const Bridge* bridgeOver(const Array<Bridge>& bridges, double t);

/// Makes a traced segment whole: finds where its samples (two at least, ascending in t) are not
/// converged or jump, bridges these intervals, and moves the samples inside onto the bridges with
/// the status kBridged. Returns the bridges, ascending in t.
///
/// Between two neighbouring samples a bridge is the geodesic that joins them. Steps well inside a
/// face, or shorter than half of `kLongestStep`, need no check; others are divided until their
/// parts are one or the other.
///
/// `basis` and `pointWeights` give the weights (segment_basis.h); where all weight is on one
/// control point a bridge passes that point. `middles`: the weights at the middles between the
/// samples' parameters where these are evenly spaced, else none. Evenly spaced samples of a segment
/// that breaks are traced anew in both directions (branches.h), but for the paper's method; samples
/// that a tolerance placed stay where they are.
Array<Bridge> bridgeSegment(SegmentFields& fields, const SegmentBasis& basis,
                            const Array<double>& pointWeights, const WeightTable* middles,
                            Method method, Array<CurveSample>& samples, JumpWorkspace& workspace);

}  // namespace karcher

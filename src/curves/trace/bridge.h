#pragma once

#include <array>

#include "curves/polygon/subdivision.h"
#include "curves/trace/jumps.h"

/// Bridges over the gaps of curves. Where control points lie too far apart, the curve has no center
/// of mass, or the center jumps from one local minimum to another. From the last sample before such
/// a gap to the first one after it, the curve follows a bridge instead: the subdivision curve of
/// the segment's own control points (subdivision.h), with its ends moved to those two samples. So
/// the curve is continuous everywhere, and its samples show where and why centers of mass are
/// missing.
namespace karcher {

struct Bridge {
  double t0 = 0;
  double t1 = 1;
  /// kJump, kSubdivided, or the status of the interval's first search that found no center.
  SampleStatus reason = SampleStatus::kJump;
  /// The bridge's line over [t0, t1].
  ParametricLine line;
};

/// The status of the samples on a bridge.
inline SampleStatus statusOn(const Bridge& bridge) {
  return bridge.reason == SampleStatus::kSubdivided ? SampleStatus::kSubdivided
                                                    : SampleStatus::kBridged;
}

/// Reusable scratch memory.
struct BridgeWorkspace {
  /// An interval between two samples that needs a bridge. The bridge keeps an end of the interval
  /// if this end is a center.
  struct Interval {
    int first = 0;
    int last = 0;
    bool keepsFirst = true;
    bool keepsLast = true;
    SampleStatus reason = SampleStatus::kJump;
  };

  Array<double> weights;
  Array<Jump> jumps;
  Array<CurveSample> back;
  Array<Interval> intervals;
  SubdivisionWorkspace subdivision;
  Array<SurfacePoint> points;  ///< the segment's control points
  Array<SurfacePoint> polygon;
  std::array<Array<double>, 4> bezier;  ///< the weights for each control point of a cubic
  SurfacePath chord;
  ParametricLine line;  ///< the line of the current bridge
};

/// The bridge's point at the parameter t, which is clamped to [t0, t1].
SurfacePoint pointAt(const TriangleMesh& mesh, const Bridge& bridge, double t);

/// Appends the bridge's points between two parameters, excluding the first and including the last.
void appendPart(const TriangleMesh& mesh, const Bridge& bridge, double from, double to,
                Array<SurfacePoint>& out);

/// The bridge over t, or null.
const Bridge* bridgeOver(const Array<Bridge>& bridges, double t);

/// Completes a traced segment and writes its bridges, ascending in t. The segment has at least two
/// samples, ascending in t. The function finds the intervals in which samples are not converged or
/// the curve jumps, bridges them, and moves the samples inside onto the bridges with the status
/// kBridged. Between two neighbouring samples a bridge is the geodesic that joins them. At a t
/// where one control point has all the weight, a bridge passes through that point. `basis` and
/// `pointWeights` give the weights (segment_basis.h).
///
/// `table` has the weights with which `traceSegment` found the samples; it is null if a tolerance
/// placed the samples. With a table, the function also traces a broken segment backwards
/// (branches.h), except by the paper's method. It does not retrace samples that a tolerance placed.
void bridgeSegment(SegmentFields& fields, const SegmentBasis& basis,
                   const Array<double>& pointWeights, const PieceWeights* table, Method method,
                   Array<CurveSample>& samples, BridgeWorkspace& workspace, Array<Bridge>& bridges);

}  // namespace karcher

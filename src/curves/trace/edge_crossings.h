#pragma once

#include "curves/trace/segment.h"

/// Crossings of a curve of centers of mass with the edges of the mesh. The faces on both sides of
/// an edge share its frame. In this frame, the blended field along the edge is linear between its
/// values X_a(t) and X_b(t) at the ends. If faces are divided (cells.h), the field is linear
/// between an end and the middle. The field has a zero on the edge's line where X_a(t) x X_b(t) =
/// 0: at this t the curve passes from face to face, through the same point from either side.
///
/// Inside a face the field also depends on transport, so that the curve in the face ends a small
/// fraction of an edge beside that point (crossing_study). The polyline through the crossings
/// closes these gaps.
namespace karcher {

/// Reusable scratch memory.
struct CrossingWorkspace {
  Array<CurveSample> found;
  Array<double> weights;
  EdgeField field;
};

class EdgeCrossings {
 public:
  /// The arguments must outlive the object.
  EdgeCrossings(SegmentFields& fields, const BasisWriter& basis, Method method,
                CrossingWorkspace& workspace);

  /// Appends the crossings between two converged samples, in ascending t, and then the later
  /// sample. If the samples' faces do not share an edge, the function finds more samples and
  /// appends them, too. Returns false and leaves `out` unchanged if a search for a sample fails, or
  /// if kMostBisections bisections do not suffice to decide which edges the curve crosses, for
  /// instance near a vertex.
  bool append(const CurveSample& from, const CurveSample& to, Array<SurfacePoint>& out);

  /// The result of the last call: the crossings, on edges, and the samples between them.
  const Array<CurveSample>& found() const { return workspace_.found; }

  static constexpr int kMostBisections = 10;

 private:
  bool appendBetween(const CurveSample& from, const CurveSample& to, int bisections);
  bool appendCrossing(int h, double t0, double t1);
  /// Appends the crossing of an edge, or of one half of it if faces are divided. The curve may pass
  /// the edge's line between t0 and t1 although rounding hides this. With `orNearest` the crossing
  /// is then at t0 or at t1, whichever is nearer to the line. Returns false if there is no
  /// crossing.
  bool appendCrossing(int h, int half, double t0, double t1, bool orNearest);

  const Geometry& geometry_;
  const BasisWriter& basis_;
  Method method_;
  FieldBlend& fields_;
  CrossingWorkspace& workspace_;
};

}  // namespace karcher

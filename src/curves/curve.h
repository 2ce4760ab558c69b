#pragma once

#include <memory>

#include "curves/segment.h"

namespace karcher {

enum class CurveKind {
  kBSpline,  ///< uniform cubic B-spline: a segment for each four consecutive points
  kBezier,   ///< one segment of degree (points - 1)
};

struct CurveOptions {
  CurveKind kind = CurveKind::kBSpline;
  int samples = 128;  ///< a segment, at t = i / (samples - 1)
  FieldOptions field;
};

/// A curve that is edited. A change is made by one of the editing functions and carried out by
/// `updateFields`, `trace` and `join`, in this order, each of which does only what changed. The
/// curve after any edits is the one that its points give anew.
class Curve {
 public:
  /// The surface must outlive the curve. Throws Error kTooFewPoints (fewer than 4 for a B-spline,
  /// 2 for a Bezier curve), kUnreachable (points on several components), kBadArgument.
  Curve(Surface& surface, const CurveOptions& options, const Array<SurfacePoint>& points);

  /// Each throws Error and changes nothing where the curve would be none, or kBadIndex.
  void movePoint(int i, const SurfacePoint& point);
  void insertPoint(int i, const SurfacePoint& point);
  void removePoint(int i);
  void setKind(CurveKind kind);

  /// Marks all segments to be traced anew, with the fields as they are.
  void retrace();

  void updateFields();
  void trace();
  void join();

  const CurveOptions& options() const { return options_; }
  int pointCount() const { return points_.count(); }
  const SurfacePoint& point(int i) const { return points_[i]->position; }
  int segmentCount() const { return segments_.count(); }
  const Array<CurveSample>& samples(int segment) const { return segments_[segment].samples; }
  const JoinedPath& path(int segment) const { return segments_[segment].path; }

 private:
  struct ControlPoint {
    SurfacePoint position;
    std::unique_ptr<PointField> field;
    bool moved = true;
  };
  struct Segment {
    Array<CurveSample> samples;
    JoinedPath path;
    bool traced = false;
    bool joined = false;
  };

  void check(CurveKind kind, const Array<SurfacePoint>& points) const;
  void checkIndex(int i, int count) const;
  Array<SurfacePoint> positions() const;
  std::unique_ptr<ControlPoint> makePoint(const SurfacePoint& position) const;
  /// Segment j blends the points j to j + pointsPerSegment() - 1.
  int pointsPerSegment() const;
  void resetSegments();

  Surface& surface_;
  CurveOptions options_;
  Array<std::unique_ptr<ControlPoint>> points_;
  Array<Segment> segments_;
  WeightTable weights_;
};

}  // namespace karcher

#pragma once

#include <memory>
#include <utility>

#include "curves/spec/curve_layout.h"
#include "curves/trace/joined_path.h"

namespace karcher {

struct CurveOptions {
  CurveShape shape;
  int samples = 128;  ///< a segment, at t = i / (samples - 1)
  FieldOptions field;
  /// If positive, segments get as many samples as it needs instead: the curve's largest distance
  /// from the geodesics between samples, as a part of the bounding box's diagonal (sampling.h).
  double tolerance = 0;
  CurveGeometry geometry = CurveGeometry::kGeodesic;
};

/// A curve that is edited. A change is made by one of the editing functions and carried out by
/// `updateFields`, `trace` and `join`, in this order, each of which does only what changed; until
/// then the curve may show what it was. After any edits it is the one that its shape and points
/// give anew.
///
/// Its parameter runs from 0 to segmentCount(): the number of a segment plus t in [0, 1].
class Curve {
 public:
  /// The surface must outlive the curve. Throws Error kUnreachable (points on several components),
  /// kBadArgument (samples or tolerance), and what `checkGivenShape` throws.
  Curve(Surface& surface, CurveOptions options, const Array<SurfacePoint>& points);

  // Each throws Error and changes nothing where the curve would be none, or kBadIndex. A change of
  // weights or betas alone computes no field anew.
  void movePoint(int i, const SurfacePoint& point);
  void insertPoint(int i, const SurfacePoint& point);
  void removePoint(int i);
  /// Makes point `from` the one of number `to`.
  void movePointInOrder(int from, int to);
  void reverse();
  void setKind(CurveKind kind);
  void setClosed(bool closed);
  void setWeight(int i, double weight);
  void setBeta(int i, double beta);
  /// Another shape with other points. Points that stay where they are keep their fields.
  void change(const CurveShape& shape, const Array<SurfacePoint>& points);

  /// Marks all segments to be traced anew, with the fields as they are.
  void retrace();

  void updateFields();
  void trace() {
    findSamples();
    bridge();
  }
  void join();

  /// The two parts of `trace`: the searches for the samples, then what makes the curve whole where
  /// they fail or jump (bridge.h).
  void findSamples();
  void bridge();

  Surface& surface() const { return surface_; }
  const CurveOptions& options() const { return options_; }
  const CurveShape& shape() const { return options_.shape; }
  int pointCount() const { return points_.count(); }
  const SurfacePoint& point(int i) const { return points_[i].position; }
  Array<SurfacePoint> points() const;
  int segmentCount() const { return segments_.count(); }
  const Array<CurveSample>& samples(int segment) const {
    return segments_[segment].traced->samples;
  }
  const JoinedPath& path(int segment) const { return segments_[segment].traced->path; }
  /// The intervals of a segment where it is no center of mass.
  const Array<Bridge>& bridges(int segment) const { return segments_[segment].traced->bridges; }
  /// How many fields were computed since the curve was made: the work that edits should spare.
  int fieldsComputed() const { return fieldsComputed_; }

  /// The numbers of the control points that a segment blends, and their weights at t.
  const Array<int>& pointsOf(int segment) const { return segments_[segment].layout.points; }
  Array<double> weights(int segment, double t) const;
  /// The fields of these points, after `updateFields`.
  Array<PointField*> fieldsOf(int segment) const;

 private:
  /// A control point. Its stamp changes with its place: what was made for equal stamps still holds.
  struct ControlPoint {
    SurfacePoint position;
    int64_t stamp = 0;
    struct Field {
      Field(Surface& surface, const FieldOptions& options) : field(surface, options) {}
      PointField field;
      int64_t stamp = 0;
    };
    std::shared_ptr<Field> field;
  };
  /// At the samples and between them.
  struct SegmentWeights {
    WeightTable samples;
    WeightTable middles;
  };
  struct Traced {
    /// While the segment is being made; from its first step to `join`.
    std::optional<SegmentFields> fields;
    Array<CurveSample> samples;
    Array<Bridge> bridges;
    JoinedPath path;
    bool isSampled = false;
    bool isBridged = false;
    bool isJoined = false;
  };
  struct Segment {
    SegmentLayout layout;
    Array<double> pointWeights;  ///< empty where the basis is not rational
    Array<int64_t> stamps;       ///< of its points
    /// Of the basis alone, and with the points' weights; segments share them.
    std::shared_ptr<const SegmentWeights> basisTable;
    std::shared_ptr<const SegmentWeights> table;
    std::shared_ptr<Traced> traced;
  };
  struct Gap {
    int64_t from = 0;
    int64_t to = 0;
    double length = 0;
  };

  void apply(CurveShape shape, Array<ControlPoint> points);
  void checkIndex(int i, int count) const;
  ControlPoint makePoint(const SurfacePoint& position);
  Array<Segment> makeSegments(const CurveShape& shape, const Array<ControlPoint>& points) const;
  void makeTables(Segment& segment) const;
  void updateGaps();
  void findSamplesOf(int segment);
  SegmentFields& blendedFieldsOf(int segment);

  Surface& surface_;
  CurveOptions options_;
  Array<ControlPoint> points_;
  Array<Segment> segments_;
  /// Of centripetal curves, whose segments depend on distances between points.
  Array<Gap> gaps_;
  bool stale_ = false;  ///< the segments are to be made anew from the gaps
  int64_t lastStamp_ = 0;
  int fieldsComputed_ = 0;
};

}  // namespace karcher

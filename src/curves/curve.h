#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "curves/curve_value.h"
#include "curves/polygon/large_faces.h"
#include "curves/trace/piece.h"
#include "curves/trace/sampling.h"
#include "rcm/field_set.h"

namespace karcher {

/// The durations of the last edit's stages, in the clock's unit; 0 without a clock.
struct StageTimes {
  double polygon = 0;  ///< the duration of legs, levels and the refined polygon
  double fields = 0;
  double samples = 0;
  double bridges = 0;
  double joins = 0;
};

/// The curve of a value (curve_value.h) on a surface. Every edit sets another value.
///
/// A parameter is the index of a segment plus t in [0, 1]; it runs from 0 to segmentCount().
class Curve {
 public:
  /// A piece of a segment (piece.h). Its points are centers of mass of a few points of the refined
  /// polygon, except on subdivision curves and polylines.
  class Piece {
   public:
    const Array<SurfacePoint>& points() const { return points_; }
    /// The samples, in t of the piece.
    const Array<CurveSample>& samples() const { return traced_->samples; }
    const Array<Bridge>& bridges() const { return traced_->bridges; }
    const JoinedPath& path() const { return traced_->path; }
    /// Whether the piece is a subdivision curve, without centers of mass: it crosses a face larger
    /// than itself, and its control points do not see all corners of the faces along its legs
    /// (findSubdivided).
    bool isSubdivided() const { return isSubdivided_; }
    /// The points' weights at t in [0, 1] of the piece.
    Array<double> weights(double t) const;

   private:
    friend class Curve;
    Array<SurfacePoint> points_;
    Array<double> pointWeights_;  ///< empty if the basis is not rational
    SegmentBasis basis_;
    PartOfSegment part_;
    /// `basisTable_` has the weights of the basis alone. `table_` has these weights with the
    /// points' weights as factors. Pieces with equal weights share a table.
    std::shared_ptr<PieceWeights> basisTable_;
    std::shared_ptr<const PieceWeights> table_;
    std::shared_ptr<TracedPiece> traced_;
    bool isTraced_ = false;
    bool isSubdivided_ = false;
    bool isFirst_ = false;  ///< whether it is the first piece of an open curve
    bool isLast_ = false;
    Array<std::shared_ptr<PointField>> fields_;  ///< the points' fields, after their first use
  };

  /// The surface must outlive the curve. Throws what `set` and `checkGivenShape` throw. The clock,
  /// if present, measures the stages of all edits, including this first one.
  Curve(Surface& surface, CurveValue value, std::function<double()> clock = {});
  Curve(Surface& surface, CurveOptions options, Array<SurfacePoint> points)
      : Curve(surface, CurveValue{std::move(options), std::move(points), {}}) {}
  /// A curve that shares its fields with all users of these sets.
  Curve(std::shared_ptr<FieldSets> sets, CurveValue value, std::function<double()> clock = {});

  /// Becomes the curve of another value. The result equals a new curve of this value. Keeps the
  /// fields of unchanged points and the traces of unchanged pieces. On failure the curve is
  /// unchanged. Throws Error: kUnreachable (points on several components), kBadArgument (field
  /// options, samples, tolerances, levels, the number of legs), what `checkShape` throws (with new
  /// field options also `checkGivenShape`), and what a basis of the caller's throws.
  void set(CurveValue value);

  // Each edit sets the value that results from the edit.
  void movePoint(int i, const SurfacePoint& point) { set(withPointPlaced(value_, i, point)); }
  /// Moves a point in a drag: the curve extends the legs that meet at the point, and searches no
  /// new ones.
  void dragPoint(int i, const SurfacePoint& point) {
    set(withPointDragged(value_, i, point, usesLegs(options()) ? legs() : usedLegs()));
  }
  void insertPoint(int i, const SurfacePoint& point) { set(withPointInserted(value_, i, point)); }
  void removePoint(int i) { set(withPointRemoved(value_, i)); }
  void movePointInOrder(int from, int to) { set(withPointMovedInOrder(value_, from, to)); }
  void reverse() { set(reversed(value_)); }
  void setKind(CurveKind kind) { set(withKind(value_, kind)); }
  void setClosed(bool closed) { set(withClosed(value_, closed)); }
  void setWeight(int i, double weight) { set(withWeight(value_, i, weight)); }
  void setBeta(int i, double beta) { set(withBeta(value_, i, beta)); }

  const CurveValue& value() const { return value_; }
  /// The legs of the control polygon on the surface.
  const Array<SurfacePath>& legs();
  /// The legs of the control polygon if the curve uses them, else none.
  const Array<SurfacePath>& usedLegs() const;
  /// The number of levels, which the options may leave to the curve. It is 0 if a Catmull-Rom
  /// curve's handle would lie beyond the surface's boundary.
  int levels() const { return levels_; }
  /// The estimated largest distance, in the mesh's units, between the curve and the curve of level
  /// 0 with the same points (Eq. 4). It is 0 without levels, and NaN if the curve of level 0 is not
  /// safe (automatic_levels.h), so that the distance has no meaning.
  double deviation();
  /// Whether the curve's points are centers of mass. Otherwise they lie on legs or are averages of
  /// two points.
  bool isOfCenters() const { return isOfCenters(options(), levels()); }

  Surface& surface() const { return fieldSet_->surface(); }
  const CurveOptions& options() const { return value_.options; }
  const CurveShape& shape() const { return value_.options.shape; }
  int pointCount() const { return value_.points.count(); }
  const SurfacePoint& point(int i) const { return value_.points[i]; }
  const Array<SurfacePoint>& points() const { return value_.points; }
  int segmentCount() const { return segments_.count(); }
  const Array<CurveSample>& samples(int segment) const { return segments_[segment].whole->samples; }
  const JoinedPath& path(int segment) const { return segments_[segment].whole->path; }
  /// The bridges of a segment, over the intervals in which its points are no centers of mass.
  const Array<Bridge>& bridges(int segment) const { return segments_[segment].whole->bridges; }

  /// The number of pieces of a segment, the same for all segments.
  int piecesPerSegment() const { return 1 << levels_; }
  const Piece& piece(int segment, int k) const { return segments_[segment].pieces[k]; }
  /// The fields of a piece's points.
  Array<PointField*> fieldsOf(int segment, int k = 0);

  /// The indices of the control points that a segment blends, at level 0.
  const Array<int>& pointsOf(int segment) const { return segments_[segment].points; }
  /// The weights of a segment's control points at t, at level 0.
  Array<double> weights(int segment, double t) const { return piece(segment, 0).weights(t); }

  /// The number of fields that edits have created or moved so far. A good edit adds few.
  int fieldsMade() const { return fieldsMade_; }

  /// The durations of the last edit's stages, if the curve has a clock.
  const StageTimes& times() const { return times_; }

 private:
  struct Segment {
    Array<Piece> pieces;
    Array<int> points;  ///< the control points at level 0
    std::shared_ptr<TracedSegment> whole;
  };
  /// The state that an edit prepares. If the edit succeeds, it becomes the state of the curve, and
  /// the next edit reuses the memory of the old state.
  struct Next {
    CurveValue value;
    int levels = 0;
    bool isNear = false;  ///< whether the fields are near fields
    bool jumps = false;   ///< whether the curve jumps at level 0, although it seemed safe
    Array<SurfacePath> legs;
    Array<Segment> segments;
    RefinedPolygon polygon;
  };
  /// Scratch memory of edits. The result of an edit does not depend on what the memory holds
  /// before.
  struct Workspace {
    AveragingWorkspace averaging;
    LeggedPolygon polygon;
    std::optional<SegmentFields> blend;
    Array<PointField*> fields;
    LevelsWorkspace levels;
    RefinedPolygon control;  ///< the control polygon, which determines the levels
    FacesAlongLegs along;
    Array<char> isSubdivided;  ///< whether each piece of the refined polygon is a subdivision curve
    Array<std::shared_ptr<PointField>> near;     ///< the fields that decided `isSubdivided`
    Array<std::shared_ptr<PointField>> ofKnots;  ///< the fields that space the knots
    /// The segments of the last control polygon, which had `layoutPoints` points and the shape
    /// `layoutShape`. Their knots may still have the spacing of another polygon.
    Array<SegmentLayout> layout;
    CurveShape layoutShape;
    int layoutPoints = 0;
    Array<double> gaps;
    Array<double> spacings;
    SamplingWorkspace sampling;
    CrossingWorkspace crossings;
    BridgeWorkspace bridging;
    Array<const TracedPiece*> pieces;
  };

  static bool isOfCenters(const CurveOptions& options, int levels);
  void check(const CurveValue& value) const;
  void continueLegs(CurveValue& value);
  void takeLegs(const CurveValue& value, Array<SurfacePath>& legs) const;
  void make(Next& next);
  void makeStages(Next& next);
  void countTime(double& stage);
  void makeLegs(Next& next) const;
  void makeSegments(Next& next);
  void makePolygon(Next& next);
  bool jumpsAtLevelZero(const Next& next) const;
  int levelsOf(const Next& next);
  void takeControlPolygon(const CurveValue& value, RefinedPolygon& polygon);
  RefinedPolygon& leggedPolygon(const CurveValue& value, const Array<SurfacePath>& legs);
  bool joinsByShortestPaths(const RefinedPolygon& polygon);
  double distanceTo(const SurfacePoint& place, PointField& field);
  void layKnots(const Next& next);
  void findSubdivided(const Next& next);
  bool seesFaces(const Next& next, const SegmentLayout& piece);
  void makePiece(Next& next, int j, const SegmentLayout& layout, const PartOfSegment& part,
                 bool keep);
  void makeTables(const Next& next, const SegmentLayout& layout, Piece& piece);
  void makeFields(Next& next);
  void trace(Next& next);
  static BasisWriter basisOf(const Piece& piece);
  void findSamples(const Next& next, Piece& piece, int segment);
  void findAveragedSamples(const Next& next, Piece& piece, int segment);
  static std::optional<SurfacePoint> knownEnd(const Next& next, const Piece& piece, double t);
  SurfacePoint centerOf(const Next& next, const SurfacePoint& point);
  void layOwnSubdivision(Piece& piece);
  void layBridges(const Next& next, Piece& piece);
  void join(const Next& next, Piece& piece);
  void merge(Next& next);
  SegmentFields& blendFields();
  static void releaseFields(Array<Segment>& segments);

  std::shared_ptr<FieldSets> fieldSets_;
  std::shared_ptr<FieldSet> fieldSet_;
  CurveValue value_;
  int levels_ = 0;
  bool isNear_ = false;
  bool jumps_ = false;
  Array<SurfacePath> legs_;  ///< empty until first used
  Array<Segment> segments_;
  Next next_;
  std::shared_ptr<Workspace> workspace_ = std::make_shared<Workspace>();
  std::function<double()> clock_;
  StageTimes times_;
  double lastTime_ = 0;  ///< the time up to which `times_` counts
  int fieldsMade_ = 0;
};

}  // namespace karcher

#include "curves/curve.h"

#include <algorithm>
#include <string>

#include "curves/spec/bases.h"
#include "curves/trace/sampling.h"
#include "distance/find_path.h"
#include "distance/shortest_path.h"
#include "intrinsic/straighten.h"
#include "mesh/error.h"

namespace karcher {
namespace {

bool isCornerOf(const TriangleMesh& mesh, int face, int vertex) {
  return mesh.corner(face, 0) == vertex || mesh.corner(face, 1) == vertex ||
         mesh.corner(face, 2) == vertex;
}

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

bool areSame(const Array<SurfacePoint>& a, const Array<SurfacePoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
}

/// Whether traces of a curve with options a are valid with options b, and vice versa.
bool traceAlike(const CurveOptions& a, const CurveOptions& b) {
  return a.samples == b.samples && a.tolerance == b.tolerance && a.geometry == b.geometry &&
         a.shape.kind == b.shape.kind && (a.levels == kLimitLevels) == (b.levels == kLimitLevels);
}

void checkOptions(const CurveOptions& options) {
  checkFieldOptions(options.field);
  if (options.samples < 2 || options.samples > kMostSamples) {
    throw Error(ErrorCode::kBadArgument, "a segment takes 2 to " + std::to_string(kMostSamples) +
                                             " samples, not " + std::to_string(options.samples));
  }
  if (options.tolerance != 0) checkTolerance(options.tolerance);
  if (!(options.levelsTolerance >= 0)) {
    throw Error(ErrorCode::kBadArgument, "the tolerance of levels is at least 0 mean edges, not " +
                                             inSentence(options.levelsTolerance));
  }
  if (!takesLevels(options.field.method) && options.levels != 0 &&
      options.levels != kAutomaticLevels) {
    throw Error(ErrorCode::kBadArgument,
                "the paper's method is one center of mass a segment: it takes 0 levels");
  }
}

/// Throws if a value has legs, but not one for each pair of consecutive points.
void checkLegCount(const CurveValue& value) {
  const int wanted = legCount(value.options.shape, value.points.count());
  if (value.legs.empty() || value.legs.count() == wanted) return;
  throw Error(ErrorCode::kBadArgument, "the control polygon has " + std::to_string(wanted) +
                                           " legs, not " + std::to_string(value.legs.count()));
}

double legsLength(const RefinedPolygon& polygon, const SegmentLayout& piece) {
  double length = 0;
  for (int k = 1; k < piece.points.count(); ++k) {
    length += polygon.legs[piece.points[k - 1]].length();
  }
  return length;
}

/// The number of evenly spaced samples with which the chords of a polynomial curve stay within a
/// tolerance of the curve. In degree n, the second derivative is at most 2 n (n - 1) times the
/// control polygon's length. A chord over the fraction 1 / m of the curve deviates by at most 1 /
/// (8 m^2) times the second derivative.
int samplesWithin(double tolerance, int degree, double polygonLength) {
  const double chords = std::sqrt(degree * (degree - 1) / 4.0 * polygonLength / tolerance);
  return 2 + static_cast<int>(std::min(chords, kMostSamples - 2.0));
}

/// The path for a leg that a value omits: the fast path (find_path.h), or for a polyline the exact
/// shortest path.
SurfacePath shortestLeg(const Geometry& geometry, const CurveOptions& options,
                        const SurfacePoint& from, const SurfacePoint& to) {
  SurfacePath leg;
  if (options.shape.kind != CurveKind::kPolyline) {
    FindPathWorkspace workspace;
    // The points lie on one component, so that a path exists.
    findPath(geometry, from, to, workspace, leg);
    return leg;
  }
  // A polyline's legs are the curve, so they are exact.
  leg = pathThrough(*geometry.mesh, shortestPath(geometry, from, to).points);
  leg.points.front() = from;
  leg.points.back() = to;
  return leg;
}

}  // namespace

Array<double> Curve::Piece::weights(double t) const {
  if (pointWeights_.empty()) return weightsAt(basis_, t);
  return rationalBasis(weightsAt(basis_, t), pointWeights_);
}

Curve::Curve(Surface& surface, CurveValue value, std::function<double()> clock)
    : Curve(std::make_shared<FieldSets>(surface), std::move(value), std::move(clock)) {}

Curve::Curve(std::shared_ptr<FieldSets> sets, CurveValue value, std::function<double()> clock)
    : fieldSets_(std::move(sets)),
      fieldSet_(trimmedAfter(fieldSets_->of(value.options.field))),
      clock_(std::move(clock)) {
  checkOptions(value.options);
  checkGivenShape(value.options.shape, value.points.count());
  set(std::move(value));
}

void Curve::set(CurveValue value) {
  next_.value = std::move(value);
  check(next_.value);
  if (!(next_.value.options.field == fieldSet_->options())) {
    // With other field options no part of the curve stays valid. The curve must release its fields
    // before it releases their set.
    Curve other(fieldSets_, std::move(next_.value), clock_);
    other.fieldsMade_ += fieldsMade_;
    segments_.clear();
    *this = std::move(other);
    return;
  }
  const int madeBefore = fieldSet_->made();
  const StageTimes timesBefore = std::exchange(times_, {});
  try {
    make(next_);
  } catch (...) {
    releaseFields(next_.segments);
    times_ = timesBefore;
    throw;
  }
  const int piecesBefore = segments_.count() * piecesPerSegment();
  std::swap(value_, next_.value);
  levels_ = next_.levels;
  isNear_ = next_.isNear;
  jumps_ = next_.jumps;
  legs_.swap(next_.legs);
  segments_.swap(next_.segments);
  releaseFields(next_.segments);
  if (segments_.count() * piecesPerSegment() < piecesBefore) {
    fieldSet_->trim();
  }
  // Near fields hold no solver.
  if (!isNear_) {
    for (const Segment& segment : segments_) {
      for (const Piece& piece : segment.pieces) {
        for (const auto& field : piece.fields_) fieldSet_->use(*field);
      }
    }
    fieldSet_->restUnused();
  }
  fieldsMade_ += fieldSet_->made() - madeBefore;
}

void Curve::make(Next& next) {
  lastTime_ = clock_ ? clock_() : 0;
  next.jumps = false;
  continueLegs(next.value);
  makeLegs(next);
  makeStages(next);
  if (!jumpsAtLevelZero(next)) return;
  // The curve of level 0 is not safe after all.
  next.jumps = true;
  releaseFields(next.segments);
  makeStages(next);
}

void Curve::makeStages(Next& next) {
  makeSegments(next);
  countTime(times_.polygon);
  makeFields(next);
  countTime(times_.fields);
  trace(next);
}

/// Adds the time since the last call, or since the beginning of the edit, to a stage.
void Curve::countTime(double& stage) {
  if (!clock_) return;
  const double now = clock_();
  stage += now - lastTime_;
  lastTime_ = now;
}

const Array<SurfacePath>& Curve::legs() {
  if (legs_.empty()) takeLegs(value_, legs_);
  return legs_;
}

const Array<SurfacePath>& Curve::usedLegs() const {
  static const Array<SurfacePath> kNone;
  return usesLegs(options()) ? legs_ : kNone;
}

Array<PointField*> Curve::fieldsOf(int segment, int k) {
  Piece& piece = segments_[segment].pieces[k];
  if (piece.fields_.empty()) {
    for (int i = 0; i < piece.points_.count(); ++i) {
      piece.fields_.push_back(fieldSet_->at(piece.points_[i], isNear_));
    }
  }
  Array<PointField*> fields;
  for (const auto& field : piece.fields_) fields.push_back(field.get());
  return fields;
}

bool Curve::isOfCenters(const CurveOptions& options, int levels) {
  return options.shape.kind != CurveKind::kPolyline &&
         (options.levels != kLimitLevels || levels == 0);
}

void Curve::check(const CurveValue& value) const {
  checkOptions(value.options);
  checkShape(value.options.shape, value.points.count());
  if (value.options.levels != kLimitLevels && mayHaveLevels(value.options)) {
    const bool isAutomatic = value.options.levels == kAutomaticLevels;
    checkLevels(value.options.shape, value.points.count(),
                isAutomatic ? value.options.leastLevels : value.options.levels);
  }
  checkOneComponent(surface(), value.points);
  checkLegCount(value);
}

/// Extends each leg that does not reach its points. If no strip of faces joins a leg to its points,
/// or if the curve does not use legs, the leg becomes the shortest path.
void Curve::continueLegs(CurveValue& value) {
  const Geometry& geometry = surface().geometry();
  StripWorkspace& workspace = workspace_->averaging.strip;
  for (int i = 0; i < value.legs.count(); ++i) {
    SurfacePath& leg = value.legs[i];
    if (leg.points.empty()) continue;
    const SurfacePoint& from = value.points[i];
    const SurfacePoint& to = value.points[(i + 1) % value.points.count()];
    const bool startsThere = samePlace(*geometry.mesh, leg.start(), from);
    const bool endsThere = samePlace(*geometry.mesh, leg.end(), to);
    // The frames of a leg's ends are those of the points' faces.
    if (startsThere) leg.points.front() = from;
    if (endsThere) leg.points.back() = to;
    if (startsThere && endsThere) continue;
    const bool reaches = usesLegs(value.options) &&
                         (endsThere || moveEnd(geometry, to, leg, workspace)) &&
                         (startsThere || moveStart(geometry, from, leg, workspace));
    if (!reaches) makeShortest(leg);
  }
}

/// Writes the legs of a value. Legs that the value omits are shortest paths. `legs` may be `legs_`
/// itself if `legs_` is empty.
void Curve::takeLegs(const CurveValue& value, Array<SurfacePath>& legs) const {
  const Geometry& geometry = surface().geometry();
  const int points = value.points.count();
  const bool isPolyline = value.options.shape.kind == CurveKind::kPolyline;
  const bool wasPolyline = shape().kind == CurveKind::kPolyline;
  const int known = legs_.count();
  legs.resize(static_cast<size_t>(legCount(value.options.shape, points)));
  for (int i = 0; i < legs.count(); ++i) {
    const SurfacePoint& from = value.points[i];
    const SurfacePoint& to = value.points[(i + 1) % points];
    if (!value.legs.empty() && !value.legs[i].points.empty()) {
      legs[i] = value.legs[i];
      continue;
    }
    // The leg is the shortest path, which this curve may have already.
    const bool isKnown = i < known && isPolyline == wasPolyline &&
                         (value_.legs.empty() || value_.legs[i].points.empty()) &&
                         isSame(legs_[i].start(), from) && isSame(legs_[i].end(), to);
    if (isKnown) {
      legs[i] = legs_[i];
    } else {
      legs[i] = shortestLeg(geometry, value.options, from, to);
    }
  }
}

/// Writes the legs if the curve uses them.
void Curve::makeLegs(Next& next) const {
  if (!usesLegs(next.value.options)) {
    next.legs.clear();
    return;
  }
  takeLegs(next.value, next.legs);
}

void Curve::makeSegments(Next& next) {
  const CurveOptions& options = next.value.options;
  const CurveShape& shape = options.shape;
  makePolygon(next);
  next.isNear = areFieldsNear(shape, next.value.points.count(), next.legs, next.levels);
  workspace_->isSubdivided.clear();
  if (next.levels == 0) {
    if (shape.kind == CurveKind::kCatmullRom) layKnots(next);
    next.polygon.pieces = workspace_->layout;
  } else if (isOfCenters(options, next.levels)) {
    findSubdivided(next);
  }
  const int pieces = 1 << next.levels;
  // A polyline's legs are the curve, but the comparison of pieces does not compare legs. So pieces
  // stay only if both values omit the legs.
  const bool keep =
      traceAlike(options, value_.options) && next.isNear == isNear_ &&
      (shape.kind != CurveKind::kPolyline || (next.value.legs.empty() && value_.legs.empty()));
  const int segments = next.polygon.pieces.count() / pieces;
  next.segments.resize(static_cast<size_t>(segments));
  for (int j = 0; j < segments; ++j) {
    Segment& segment = next.segments[j];
    segment.points.clear();
    if (next.levels == 0) segment.points = next.polygon.pieces[j].points;
    segment.pieces.resize(static_cast<size_t>(pieces));
    for (int k = 0; k < pieces; ++k) {
      makePiece(next, j, next.polygon.pieces[j * pieces + k], {k, pieces}, keep);
    }
  }
}

/// Finds the pieces that are subdivision curves, without centers of mass. Such a piece crosses a
/// face larger than itself, and its points do not see all corners of the faces along its legs. A
/// hidden corner is far away, across creases or many faces, and matters little to the curve. The
/// piece itself lies in a few faces. Its subdivision curve needs no field, and differs from the
/// centers of mass only at the edges between these faces. Curves with a caller's levels or exact
/// fields have no such pieces. B-splines have none either: some of their joints are not control
/// points, and at these joints a center and an average differ.
void Curve::findSubdivided(const Next& next) {
  const RefinedPolygon& polygon = next.polygon;
  Array<char>& isSubdivided = workspace_->isSubdivided;
  isSubdivided.clear();
  const CurveOptions& options = next.value.options;
  if (options.levels != kAutomaticLevels || options.shape.kind == CurveKind::kBSpline ||
      options.field.solver != Solver::kFast) {
    return;
  }
  FacesAlongLegs& along = workspace_->along;
  findFacesAlongLegs(surface().geometry(), polygon, along);
  for (const SegmentLayout& piece : polygon.pieces) {
    isSubdivided.push_back(crossesLargerFace(polygon, piece, along) && !seesFaces(next, piece));
  }
  workspace_->near.clear();
}

/// Whether the points of a piece see all corners of the faces along its legs.
bool Curve::seesFaces(const Next& next, const SegmentLayout& piece) {
  const TriangleMesh& mesh = surface().mesh();
  const FacesAlongLegs& along = workspace_->along;
  Array<std::shared_ptr<PointField>>& near = workspace_->near;
  for (const int point : piece.points) {
    near.push_back(fieldSet_->at(next.polygon.points[point].point, true));
    for (int k = 1; k < piece.points.count(); ++k) {
      const int leg = piece.points[k - 1];
      for (int i = along.begin[leg]; i < along.begin[leg + 1]; ++i) {
        // A face along a leg shares two corners with the previous face; these have been tested.
        const int before = i > along.begin[leg] ? along.faces[i - 1] : -1;
        for (int corner = 0; corner < 3; ++corner) {
          const int vertex = mesh.corner(along.faces[i], corner);
          if (before >= 0 && isCornerOf(mesh, before, vertex)) continue;
          if (!near.back()->sees(vertex)) return false;
        }
      }
    }
  }
  return true;
}

/// Spaces the knots of a Catmull-Rom curve of level 0. Centripetal knots follow the distances
/// between consecutive points. Each distance is the mean of the values of both points' fields, so
/// that the curve is the same from either end.
void Curve::layKnots(const Next& next) {
  const CurveShape& shape = next.value.options.shape;
  const Array<SurfacePoint>& points = next.value.points;
  const int spans = legCount(shape, points.count());
  Array<double>& gaps = workspace_->gaps;
  gaps.assign(static_cast<size_t>(spans), 1);
  if (shape.centripetal) {
    const auto distanceBetween = [&](const SurfacePoint& from, const SurfacePoint& to) {
      // The workspace keeps the field until its piece takes it.
      workspace_->ofKnots.push_back(fieldSet_->at(from));
      return distanceTo(to, *workspace_->ofKnots.back());
    };
    for (int i = 0; i < spans; ++i) {
      const SurfacePoint& from = points[i];
      const SurfacePoint& to = points[(i + 1) % points.count()];
      gaps[i] = (distanceBetween(from, to) + distanceBetween(to, from)) / 2;
    }
  }
  catmullRomSpacings(gaps, shape.centripetal, workspace_->spacings);
  spaceKnots(workspace_->spacings, shape.closed, workspace_->layout);
}

/// Sets piece `part` of segment j. If `keep` and this curve has an equal piece, the function copies
/// it. Otherwise the piece is new, and not yet traced.
void Curve::makePiece(Next& next, int j, const SegmentLayout& layout, const PartOfSegment& part,
                      bool keep) {
  const RefinedPolygon& polygon = next.polygon;
  Piece& piece = next.segments[j].pieces[part.index];
  piece.part_ = part;
  const bool isOpen = !next.value.options.shape.closed;
  piece.isFirst_ = isOpen && j == 0 && part.index == 0;
  piece.isLast_ = isOpen && j + 1 == next.segments.count() && part.index + 1 == part.count;
  piece.basis_ = layout.basis;
  piece.isTraced_ = false;
  const Array<char>& isSubdivided = workspace_->isSubdivided;
  piece.isSubdivided_ = !isSubdivided.empty() && isSubdivided[j * part.count + part.index] != 0;
  piece.table_.reset();
  piece.basisTable_.reset();
  piece.points_.clear();
  piece.pointWeights_.clear();
  for (const int i : layout.points) {
    piece.points_.push_back(polygon.points[i].point);
    if (polygon.weighted) piece.pointWeights_.push_back(polygon.points[i].weight);
  }
  const Piece* before = nullptr;  // this curve's piece of these indices, maybe of equal weights
  if (keep && j < segments_.count() && part.index < segments_[j].pieces.count()) {
    before = &segments_[j].pieces[part.index];
  }
  const auto isAlike = [&](const Piece& other) {
    return other.isTraced_ && other.isSubdivided_ == piece.isSubdivided_ &&
           other.part_ == piece.part_ && other.isFirst_ == piece.isFirst_ &&
           other.isLast_ == piece.isLast_ && areSame(other.points_, piece.points_) &&
           other.basis_ == piece.basis_ && other.pointWeights_ == piece.pointWeights_;
  };
  if (keep) {
    const Piece* alike = before && isAlike(*before) ? before : nullptr;
    // After an insertion or removal of points, an equal piece may belong to another segment.
    for (int i = 0; !alike && i < segments_.count(); ++i) {
      const Array<Piece>& pieces = segments_[i].pieces;
      if (part.index < pieces.count() && isAlike(pieces[part.index])) alike = &pieces[part.index];
    }
    if (alike) {
      piece = *alike;
      return;
    }
  }
  const Piece* sources[] = {before, j > 0 ? &next.segments[j - 1].pieces[part.index] : nullptr};
  for (const Piece* source : sources) {
    if (!source || !(source->part_ == piece.part_) || source->basis_ != piece.basis_) continue;
    if (!piece.basisTable_) piece.basisTable_ = source->basisTable_;
    if (!piece.table_ && source->pointWeights_ == piece.pointWeights_)
      piece.table_ = source->table_;
  }
  makeTables(next, layout, piece);
}

void Curve::makeTables(const Next& next, const SegmentLayout& layout, Piece& piece) {
  const CurveOptions& options = next.value.options;
  const SegmentBasis& basis = piece.basis_;
  // Adaptive sampling needs no table of weights, but making a table also checks a caller's basis.
  const bool hasTolerance = options.tolerance > 0 && isOfCenters(options, next.levels);
  if (hasTolerance && piece.isSubdivided_) {
    const double tolerance = options.tolerance * surface().geometry().diagonal;
    piece.basisTable_ = std::make_shared<PieceWeights>();
    const int samples =
        samplesWithin(tolerance, layout.points.count() - 1, legsLength(next.polygon, layout));
    tabulatePiece(basis, samples, {}, workspace_->bridging.weights, *piece.basisTable_);
    piece.table_.reset();
  }
  const bool isAdaptive = hasTolerance && !piece.isSubdivided_;
  if (isAdaptive && basis.form != BasisForm::kOwn) return;
  if (!piece.basisTable_) {
    piece.basisTable_ = std::make_shared<PieceWeights>();
    tabulatePiece(basis, options.samples, piece.part_, workspace_->bridging.weights,
                  *piece.basisTable_);
  }
  if (piece.table_) return;
  piece.table_ =
      piece.pointWeights_.empty()
          ? piece.basisTable_
          : std::make_shared<PieceWeights>(weighted(*piece.basisTable_, piece.pointWeights_));
}

}  // namespace karcher

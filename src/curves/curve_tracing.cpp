#include <array>

#include "curves/curve.h"
#include "curves/trace/joined_path.h"
#include "curves/trace/polyline.h"
#include "curves/trace/sampling.h"
#include "rcm/mean.h"
#include "rcm/walk_to_center.h"

/// Tracing of a curve's pieces.
namespace karcher {

/// Gives fields to each untraced piece that needs them. The piece first takes the existing fields
/// at its points. Then the curve releases its old fields, and moved or new fields serve the
/// remaining points.
void Curve::makeFields(Next& next) {
  if (!isOfCenters(next.value.options, next.levels)) return;
  const auto forEach = [&](const auto& work) {
    for (Segment& segment : next.segments) {
      for (Piece& piece : segment.pieces) {
        if (!piece.isTraced_ && !piece.isSubdivided_) work(piece);
      }
    }
  };
  forEach([&](Piece& piece) {
    for (int i = 0; i < piece.points_.count(); ++i) {
      piece.fields_.push_back(fieldSet_->find(piece.points_[i], next.isNear));
    }
  });
  for (Segment& segment : segments_) {
    for (Piece& piece : segment.pieces) piece.fields_.clear();
  }
  forEach([&](Piece& piece) {
    for (int i = 0; i < piece.points_.count(); ++i) {
      if (!piece.fields_[i]) piece.fields_[i] = fieldSet_->at(piece.points_[i], next.isNear);
    }
  });
  workspace_->ofKnots.clear();
}

/// Blends the fields that the workspace holds.
SegmentFields& Curve::blendFields() {
  const Array<PointField*>& fields = workspace_->fields;
  std::optional<SegmentFields>& blend = workspace_->blend;
  if (blend) {
    blend->setPoints(fields);
  } else {
    blend.emplace(surface(), fields);
  }
  return *blend;
}

/// Traces the untraced pieces, and merges the pieces of each segment.
void Curve::trace(Next& next) {
  for (int j = 0; j < next.segments.count(); ++j) {
    for (Piece& piece : next.segments[j].pieces) {
      if (piece.isTraced_) continue;
      piece.traced_ = std::make_shared<TracedPiece>();
      findSamples(next, piece, j);
      countTime(times_.samples);
      layBridges(next, piece);
      countTime(times_.bridges);
      join(next, piece);
      piece.isTraced_ = true;
      countTime(times_.joins);
    }
  }
  merge(next);
  countTime(times_.joins);
}

BasisWriter Curve::basisOf(const Piece& piece) {
  return [&piece](double t, Array<double>& weights) {
    weightsAt(piece.basis_, piece.pointWeights_, t, weights);
  };
}

void Curve::findSamples(const Next& next, Piece& piece, int segment) {
  const CurveOptions& options = next.value.options;
  if (options.shape.kind == CurveKind::kPolyline) {
    const int samples = options.tolerance > 0 ? 2 : options.samples;
    *piece.traced_ = traceLeg(surface().mesh(), next.legs[segment], samples);
    return;
  }
  const std::optional<SurfacePoint> first = knownEnd(next, piece, 0);
  const std::optional<SurfacePoint> last = knownEnd(next, piece, 1);
  if (!isOfCenters(options, next.levels) || piece.isSubdivided_) {
    findAveragedSamples(next, piece, segment);
    if (piece.isSubdivided_) {
      // The neighbouring pieces may consist of centers of mass, and then begin and end at the
      // centers by the fields. So this piece begins and ends there, too (`centerOf`).
      piece.traced_->samples.front().point = first ? *first : centerOf(next, piece.points_.front());
      piece.traced_->samples.back().point = last ? *last : centerOf(next, piece.points_.back());
    }
    return;
  }
  workspace_->fields.clear();
  for (const auto& field : piece.fields_) workspace_->fields.push_back(field.get());
  SegmentFields& fields = blendFields();
  fields.first = first;
  fields.last = last;
  Array<CurveSample>& samples = piece.traced_->samples;
  const Method method = options.field.method;
  if (options.tolerance > 0) {
    traceAdaptively(fields, basisOf(piece), nodesOf(piece.basis_), method, options.tolerance,
                    workspace_->sampling, samples);
  } else {
    samples = traceSegment(fields, piece.table_->samples, method, std::move(samples));
  }
}

/// The center at an end of an open curve, if one point has all the weight there. This point is then
/// the center by definition, whereas its estimated field is zero only near it. At a joint of pieces
/// no center is known: there the search in the fields finds it, as at the samples on both sides.
/// The paper's method always searches.
std::optional<SurfacePoint> Curve::knownEnd(const Next& next, const Piece& piece, double t) {
  const bool isEnd = t == 0 ? piece.isFirst_ : piece.isLast_;
  if (!isEnd || next.value.options.field.method == Method::kPaper) return std::nullopt;
  return onlyPoint(piece.points_, piece.weights(t));
}

/// The center of mass of one control point by its field. The adjacent pieces begin or end at this
/// center, not at the point: the zero of the interpolated field lies up to a hundredth of an edge
/// away from the point.
SurfacePoint Curve::centerOf(const Next& next, const SurfacePoint& point) {
  const std::shared_ptr<PointField> field = fieldSet_->at(point, next.isNear);
  workspace_->fields.assign(1, field.get());
  const std::array weights = {1.0};
  const SearchEnd center = walkToCenter(blendFields().blend, weights, point);
  return center.status == Status::kConverged ? center.point : point;
}

/// Samples a piece of the subdivision curve.
void Curve::findAveragedSamples(const Next& next, Piece& piece, int segment) {
  const SegmentLayout& layout =
      next.polygon.pieces[segment * piece.part_.count + piece.part_.index];
  takePolygon(next.polygon, layout, workspace_->polygon);
  Array<CurveSample>& samples = piece.traced_->samples;
  samples.clear();
  for (const double t : piece.table_->samples.t) {
    samples.push_back({t,
                       averageAt(surface().geometry(), layout.basis, workspace_->polygon, t,
                                 workspace_->averaging),
                       SampleStatus::kConverged});
  }
}

/// Writes the single bridge of a piece that is a subdivision curve. The bridge leads from end to
/// end through the samples.
void Curve::layOwnSubdivision(Piece& piece) {
  TracedPiece& traced = *piece.traced_;
  traced.bridges.resize(1);
  Bridge& bridge = traced.bridges[0];
  bridge.t0 = 0;
  bridge.t1 = 1;
  bridge.reason = SampleStatus::kSubdivided;
  SurfacePath& path = bridge.line.path;
  Array<double>& t = bridge.line.t;
  path.points.assign(1, traced.samples[0].point);
  Array<int> ends(1, 0);  // the indices of the samples among the path's points
  for (int i = 1; i < traced.samples.count(); ++i) {
    appendGeodesic(surface().geometry(), traced.samples[i - 1].point, traced.samples[i].point,
                   workspace_->averaging.strip, path.points);
    ends.push_back(path.points.count() - 1);
  }
  measure(surface().mesh(), path);
  t.assign(1, traced.samples[0].t);
  for (int i = 1; i < ends.count(); ++i) {
    const double from = traced.samples[i - 1].t;
    const double duration = traced.samples[i].t - from;
    const double start = path.lengths[ends[i - 1]];
    const double length = path.lengths[ends[i]] - start;
    for (int k = ends[i - 1] + 1; k < ends[i]; ++k) {
      t.push_back(from + duration * (length > 0 ? (path.lengths[k] - start) / length : 1));
    }
    t.push_back(traced.samples[i].t);
  }
  const int last = traced.samples.count() - 1;
  for (int i = 1; i < last; ++i) traced.samples[i].status = SampleStatus::kSubdivided;
}

void Curve::layBridges(const Next& next, Piece& piece) {
  const CurveOptions& options = next.value.options;
  TracedPiece& traced = *piece.traced_;
  if (!isOfCenters(options, next.levels)) {
    // Polylines and averages of two points have no gaps to bridge.
    traced.bridges.clear();
    return;
  }
  if (piece.isSubdivided_) {
    layOwnSubdivision(piece);
    return;
  }
  bridgeSegment(*workspace_->blend, piece.basis_, piece.pointWeights_,
                options.tolerance == 0 ? piece.table_.get() : nullptr, options.field.method,
                traced.samples, workspace_->bridging, traced.bridges);
}

void Curve::join(const Next& next, Piece& piece) {
  const CurveOptions& options = next.value.options;
  // `findSamples` has already written a polyline's path.
  if (options.shape.kind == CurveKind::kPolyline) return;
  const BasisWriter basis = basisOf(piece);
  std::optional<EdgeCrossings> crossings;
  if (options.geometry == CurveGeometry::kExact && isOfCenters(options, next.levels)) {
    crossings.emplace(*workspace_->blend, basis, options.field.method, workspace_->crossings);
  }
  joinSamples(surface(), piece.traced_->samples, piece.traced_->bridges,
              crossings ? &*crossings : nullptr, workspace_->averaging.strip, piece.traced_->path);
}

void Curve::merge(Next& next) {
  const CurveOptions& options = next.value.options;
  for (Segment& segment : next.segments) {
    if (segment.pieces.count() == 1) {
      segment.whole = segment.pieces[0].traced_;
      continue;
    }
    Array<const TracedPiece*>& pieces = workspace_->pieces;
    pieces.clear();
    for (const Piece& piece : segment.pieces) pieces.push_back(piece.traced_.get());
    segment.whole = std::make_shared<TracedSegment>();
    const bool isEven = options.tolerance == 0 || !isOfCenters(options, next.levels);
    mergePieces(pieces, isEven ? options.samples : 0, *segment.whole);
  }
}

/// Releases the segments' fields.
void Curve::releaseFields(Array<Segment>& segments) {
  for (Segment& segment : segments) {
    for (Piece& piece : segment.pieces) piece.fields_.clear();
  }
}

}  // namespace karcher

#include "curves/curve.h"

#include <algorithm>
#include <optional>
#include <string>

#include "curves/spec/bases.h"
#include "curves/trace/polyline.h"
#include "curves/trace/sampling.h"
#include "mesh/error.h"

namespace karcher {
namespace {

bool isCentripetal(const CurveShape& shape) {
  return shape.kind == CurveKind::kCatmullRom && shape.centripetal;
}

void checkOptions(const CurveOptions& options) {
  checkFieldOptions(options.field);
  if (options.samples < 2 || options.samples > kMostSamples) {
    throw Error(ErrorCode::kBadArgument, "a segment takes 2 to " + std::to_string(kMostSamples) +
                                             " samples, not " + std::to_string(options.samples));
  }
  if (options.tolerance != 0) checkTolerance(options.tolerance);
}

/// The rows of a table times the points' weights, each divided by its sum.
WeightTable weighted(const WeightTable& table, const Array<double>& pointWeights) {
  WeightTable result = table;
  for (int row = 0; row < table.t.count(); ++row) {
    double* weights = result.weights.data() + static_cast<ptrdiff_t>(row) * table.points;
    double sum = 0;
    for (int k = 0; k < table.points; ++k) sum += weights[k] *= pointWeights[k];
    for (int k = 0; k < table.points; ++k) weights[k] /= sum;
  }
  return result;
}

}  // namespace

Curve::Curve(Surface& surface, CurveOptions options, const Array<SurfacePoint>& points)
    : surface_(surface), options_(std::move(options)) {
  checkOptions(options_);
  checkGivenShape(options_.shape, points.count());
  change(options_.shape, points);
}

void Curve::movePoint(int i, const SurfacePoint& point) {
  checkIndex(i, pointCount());
  Array<ControlPoint> points = points_;
  points[i].position = point;
  points[i].stamp = ++lastStamp_;
  apply(shape(), std::move(points));
}

void Curve::insertPoint(int i, const SurfacePoint& point) {
  checkIndex(i, pointCount() + 1);
  Array<ControlPoint> points = points_;
  points.insert(points.begin() + i, makePoint(point));
  apply(withPoint(shape(), i), std::move(points));
}

void Curve::removePoint(int i) {
  checkIndex(i, pointCount());
  Array<ControlPoint> points = points_;
  points.erase(points.begin() + i);
  apply(withoutPoint(shape(), pointCount(), i), std::move(points));
}

void Curve::movePointInOrder(int from, int to) {
  checkIndex(from, pointCount());
  checkIndex(to, pointCount());
  Array<ControlPoint> points = points_;
  moveEntry(points, from, to);
  apply(withPointMoved(shape(), from, to), std::move(points));
}

void Curve::reverse() {
  Array<ControlPoint> points = points_;
  reverseEntries(points, shape().closed);
  apply(reversed(shape()), std::move(points));
}

void Curve::setKind(CurveKind kind) { apply(withKind(shape(), kind), points_); }

void Curve::setClosed(bool closed) { apply(withClosed(shape(), closed), points_); }

void Curve::setWeight(int i, double weight) {
  checkIndex(i, pointCount());
  apply(withWeight(shape(), pointCount(), i, weight), points_);
}

void Curve::setBeta(int i, double beta) {
  checkIndex(i, pointCount());
  apply(withBeta(shape(), pointCount(), i, beta), points_);
}

void Curve::change(const CurveShape& shape, const Array<SurfacePoint>& positions) {
  Array<ControlPoint> points;
  Array<uint8_t> taken(points_.size(), 0);
  for (const SurfacePoint& position : positions) {
    const auto isThere = [&](int i) {
      const SurfacePoint& known = points_[i].position;
      return !taken[i] && known.face == position.face && known.bary == position.bary;
    };
    int i = 0;
    while (i < points_.count() && !isThere(i)) ++i;
    if (i < points_.count()) taken[i] = 1;
    points.push_back(i < points_.count() ? points_[i] : makePoint(position));
  }
  apply(shape, std::move(points));
}

void Curve::retrace() {
  for (Segment& segment : segments_) {
    segment.traced->isSampled = segment.traced->isBridged = segment.traced->isJoined = false;
    segment.traced->fields.reset();
  }
}

void Curve::updateFields() {
  // Shortest paths need none.
  if (shape().kind == CurveKind::kPolyline) return;
  for (const ControlPoint& point : points_) {
    if (point.field->stamp == point.stamp) continue;
    point.field->field.setPoint(point.position);
    point.field->stamp = point.stamp;
    ++fieldsComputed_;
  }
}

void Curve::findSamples() {
  if (stale_) {
    updateGaps();
    segments_ = makeSegments(shape(), points_);
    stale_ = false;
  }
  for (int j = 0; j < segmentCount(); ++j) {
    Traced& traced = *segments_[j].traced;
    if (traced.isSampled) continue;
    findSamplesOf(j);
    traced.isSampled = true;
    traced.isBridged = traced.isJoined = false;
  }
}

void Curve::bridge() {
  for (int j = 0; j < segmentCount(); ++j) {
    Traced& traced = *segments_[j].traced;
    if (traced.isBridged) continue;
    // Shortest paths are whole.
    if (shape().kind != CurveKind::kPolyline) {
      const Basis basis = [&](double t) { return weights(j, t); };
      const auto& table = segments_[j].table;
      traced.bridges = bridgeSegment(blendedFieldsOf(j), basis, nodesOf(segments_[j].layout.basis),
                                     options_.tolerance == 0 && table ? &table->middles : nullptr,
                                     options_.field.method, traced.samples);
    }
    traced.isBridged = true;
  }
}

void Curve::join() {
  for (int j = 0; j < segmentCount(); ++j) {
    Traced& traced = *segments_[j].traced;
    if (traced.isJoined) continue;
    // A polyline's paths were found with its samples.
    if (shape().kind != CurveKind::kPolyline) {
      const Basis basis = [&](double t) { return weights(j, t); };
      std::optional<EdgeCrossings> crossings;
      if (options_.geometry == CurveGeometry::kExact) {
        crossings.emplace(blendedFieldsOf(j), basis, options_.field.method);
      }
      traced.path =
          joinSamples(surface_, traced.samples, traced.bridges, crossings ? &*crossings : nullptr);
      traced.fields.reset();
    }
    traced.isJoined = true;
  }
}

Array<SurfacePoint> Curve::points() const {
  Array<SurfacePoint> result;
  for (const ControlPoint& point : points_) result.push_back(point.position);
  return result;
}

Array<double> Curve::weights(int segment, double t) const {
  const Segment& of = segments_[segment];
  if (of.pointWeights.empty()) return weightsAt(of.layout.basis, t);
  return rationalBasis(weightsAt(of.layout.basis, t), of.pointWeights);
}

Array<PointField*> Curve::fieldsOf(int segment) const {
  Array<PointField*> fields;
  for (const int i : pointsOf(segment)) fields.push_back(&points_[i].field->field);
  return fields;
}

void Curve::apply(CurveShape shape, Array<ControlPoint> points) {
  checkShape(shape, points.count());
  Array<SurfacePoint> positions;
  for (const ControlPoint& point : points) positions.push_back(point.position);
  checkOneComponent(surface_, positions);
  const bool stale = isCentripetal(shape);
  // The gaps wait for the fields; until then evenly spaced knots give the right number of segments.
  if (!stale || segments_.empty()) segments_ = makeSegments(shape, points);
  points_ = std::move(points);
  options_.shape = std::move(shape);
  stale_ = stale;
}

void Curve::checkIndex(int i, int count) const {
  if (i >= 0 && i < count) return;
  throw Error(ErrorCode::kBadIndex, "there is no control point " + std::to_string(i) +
                                        ": the curve has " + std::to_string(pointCount()) +
                                        ", numbered from 0");
}

Curve::ControlPoint Curve::makePoint(const SurfacePoint& position) {
  const auto field = std::make_shared<ControlPoint::Field>(surface_, options_.field);
  return {position, ++lastStamp_, field};
}

/// The segments of a shape. What is known of the present ones is kept: the samples where control
/// points, basis and weights are the same.
Array<Curve::Segment> Curve::makeSegments(const CurveShape& shape,
                                          const Array<ControlPoint>& points) const {
  // By the stamp of their first point.
  Array<std::pair<int64_t, int>> known;
  for (int j = 0; j < segments_.count(); ++j) known.emplace_back(segments_[j].stamps[0], j);
  std::sort(known.begin(), known.end());

  Array<double> gaps;
  if (gaps_.count() == points.count() - (shape.closed ? 0 : 1)) {
    for (const Gap& gap : gaps_) gaps.push_back(gap.length);
  }
  Array<SegmentLayout> layout = layOut(shape, points.count(), gaps);
  const bool rational = takesWeights(shape.kind) && !shape.weights.empty();
  const bool same = shape.kind == options_.shape.kind;
  Array<Segment> segments;
  for (int j = 0; j < layout.count(); ++j) {
    Segment segment;
    segment.layout = std::move(layout[j]);
    for (const int i : segment.layout.points) {
      segment.stamps.push_back(points[i].stamp);
      if (rational) segment.pointWeights.push_back(shape.weights[i]);
    }
    const Segment* reusable = nullptr;
    auto candidate =
        std::lower_bound(known.begin(), known.end(), std::pair<int64_t, int>(segment.stamps[0], 0));
    for (; same && candidate != known.end() && candidate->first == segment.stamps[0]; ++candidate) {
      const Segment& old = segments_[candidate->second];
      if (old.stamps == segment.stamps && old.layout.basis == segment.layout.basis) reusable = &old;
    }
    if (reusable && reusable->pointWeights == segment.pointWeights) {
      segment.basisTable = reusable->basisTable;
      segment.table = reusable->table;
      segment.traced = reusable->traced;
    } else {
      const Segment* sources[] = {reusable, j > 0 ? &segments[j - 1] : nullptr,
                                  j < segments_.count() ? &segments_[j] : nullptr};
      for (const Segment* source : sources) {
        if (!source || source->layout.basis != segment.layout.basis) continue;
        segment.basisTable = source->basisTable;
        if (source->pointWeights == segment.pointWeights) segment.table = source->table;
      }
      makeTables(segment);
      segment.traced = std::make_shared<Traced>();
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

void Curve::makeTables(Segment& segment) const {
  const SegmentBasis& basis = segment.layout.basis;
  // Adaptive sampling asks for weights as it goes; a caller's basis is checked all the same.
  if (options_.tolerance > 0 && basis.form != BasisForm::kOwn) return;
  if (!segment.basisTable) {
    const auto weights = [&](double t) { return weightsAt(basis, t); };
    segment.basisTable = std::make_shared<SegmentWeights>(SegmentWeights{
        tabulate(weights, options_.samples), tabulateMiddles(weights, options_.samples)});
  }
  if (segment.table) return;
  segment.table = segment.pointWeights.empty()
                      ? segment.basisTable
                      : std::make_shared<SegmentWeights>(SegmentWeights{
                            weighted(segment.basisTable->samples, segment.pointWeights),
                            weighted(segment.basisTable->middles, segment.pointWeights)});
}

/// Distances between consecutive points by their fields: the mean of both, so that the curve is the
/// same from either end.
void Curve::updateGaps() {
  const int count = pointCount() - (shape().closed ? 0 : 1);
  Array<Gap> known = std::move(gaps_);
  gaps_.clear();
  const auto distance = [&](const ControlPoint& from, const ControlPoint& to) {
    FieldBlend field(surface_.geometry(), {&from.field->field.field()});
    constexpr double kOne[] = {1};
    return std::sqrt(std::max(field.energy(to.position, kOne), 0.0));
  };
  for (int i = 0; i < count; ++i) {
    const ControlPoint& from = points_[i];
    const ControlPoint& to = points_[(i + 1) % pointCount()];
    const auto same = [&](const Gap& gap) { return gap.from == from.stamp && gap.to == to.stamp; };
    const auto old = std::find_if(known.begin(), known.end(), same);
    const double length =
        old != known.end() ? old->length : (distance(from, to) + distance(to, from)) / 2;
    gaps_.push_back({from.stamp, to.stamp, length});
  }
}

void Curve::findSamplesOf(int segment) {
  Traced& traced = *segments_[segment].traced;
  if (shape().kind == CurveKind::kPolyline) {
    const Array<int>& ends = pointsOf(segment);
    PolylineSegment geodesic = traceShortestPath(surface_, point(ends[0]), point(ends[1]),
                                                 options_.tolerance > 0 ? 2 : options_.samples);
    traced.samples = std::move(geodesic.samples);
    traced.path = std::move(geodesic.path);
    return;
  }
  SegmentFields& fields = blendedFieldsOf(segment);
  const Basis basis = [&](double t) { return weights(segment, t); };
  const Method method = options_.field.method;
  traced.samples = options_.tolerance > 0
                       ? traceAdaptively(fields, basis, nodesOf(segments_[segment].layout.basis),
                                         method, options_.tolerance)
                       : traceSegment(fields, segments_[segment].table->samples, method);
}

SegmentFields& Curve::blendedFieldsOf(int segment) {
  std::optional<SegmentFields>& fields = segments_[segment].traced->fields;
  if (!fields) fields.emplace(surface_, fieldsOf(segment));
  return *fields;
}

}  // namespace karcher

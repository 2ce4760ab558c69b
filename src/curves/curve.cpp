#include "curves/curve.h"

#include <string>
#include <utility>

#include "curves/bases.h"
#include "mesh/error.h"

namespace karcher {
namespace {

constexpr int kMostSamples = 100'000;
constexpr int kMostBezierPoints = 1000;

Array<double> basisOf(CurveKind kind, int pointCount, double t) {
  return kind == CurveKind::kBSpline ? uniformCubicBasis(t) : bernsteinBasis(pointCount - 1, t);
}

}  // namespace

Curve::Curve(Surface& surface, const CurveOptions& options, const Array<SurfacePoint>& points)
    : surface_(surface), options_(options) {
  checkFieldOptions(options.field);
  if (options.samples < 2 || options.samples > kMostSamples) {
    throw Error(ErrorCode::kBadArgument, "a segment takes 2 to " + std::to_string(kMostSamples) +
                                             " samples, not " + std::to_string(options.samples));
  }
  check(options.kind, points);
  for (const SurfacePoint& point : points) points_.push_back(makePoint(point));
  resetSegments();
}

void Curve::movePoint(int i, const SurfacePoint& point) {
  checkIndex(i, pointCount());
  Array<SurfacePoint> changed = positions();
  changed[i] = point;
  check(options_.kind, changed);
  points_[i]->position = point;
  points_[i]->moved = true;
  for (int j = 0; j < segmentCount(); ++j) {
    if (j <= i && i < j + pointsPerSegment()) segments_[j].traced = segments_[j].joined = false;
  }
}

void Curve::insertPoint(int i, const SurfacePoint& point) {
  checkIndex(i, pointCount() + 1);
  Array<SurfacePoint> changed = positions();
  changed.insert(changed.begin() + i, point);
  check(options_.kind, changed);
  points_.insert(points_.begin() + i, makePoint(point));
  resetSegments();
}

void Curve::removePoint(int i) {
  checkIndex(i, pointCount());
  Array<SurfacePoint> changed = positions();
  changed.erase(changed.begin() + i);
  check(options_.kind, changed);
  points_.erase(points_.begin() + i);
  resetSegments();
}

void Curve::setKind(CurveKind kind) {
  check(kind, positions());
  options_.kind = kind;
  resetSegments();
}

void Curve::retrace() {
  for (Segment& segment : segments_) segment.traced = segment.joined = false;
}

void Curve::updateFields() {
  for (const std::unique_ptr<ControlPoint>& point : points_) {
    if (!point->moved) continue;
    point->field->setPoint(point->position);
    point->moved = false;
  }
}

void Curve::trace() {
  const int perSegment = pointsPerSegment();
  for (int j = 0; j < segmentCount(); ++j) {
    Segment& segment = segments_[j];
    if (segment.traced) continue;
    Array<PointField*> fields;
    for (int i = j; i < j + perSegment; ++i) fields.push_back(points_[i]->field.get());
    segment.samples = traceSegment(surface_, fields, weights_, options_.field.method);
    segment.traced = true;
  }
}

void Curve::join() {
  for (Segment& segment : segments_) {
    if (segment.joined) continue;
    segment.path = joinSamples(surface_, segment.samples);
    segment.joined = true;
  }
}

void Curve::check(CurveKind kind, const Array<SurfacePoint>& points) const {
  const int fewest = kind == CurveKind::kBSpline ? 4 : 2;
  if (points.count() < fewest) {
    throw Error(ErrorCode::kTooFewPoints,
                std::string(kind == CurveKind::kBSpline ? "a cubic B-spline" : "a Bezier curve") +
                    " needs at least " + std::to_string(fewest) + " control points, not " +
                    std::to_string(points.count()));
  }
  if (kind == CurveKind::kBezier && points.count() > kMostBezierPoints) {
    throw Error(ErrorCode::kBadArgument,
                "a Bezier curve takes at most " + std::to_string(kMostBezierPoints) +
                    " control points, not " + std::to_string(points.count()));
  }
  checkOneComponent(surface_, points);
}

void Curve::checkIndex(int i, int count) const {
  if (i >= 0 && i < count) return;
  throw Error(ErrorCode::kBadIndex, "there is no control point " + std::to_string(i) +
                                        ": the curve has " + std::to_string(pointCount()) +
                                        ", numbered from 0");
}

Array<SurfacePoint> Curve::positions() const {
  Array<SurfacePoint> result;
  for (const std::unique_ptr<ControlPoint>& point : points_) result.push_back(point->position);
  return result;
}

std::unique_ptr<Curve::ControlPoint> Curve::makePoint(const SurfacePoint& position) const {
  auto point = std::make_unique<ControlPoint>();
  point->position = position;
  point->field = std::make_unique<PointField>(surface_, options_.field);
  return point;
}

int Curve::pointsPerSegment() const {
  return options_.kind == CurveKind::kBSpline ? 4 : pointCount();
}

void Curve::resetSegments() {
  segments_.clear();
  segments_.resize(static_cast<size_t>(pointCount() - pointsPerSegment() + 1));
  const Basis basis = [&](double t) { return basisOf(options_.kind, pointsPerSegment(), t); };
  weights_ = tabulate(basis, options_.samples);
}

}  // namespace karcher

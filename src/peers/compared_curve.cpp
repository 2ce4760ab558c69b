#include "peers/compared_curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "curves/polygon/subdivision.h"
#include "distance/window_distance.h"
#include "mesh/error.h"

namespace karcher {

PreparedMethod::PreparedMethod(Surface& surface, const ComparedOptions& options)
    : surface_(surface), options_(options) {
  switch (options.method) {
    case ComparedMethod::kFields:
      checkFieldOptions(options.field);
      prepareFields(surface, options.field);
      break;
    case ComparedMethod::kVectorHeat:
    case ComparedMethod::kAffineHeat:
      factorise();
      break;
    case ComparedMethod::kWeightedAverages:
      embed();
      break;
    case ComparedMethod::kDescent:
      break;
  }
}

void PreparedMethod::factorise() {
  HeatOptions options;
  options.delaunay = options_.delaunay;
  operators_ = std::make_unique<HeatOperators>(surface_.geometry(), options);
  operators_->vectorHeat();
  if (options_.method == ComparedMethod::kVectorHeat) {
    operators_->poisson();
  } else {
    operators_->scalarHeat();
  }
}

void PreparedMethod::embed() {
  const TriangleMesh& mesh = surface_.mesh();
  const std::unique_ptr<DistanceSolver> solver =
      makeDistanceSolver(surface_, {Method::kKarcher, options_.landmarkDistances});
  int landmarks = 0;
  const auto landmarkDistances = [&](int v) {
    if (options_.progress) options_.progress(landmarks++);
    return distancesFrom(*solver, vertexPoint(mesh, v), mesh.vertexCount());
  };
  averages_ = std::make_unique<WeightedAverages>(
      mesh, embedSurface(surface_.geometry(), landmarkDistances, options_.embedding));
}

LogMapFromVertex PreparedMethod::logMaps() const {
  const HeatOperators& operators = *operators_;
  if (options_.method == ComparedMethod::kVectorHeat) {
    return [&operators](int v) { return vectorHeatLogMap(operators, v); };
  }
  return [&operators, variant = options_.variant](int v) {
    return affineHeatLogMap(operators, v, variant);
  };
}

ComparedCurve::ComparedCurve(PreparedMethod& method, ComparedPlan plan)
    : method_(method), plan_(std::move(plan)) {
  check();
  segments_.resize(plan_.first.size());
  lostByOwnRule_.assign(plan_.first.size(), 0);
  moved_.assign(plan_.points.size(), 1);
  const ComparedOptions& options = method.options();
  if (options.method == ComparedMethod::kFields) {
    for (int i = 0; i < plan_.points.count(); ++i) {
      fields_.push_back(std::make_unique<PointField>(method.surface(), options.field));
    }
  } else if (options.method == ComparedMethod::kVectorHeat ||
             options.method == ComparedMethod::kAffineHeat) {
    LogMapMeanOptions meanOptions;
    meanOptions.clock = options.clock;
    mean_ = std::make_unique<LogMapMean>(method.surface().geometry(), method.logMaps(),
                                         plan_.points, meanOptions);
  }
}

void ComparedCurve::check() const {
  const WeightTable& table = plan_.table;
  for (const int first : plan_.first) {
    if (first >= 0 && table.points > 0 && first + table.points <= plan_.points.count()) continue;
    throw Error(ErrorCode::kBadIndex, "a segment of " + std::to_string(table.points) +
                                          " points cannot begin at point " + std::to_string(first) +
                                          " of " + std::to_string(plan_.points.count()));
  }
  for (int i = 0; i < table.t.count(); ++i) {
    double sum = 0;
    for (const double weight : table.row(i)) sum += weight;
    if (std::abs(sum - 1) <= kChainRounding) continue;
    throw Error(ErrorCode::kBadWeights, "the weights of sample " + std::to_string(i) + " sum to " +
                                            std::to_string(sum) + " instead of 1");
  }
  checkOneComponent(method_.surface(), plan_.points);
  if (method_.options().method != ComparedMethod::kDescent) return;
  if (plan_.points.count() != 2 || table.points != 2) {
    throw Error(ErrorCode::kBadArgument,
                "piecewise-linear descent joins two points; this curve has " +
                    std::to_string(plan_.points.count()));
  }
}

void ComparedCurve::movePoint(int i, const SurfacePoint& point) {
  if (i < 0 || i >= plan_.points.count()) {
    throw Error(ErrorCode::kBadIndex, "there is no control point " + std::to_string(i) +
                                          ": the curve has " +
                                          std::to_string(plan_.points.count()));
  }
  Array<SurfacePoint> points = plan_.points;
  points[i] = point;
  checkOneComponent(method_.surface(), points);
  plan_.points = std::move(points);
  moved_[i] = 1;
  for (int j = 0; j < segmentCount(); ++j) {
    if (plan_.first[j] <= i && i < plan_.first[j] + plan_.table.points) segments_[j].clear();
  }
  blend_.reset();
  hasFound_ = false;
  if (mean_) mean_->movePoint(i, point);
}

int ComparedCurve::samplesLeft() const {
  int left = segmentCount() * plan_.table.t.count();
  for (const Array<CurveSample>& segment : segments_) left -= segment.count();
  return left;
}

bool ComparedCurve::advance(int samples) {
  if (makeNextField()) return false;
  for (int j = 0; j < segmentCount(); ++j) {
    if (segments_[j].count() == plan_.table.t.count()) continue;
    traceOn(j, samples);
    break;
  }
  return samplesLeft() == 0;
}

/// Computes the field of a moved point, or the path of a descent, if one is missing.
bool ComparedCurve::makeNextField() {
  const auto next = std::find(moved_.begin(), moved_.end(), 1);
  if (next == moved_.end()) return false;
  const int i = static_cast<int>(next - moved_.begin());
  moved_[i] = 0;
  if (!fields_.empty()) {
    fields_[i]->setPoint(plan_.points[i]);
    return true;
  }
  if (method_.options().method != ComparedMethod::kDescent) return makeNextField();
  moved_.assign(moved_.size(), 0);
  const Geometry& geometry = method_.surface().geometry();
  WindowDistance solver(geometry);
  const Array<double> distances =
      distancesFrom(solver, plan_.points[0], method_.surface().mesh().vertexCount());
  path_ = descendDistance(geometry, distances, plan_.points[0], plan_.points[1]);
  return true;
}

void ComparedCurve::traceOn(int segment, int samples) {
  Array<CurveSample>& traced = segments_[segment];
  if (traced.empty()) {
    lostByOwnRule_[segment] = 0;
    blend_.reset();
  }
  if (!fields_.empty() && !blend_) {
    Array<ControlField*> fields;
    for (int i = 0; i < plan_.table.points; ++i) {
      fields.push_back(&fields_[plan_.first[segment] + i]->field());
    }
    blend_.emplace(method_.surface().geometry(), std::move(fields));
  }
  const int end = static_cast<int>(
      std::min<int64_t>(plan_.table.t.count(), static_cast<int64_t>(traced.count()) + samples));
  for (int i = traced.count(); i < end; ++i) {
    // The end of one segment is the start of the next. With Seeds::kHeaviest, the searches for both
    // begin at the same point, as in traceSegment.
    const bool isEnd = i == 0 || i == plan_.table.t.count() - 1;
    if (needsSeed(isEnd)) last_ = startOf(segment, i);
    const Weights weights = plan_.table.row(i);
    SearchEnd found = centerAgain(segment, weights, isEnd, center(segment, weights, last_));
    lostByOwnRule_[segment] += isLostByOwnRule(found);
    traced.push_back({plan_.table.t[i], found.point, sampleStatus(found.status)});
    if (found.status != Status::kConverged) continue;
    last_ = found.point;
    hasFound_ = true;
  }
}

/// The result of the search or, if it failed, the result of the method's restarts.
SearchEnd ComparedCurve::centerAgain(int segment, Weights weights, bool isEnd, SearchEnd found) {
  const ComparedOptions& options = method_.options();
  if (options.method != ComparedMethod::kFields || options.seeds == Seeds::kAuthors) return found;
  if (found.status == Status::kConverged) return found;
  Array<int> restarts;
  findRestarts(weights, options.field.method, isEnd && !start_, restarts);
  for (const int k : restarts) {
    found = center(segment, weights, plan_.points[plan_.first[segment] + k]);
    if (found.status == Status::kConverged) break;
  }
  return found;
}

bool ComparedCurve::isLostByOwnRule(const SearchEnd& found) const {
  return mean_ ? !mean_->metLibraryRule() : found.status != Status::kConverged;
}

int ComparedCurve::lostByOwnRule() const {
  return std::accumulate(lostByOwnRule_.begin(), lostByOwnRule_.end(), 0);
}

SearchEnd ComparedCurve::center(int segment, Weights weights, const SurfacePoint& start) {
  const int first = plan_.first[segment];
  const int count = plan_.table.points;
  const bool authors = method_.options().seeds == Seeds::kAuthors;
  for (int k = 0; authors && k < count; ++k) {
    // The authors' program takes the ends of a Bezier curve from its control points.
    if (weights[static_cast<size_t>(k)] == 1) return {plan_.points[first + k]};
  }
  switch (method_.options().method) {
    case ComparedMethod::kFields:
      return findCenter(*blend_, weights, start, method_.options().field.method);
    case ComparedMethod::kVectorHeat:
    case ComparedMethod::kAffineHeat: {
      Array<double> all(plan_.points.size(), 0);
      for (int k = 0; k < count; ++k) all[first + k] = weights[static_cast<size_t>(k)];
      return mean_->centerOfMass(all, start);
    }
    case ComparedMethod::kWeightedAverages: {
      const auto begin = plan_.points.begin() + first;
      return method_.averages().centerOfMass({begin, begin + count}, weights, start);
    }
    case ComparedMethod::kDescent:
      return descentCenterOfMass(method_.surface().geometry(), path_, weights);
  }
  return {};
}

SurfacePoint ComparedCurve::startOf(int segment, int sample) const {
  if (start_) return *start_;
  const int first = plan_.first[segment];
  const Weights weights = plan_.table.row(sample);
  if (method_.options().seeds == Seeds::kAuthors) {
    const auto begin = plan_.points.begin() + first;
    SubdivisionWorkspace workspace;
    return repeatedAverage(method_.surface().geometry(), {begin, begin + plan_.table.points},
                           {weights.begin(), weights.end()}, workspace);
  }
  return plan_.points[first + heaviest(weights)];
}

bool ComparedCurve::needsSeed(bool isEnd) const {
  return method_.options().seeds == Seeds::kAuthors ? !hasFound_ : isEnd;
}

}  // namespace karcher

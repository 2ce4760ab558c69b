#include "curves/curve_value.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "curves/kept_legs.h"
#include "mesh/error.h"

namespace karcher {
namespace {

void checkIndexBelow(const CurveValue& value, int i, int count) {
  if (i >= 0 && i < count) return;
  throw Error(ErrorCode::kBadIndex, "there is no control point " + std::to_string(i) +
                                        ": the curve has " + std::to_string(value.points.count()) +
                                        ", numbered from 0");
}

void checkIndex(const CurveValue& value, int i) { checkIndexBelow(value, i, value.points.count()); }

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

/// The indices of the two legs that meet at a point. At an end of an open curve, one of them does
/// not exist.
std::array<int, 2> legsAt(const CurveValue& value, int i) {
  return {i, i > 0 ? i - 1 : value.points.count() - 1};
}

}  // namespace

bool mayHaveLevels(const CurveOptions& options) {
  return options.levels != 0 && takesLevels(options.field.method) &&
         takesLevels(options.shape.kind);
}

bool usesLegs(const CurveOptions& options) {
  return options.shape.kind == CurveKind::kPolyline || mayHaveLevels(options);
}

void makeShortest(SurfacePath& leg) {
  leg.points.clear();
  leg.lengths.clear();
}

CurveValue withPointPlaced(CurveValue value, int i, const SurfacePoint& point) {
  checkIndex(value, i);
  if (isSame(value.points[i], point)) return value;
  value.points[i] = point;
  for (const int leg : legsAt(value, i)) {
    if (leg < value.legs.count()) makeShortest(value.legs[leg]);
  }
  const auto isShortest = [](const SurfacePath& leg) { return leg.points.empty(); };
  if (std::all_of(value.legs.begin(), value.legs.end(), isShortest)) value.legs.clear();
  return value;
}

CurveValue withPointDragged(CurveValue value, int i, const SurfacePoint& point,
                            const Array<SurfacePath>& legs) {
  checkIndex(value, i);
  if (isSame(value.points[i], point)) return value;
  value.points[i] = point;
  if (value.legs.empty()) value.legs.resize(legs.size());
  for (const int leg : legsAt(value, i)) {
    if (leg < legs.count() && value.legs[leg].points.empty()) value.legs[leg] = legs[leg];
  }
  return value;
}

CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point) {
  checkIndexBelow(value, i, value.points.count() + 1);
  const int points = value.points.count();
  value.options.shape = withPoint(std::move(value.options.shape), i);
  value.points.insert(value.points.begin() + i, point);
  keepLegs(value, points, {.from = -1, .to = i});
  return value;
}

CurveValue withPointRemoved(CurveValue value, int i) {
  checkIndex(value, i);
  const int points = value.points.count();
  value.options.shape = withoutPoint(std::move(value.options.shape), points, i);
  value.points.erase(value.points.begin() + i);
  keepLegs(value, points, {.from = i, .to = -1});
  return value;
}

CurveValue withPointMovedInOrder(CurveValue value, int from, int to) {
  checkIndex(value, from);
  checkIndex(value, to);
  value.options.shape = withPointMoved(std::move(value.options.shape), from, to);
  moveEntry(value.points, from, to);
  keepLegs(value, value.points.count(), {from, to});
  return value;
}

CurveValue reversed(CurveValue value) {
  reverseEntries(value.points, value.options.shape.closed);
  value.options.shape = reversed(std::move(value.options.shape));
  std::reverse(value.legs.begin(), value.legs.end());
  for (SurfacePath& leg : value.legs) {
    if (!leg.points.empty()) reverse(leg);
  }
  return value;
}

CurveValue withKind(CurveValue value, CurveKind kind) {
  value.options.shape = withKind(std::move(value.options.shape), kind);
  return value;
}

CurveValue withClosed(CurveValue value, bool closed) {
  value.options.shape = withClosed(std::move(value.options.shape), closed);
  keepLegs(value, value.points.count(), {});
  return value;
}

CurveValue withWeight(CurveValue value, int i, double weight) {
  checkIndex(value, i);
  value.options.shape = withWeight(std::move(value.options.shape), value.points.count(), i, weight);
  return value;
}

CurveValue withBeta(CurveValue value, int i, double beta) {
  checkIndex(value, i);
  value.options.shape = withBeta(std::move(value.options.shape), value.points.count(), i, beta);
  return value;
}

}  // namespace karcher

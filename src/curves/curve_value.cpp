#include "curves/curve_value.h"

#include <algorithm>
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

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

/// The numbers from 0.
Array<int> numbersOf(const Array<SurfacePoint>& points) {
  Array<int> numbers;
  for (int i = 0; i < points.count(); ++i) numbers.push_back(i);
  return numbers;
}

/// The value with a change of its points and its shape, after which the points are those of these
/// numbers, -1 of new ones.
template <class Change>
CurveValue changed(CurveValue value, const Array<int>& order, const Change& change) {
  const Array<SurfacePath> legs = std::move(value.legs);
  const int points = value.points.count();
  value.legs.clear();
  change(value);
  if (!legs.empty()) value.legs = keptLegs(legs, points, order, value.options.shape);
  return value;
}

}  // namespace

void checkIndex(const CurveValue& value, int i) { checkIndexBelow(value, i, value.points.count()); }

void placePoint(CurveValue& value, int i, const SurfacePoint& point) {
  checkIndex(value, i);
  if (isSame(value.points[i], point)) return;
  value.points[i] = point;
  const int legs = value.legs.count();
  const int ofPoint[] = {i, i > 0 ? i - 1 : value.points.count() - 1};
  for (const int leg : ofPoint) {
    if (leg >= legs) continue;
    value.legs[leg].points.clear();
    value.legs[leg].lengths.clear();
  }
}

CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point) {
  checkIndexBelow(value, i, value.points.count() + 1);
  Array<int> order = numbersOf(value.points);
  order.insert(order.begin() + i, -1);
  return changed(std::move(value), order, [&](CurveValue& to) {
    to.options.shape = withPoint(std::move(to.options.shape), i);
    to.points.insert(to.points.begin() + i, point);
  });
}

CurveValue withPointRemoved(CurveValue value, int i) {
  checkIndex(value, i);
  Array<int> order = numbersOf(value.points);
  order.erase(order.begin() + i);
  return changed(std::move(value), order, [&](CurveValue& to) {
    to.options.shape = withoutPoint(std::move(to.options.shape), to.points.count(), i);
    to.points.erase(to.points.begin() + i);
  });
}

CurveValue withPointMovedInOrder(CurveValue value, int from, int to) {
  checkIndex(value, from);
  checkIndex(value, to);
  Array<int> order = numbersOf(value.points);
  moveEntry(order, from, to);
  return changed(std::move(value), order, [&](CurveValue& moved) {
    moved.options.shape = withPointMoved(std::move(moved.options.shape), from, to);
    moveEntry(moved.points, from, to);
  });
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
  const Array<int> order = numbersOf(value.points);
  return changed(std::move(value), order, [&](CurveValue& to) {
    to.options.shape = withClosed(std::move(to.options.shape), closed);
  });
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

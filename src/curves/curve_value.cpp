#include "curves/curve_value.h"

#include <string>
#include <utility>

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

/// The legs of `before` that the value's points still have.
void keepLegs(CurveValue& value, const Array<SurfacePath>& before) {
  value.legs.clear();
  const int points = value.points.count();
  bool any = false;
  for (int i = 0; i < legCount(value.options.shape, points); ++i) {
    const SurfacePoint& from = value.points[i];
    const SurfacePoint& to = value.points[(i + 1) % points];
    SurfacePath leg;
    for (const SurfacePath& known : before) {
      if (known.points.empty()) continue;
      if (isSame(known.start(), from) && isSame(known.end(), to)) {
        leg = known;
      } else if (isSame(known.start(), to) && isSame(known.end(), from)) {
        leg = karcher::reversed(known);
      }
      if (!leg.points.empty()) break;
    }
    any = any || !leg.points.empty();
    value.legs.push_back(std::move(leg));
  }
  if (!any) value.legs.clear();
}

/// The value with a change of its points and its shape.
template <class Change>
CurveValue changed(CurveValue value, const Change& change) {
  const Array<SurfacePath> before = std::move(value.legs);
  value.legs.clear();
  change(value);
  if (!before.empty()) keepLegs(value, before);
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

CurveValue withPointAt(CurveValue value, int i, const SurfacePoint& point) {
  checkIndex(value, i);
  return changed(std::move(value), [&](CurveValue& to) { to.points[i] = point; });
}

CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point) {
  checkIndexBelow(value, i, value.points.count() + 1);
  return changed(std::move(value), [&](CurveValue& to) {
    to.options.shape = withPoint(std::move(to.options.shape), i);
    to.points.insert(to.points.begin() + i, point);
  });
}

CurveValue withPointRemoved(CurveValue value, int i) {
  checkIndex(value, i);
  return changed(std::move(value), [&](CurveValue& to) {
    to.options.shape = withoutPoint(std::move(to.options.shape), to.points.count(), i);
    to.points.erase(to.points.begin() + i);
  });
}

CurveValue withPointMovedInOrder(CurveValue value, int from, int to) {
  checkIndex(value, from);
  checkIndex(value, to);
  return changed(std::move(value), [&](CurveValue& moved) {
    moved.options.shape = withPointMoved(std::move(moved.options.shape), from, to);
    moveEntry(moved.points, from, to);
  });
}

CurveValue reversed(CurveValue value) {
  return changed(std::move(value), [](CurveValue& to) {
    reverseEntries(to.points, to.options.shape.closed);
    to.options.shape = reversed(std::move(to.options.shape));
  });
}

CurveValue withKind(CurveValue value, CurveKind kind) {
  value.options.shape = withKind(std::move(value.options.shape), kind);
  return value;
}

CurveValue withClosed(CurveValue value, bool closed) {
  return changed(std::move(value), [&](CurveValue& to) {
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

#include "curves/kept_legs.h"

#include <utility>

namespace karcher {
namespace {

/// The index before the change of the point that has index i after the change; -1 for a new point.
int numberBefore(const PointChange& change, int i) {
  if (i == change.to) return change.from;
  const int others = change.to >= 0 && i > change.to ? i - 1 : i;
  return change.from >= 0 && others >= change.from ? others + 1 : others;
}

}  // namespace

void keepLegs(CurveValue& value, int points, const PointChange& change) {
  const int count = value.points.count();
  if (count == 0) value.legs.clear();
  if (value.legs.empty()) return;
  Array<SurfacePath> kept(static_cast<size_t>(legCount(value.options.shape, count)));
  bool any = false;
  for (const bool turned : {false, true}) {
    for (int i = 0; i < kept.count(); ++i) {
      int from = numberBefore(change, i);
      int to = numberBefore(change, (i + 1) % count);
      if (turned) std::swap(from, to);
      if (from < 0 || to != (from + 1) % points || from >= value.legs.count()) continue;
      // A leg that was already taken is empty.
      if (value.legs[from].points.empty()) continue;
      kept[i].points.swap(value.legs[from].points);
      kept[i].lengths.swap(value.legs[from].lengths);
      if (turned) reverse(kept[i]);
      any = true;
    }
  }
  value.legs.swap(kept);
  if (!any) value.legs.clear();
}

CurveValue withPoints(CurveValue value, Array<SurfacePoint> points) {
  const int before = value.points.count();
  value.points = std::move(points);
  keepLegs(value, before, {});
  const int count = value.points.count();
  const auto isAt = [](const SurfacePoint& end, const SurfacePoint& point) {
    return end.face == point.face && end.bary == point.bary;
  };
  for (int i = 0; i < value.legs.count(); ++i) {
    SurfacePath& leg = value.legs[i];
    if (leg.points.empty()) continue;
    if (!isAt(leg.start(), value.points[i]) || !isAt(leg.end(), value.points[(i + 1) % count])) {
      leg = {};
    }
  }
  return value;
}

}  // namespace karcher

#include "curves/kept_legs.h"

#include <algorithm>
#include <utility>

namespace karcher {
namespace {

bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

}  // namespace

Array<SurfacePath> keptLegs(const Array<SurfacePath>& legs, int points, const Array<int>& order,
                            const CurveShape& shape) {
  const int count = order.count();
  Array<SurfacePath> kept(static_cast<size_t>(legCount(shape, count)));
  Array<uint8_t> isTaken(legs.size(), 0);
  bool any = false;
  for (const bool turned : {false, true}) {
    for (int i = 0; i < kept.count(); ++i) {
      int from = order[i];
      int to = order[(i + 1) % count];
      if (turned) std::swap(from, to);
      if (from < 0 || to != (from + 1) % points || from >= legs.count()) continue;
      if (isTaken[from] || !kept[i].points.empty() || legs[from].points.empty()) continue;
      isTaken[from] = 1;
      kept[i] = turned ? karcher::reversed(legs[from]) : legs[from];
      any = true;
    }
  }
  if (!any) kept.clear();
  return kept;
}

CurveValue withPoints(CurveValue value, Array<SurfacePoint> points) {
  const int before = value.points.count();
  const int after = points.count();
  Array<int> order(static_cast<size_t>(after), -1);
  const auto stays = [&](int from, int to) {
    if (!isSame(value.points[from], points[to])) return false;
    order[to] = from;
    return true;
  };
  const int fewer = std::min(before, after);
  if (before == after) {
    for (int i = 0; i < after; ++i) stays(i, i);
  } else {
    int first = 0;
    while (first < fewer && stays(first, first)) ++first;
    for (int k = 1; k <= fewer - first && stays(before - k, after - k);) ++k;
  }
  value.points = std::move(points);
  if (!value.legs.empty()) value.legs = keptLegs(value.legs, before, order, value.options.shape);
  return value;
}

}  // namespace karcher

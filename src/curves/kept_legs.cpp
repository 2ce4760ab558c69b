#include "curves/kept_legs.h"

#include <utility>

namespace karcher {
namespace {

/// The number before the change of point i after it, or -1.
int numberBefore(const PointChange& change, int i) {
  if (i == change.to) return change.from;
  const int others = change.to >= 0 && i > change.to ? i - 1 : i;
  return change.from >= 0 && others >= change.from ? others + 1 : others;
}

}  // namespace

void keepLegs(CurveValue& value, int points, const PointChange& change) {
  if (value.legs.empty()) return;
  const int count = value.points.count();
  Array<SurfacePath> kept(static_cast<size_t>(legCount(value.options.shape, count)));
  bool any = false;
  for (const bool turned : {false, true}) {
    for (int i = 0; i < kept.count(); ++i) {
      int from = numberBefore(change, i);
      int to = numberBefore(change, (i + 1) % count);
      if (turned) std::swap(from, to);
      if (from < 0 || to != (from + 1) % points || from >= value.legs.count()) continue;
      // One that was taken is empty.
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

}  // namespace karcher

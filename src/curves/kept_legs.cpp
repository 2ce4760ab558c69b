#include "curves/kept_legs.h"

#include <utility>

namespace karcher {
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

}  // namespace karcher

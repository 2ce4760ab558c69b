#include "mesh/near_points.h"

#include "mesh/sorted_numbers.h"

namespace karcher {

NearPoints::NearPoints(const Array<Vec3>& positions, const Array<int>& points, double radius)
    : positions_(positions), low_(Vec3::Zero()), width_(radius) {
  if (points.empty()) return;
  low_ = positions[points[0]];
  Vec3 high = low_;
  for (const int p : points) {
    low_ = low_.cwiseMin(positions[p]);
    high = high.cwiseMax(positions[p]);
  }
  // A key has 21 bits for each direction.
  constexpr double kMostCells = 1 << 20;
  width_ = std::max(radius, (high - low_).maxCoeff() / kMostCells);
  if (!(width_ > 0)) width_ = 1;
  Array<Entry> entries;
  for (const int p : points) entries.push_back({keyOf(cellOf(p)), p});
  const auto isBefore = [&](int i, int j) {
    const Entry& a = entries[i];
    const Entry& b = entries[j];
    return a.key != b.key ? a.key < b.key : a.point < b.point;
  };
  for (const int i : sortedNumbers(entries.count(), isBefore)) entries_.push_back(entries[i]);
}

}  // namespace karcher

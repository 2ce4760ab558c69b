#include "mesh/near_points.h"

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
  for (const int p : points) entries_.push_back({keyOf(cellOf(p)), p});
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.point < b.point;
  });
}

}  // namespace karcher

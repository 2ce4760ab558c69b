#pragma once

#include <algorithm>

#include "mesh/types.h"

namespace karcher {

/// A grid of cubes that finds the points near each point.
class NearPoints {
 public:
  /// `radius` is the largest distance at which the grid finds all points.
  NearPoints(const Array<Vec3>& positions, const Array<int>& points, double radius);

  /// Calls visit(q) for each point q > p within the radius of p, and for some farther points.
  template <class Visit>
  void forEachNear(int p, Visit&& visit) const {
    const Cell cell = cellOf(p);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const uint64_t row = keyOf({cell[0] + dx, cell[1] + dy, cell[2]});
        auto entry = std::lower_bound(entries_.begin(), entries_.end(), row - 1, before);
        for (; entry != entries_.end() && entry->key <= row + 1; ++entry) {
          if (entry->point > p) visit(entry->point);
        }
      }
    }
  }

 private:
  using Cell = Eigen::Matrix<int64_t, 3, 1>;
  struct Entry {
    uint64_t key;
    int point;
  };
  static bool before(const Entry& entry, uint64_t key) { return entry.key < key; }

  Cell cellOf(int p) const {
    return ((positions_[p] - low_) / width_).array().floor().matrix().cast<int64_t>();
  }
  /// Keys count cells from 1, so that the neighbours of the first cells have keys, too.
  static uint64_t keyOf(const Cell& cell) {
    return static_cast<uint64_t>(cell[0] + 1) << 42 | static_cast<uint64_t>(cell[1] + 1) << 21 |
           static_cast<uint64_t>(cell[2] + 1);
  }

  const Array<Vec3>& positions_;
  Vec3 low_;
  double width_;
  Array<Entry> entries_;
};

}  // namespace karcher

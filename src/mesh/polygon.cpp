#include "mesh/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The margin around the bounding box of an ear, relative to the box's longer side. A corner
/// outside the widened box is not in the ear, whatever the rounding.
constexpr double kBeside = 1e-3;

/// The corners projected along the mean normal (Newell), counterclockwise around the polygon.
Array<Vec2> projected(const Array<Vec3>& corners) {
  const int n = corners.count();
  Vec3 normal = Vec3::Zero();
  for (int i = 0; i < n; ++i) {
    normal += (corners[i] - corners[0]).cross(corners[(i + 1) % n] - corners[0]);
  }
  const Vec3 z = normal.normalized();
  const Vec3 x = z.unitOrthogonal();
  const Vec3 y = z.cross(x);
  Array<Vec2> result;
  for (const Vec3& p : corners) {
    result.emplace_back((p - corners[0]).dot(x), (p - corners[0]).dot(y));
  }
  return result;
}

/// A grid that holds points of the plane, about one point in each cell. A search for the points in
/// a box visits few points outside the box.
class PointGrid {
 public:
  explicit PointGrid(const Array<Vec2>& points)
      : side_(static_cast<int>(std::sqrt(points.count())) + 1) {
    Vec2 high = points[0];
    low_ = points[0];
    for (const Vec2& p : points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // If the points have no width or are not finite, all points are in one row.
    for (int k = 0; k < 2; ++k) {
      const double width = high[k] - low_[k];
      perWidth_[k] = width > 0 ? side_ / width : 0;
    }
    cells_.resize(static_cast<size_t>(side_) * static_cast<size_t>(side_));
    for (int i = 0; i < points.count(); ++i) {
      cells_[place(points[i].y(), 1) * side_ + place(points[i].x(), 0)].push_back(i);
    }
  }

  /// Whether `test` is true for the index of any point in the cells that meet the box.
  template <class Test>
  bool any(const Vec2& low, const Vec2& high, const Test& test) const {
    for (int row = place(low.y(), 1); row <= place(high.y(), 1); ++row) {
      for (int column = place(low.x(), 0); column <= place(high.x(), 0); ++column) {
        for (const int i : cells_[row * side_ + column]) {
          if (test(i)) return true;
        }
      }
    }
    return false;
  }

 private:
  int place(double x, int k) const {
    const double cell = (x - low_[k]) * perWidth_[k];
    return cell > 0 ? static_cast<int>(std::min(cell, side_ - 1.0)) : 0;
  }

  int side_;
  Vec2 low_;
  Vec2 perWidth_;
  Array<Array<int>> cells_;
};

class EarClipping {
 public:
  explicit EarClipping(const Array<Vec3>& corners)
      : corners_(corners), plane_(projected(corners)), grid_(plane_) {
    isLeft_.assign(corners.size(), 1);
    for (int i = 0; i < corners.count(); ++i) {
      ring_.push_back(i);
      next_.push_back((i + 1) % corners.count());
      previous_.push_back((i + corners.count() - 1) % corners.count());
    }
    for (int i = 0; i < corners.count(); ++i) diagonal_.push_back(earDiagonal(i));
  }

  Array<Triangle> clip() {
    Array<Triangle> triangles;
    while (ring_.count() >= 3) {
      int ear = shortest();
      if (diagonal_[ear] == kInfinity) {
        // Removed corners may have blocked other ears.
        for (int i = 0; i < ring_.count(); ++i) diagonal_[i] = earDiagonal(i);
        ear = shortest();
        if (diagonal_[ear] == kInfinity) return {};
      }
      triangles.emplace_back(at(ear - 1), at(ear), at(ear + 1));
      const int corner = ring_[ear];
      isLeft_[corner] = 0;
      next_[previous_[corner]] = next_[corner];
      previous_[next_[corner]] = previous_[corner];
      ring_.erase(ring_.begin() + ear);
      diagonal_.erase(diagonal_.begin() + ear);
      const int n = ring_.count();
      for (const int i : {(ear + n - 1) % n, ear % n}) diagonal_[i] = earDiagonal(i);
    }
    return triangles;
  }

 private:
  int shortest() const {
    return static_cast<int>(std::min_element(diagonal_.begin(), diagonal_.end()) -
                            diagonal_.begin());
  }

  int at(int i) const {
    const int n = ring_.count();
    return ring_[(i + n) % n];
  }

  /// The squared length of the diagonal that cuts off corner i of the ring; infinite if it cuts off
  /// no ear.
  double earDiagonal(int i) const {
    const Vec2& a = plane_[at(i - 1)];
    const Vec2& b = plane_[at(i)];
    const Vec2& c = plane_[at(i + 1)];
    // Corners whose cross product is at most this lie on a line.
    const double flat = kLocalRounding * ((b - a).squaredNorm() + (c - b).squaredNorm());
    // The negation also holds for NaN: without a normal, the coordinates are NaN.
    if (!(cross(b - a, c - b) > flat)) return kInfinity;
    const int own[3] = {at(i - 1), at(i), at(i + 1)};
    const auto blocks = [&](int k) {
      if (!isLeft_[k] || k == own[0] || k == own[1] || k == own[2]) return false;
      const Vec2& p = plane_[k];
      const bool inside = cross(b - a, p - a) >= -flat && cross(c - b, p - b) >= -flat &&
                          cross(a - c, p - c) >= -flat;
      if (!inside || p == a || p == c) return false;
      // The ring passes the end of a bridge to a hole twice. There the corner blocks the ear only
      // if the ring enters the ear.
      return p != b || isBetween(next_[k], a, b, c, flat) || isBetween(previous_[k], a, b, c, flat);
    };
    // With the slack of `flat`, corners slightly outside the triangle also block the ear.
    const Vec2 low = a.cwiseMin(b).cwiseMin(c);
    const Vec2 high = a.cwiseMax(b).cwiseMax(c);
    const Vec2 slack = kBeside * (high - low).maxCoeff() * Vec2::Ones();
    if (grid_.any(low - slack, high + slack, blocks)) return kInfinity;
    return (corners_[at(i + 1)] - corners_[at(i - 1)]).squaredNorm();
  }

  /// Whether a corner lies within the angle at b of the ear a, b, c.
  bool isBetween(int k, const Vec2& a, const Vec2& b, const Vec2& c, double flat) const {
    const Vec2 d = plane_[k] - b;
    return cross(c - b, d) > flat && cross(d, a - b) > flat;
  }

  const Array<Vec3>& corners_;
  Array<Vec2> plane_;
  PointGrid grid_;
  Array<uint8_t> isLeft_;   ///< whether each corner is still in the ring
  Array<int> next_;         ///< the corner after each corner in the ring
  Array<int> previous_;     ///< the corner before each corner in the ring
  Array<int> ring_;         ///< the remaining corners
  Array<double> diagonal_;  ///< the earDiagonal of each remaining corner
};

}  // namespace

Array<Triangle> cutPolygon(const Array<Vec3>& corners) {
  if (corners.count() < 3 || corners.count() > kMostPolygonCorners) return {};
  return EarClipping(corners).clip();
}

}  // namespace karcher

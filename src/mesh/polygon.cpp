#include "mesh/polygon.h"

namespace karcher {
namespace {

/// Corners whose sine is below this lie on a line, but for rounding.
constexpr double kFlat = 1e-12;

/// The corners seen along the mean normal (Newell): counterclockwise around the polygon.
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

class EarClipping {
 public:
  explicit EarClipping(const Array<Vec3>& corners) : corners_(corners), plane_(projected(corners)) {
    for (int i = 0; i < corners.count(); ++i) ring_.push_back(i);
    for (int i = 0; i < corners.count(); ++i) diagonal_.push_back(earDiagonal(i));
  }

  Array<Triangle> clip() {
    Array<Triangle> triangles;
    while (ring_.count() >= 3) {
      int ear = 0;
      for (int i = 1; i < ring_.count(); ++i) {
        if (diagonal_[i] < diagonal_[ear]) ear = i;
      }
      if (diagonal_[ear] == kInfinity) return {};
      triangles.emplace_back(at(ear - 1), at(ear), at(ear + 1));
      ring_.erase(ring_.begin() + ear);
      diagonal_.erase(diagonal_.begin() + ear);
      const int n = ring_.count();
      for (const int i : {(ear + n - 1) % n, ear % n}) diagonal_[i] = earDiagonal(i);
    }
    return triangles;
  }

 private:
  int at(int i) const {
    const int n = ring_.count();
    return ring_[(i + n) % n];
  }

  /// Squared length of the diagonal that cuts corner i of the ring off; infinite if that is no ear.
  double earDiagonal(int i) const {
    const Vec2& a = plane_[at(i - 1)];
    const Vec2& b = plane_[at(i)];
    const Vec2& c = plane_[at(i + 1)];
    const double flat = kFlat * ((b - a).squaredNorm() + (c - b).squaredNorm());
    // Also where there is no normal, and the plane's coordinates are not numbers.
    if (!(cross(b - a, c - b) > flat)) return kInfinity;
    const int n = ring_.count();
    for (int k = 2; k < n - 1; ++k) {
      const Vec2& p = plane_[at(i + k)];
      const bool inside = cross(b - a, p - a) >= -flat && cross(c - b, p - b) >= -flat &&
                          cross(a - c, p - c) >= -flat;
      if (inside && p != a && p != c) return kInfinity;
    }
    return (corners_[at(i + 1)] - corners_[at(i - 1)]).squaredNorm();
  }

  const Array<Vec3>& corners_;
  Array<Vec2> plane_;
  Array<int> ring_;         ///< the corners that are left
  Array<double> diagonal_;  ///< for each of them, its earDiagonal
};

}  // namespace

Array<Triangle> cutPolygon(const Array<Vec3>& corners) {
  if (corners.count() > kMostPolygonCorners) return {};
  return EarClipping(corners).clip();
}

}  // namespace karcher

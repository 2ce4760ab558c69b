#include "generators/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace karcher {
namespace {

class Marching {
 public:
  Marching(const std::function<double(const Vec3&)>& function, int cubes) : side_(cubes + 1) {
    for (int k = 0; k < side_ * side_ * side_; ++k) {
      const int row = k / side_;
      const int layer = row / side_;
      const Vec3 cell(k % side_, row % side_, layer);
      // The grid is asymmetric about the middle: the zero of a symmetric function would pass
      // through corners.
      const Vec3 corner = Vec3::Constant(-1) + 2 * (cell + Vec3(0.137, 0.231, 0.319)) / side_;
      corners_.push_back(corner);
      values_.push_back(function(corner));
    }
  }

  TriangleSoup march() {
    for (int z = 0; z + 1 < side_; ++z) {
      for (int y = 0; y + 1 < side_; ++y) {
        for (int x = 0; x + 1 < side_; ++x) marchCube((z * side_ + y) * side_ + x);
      }
    }
    return std::move(soup_);
  }

 private:
  /// Six tetrahedra about the cube's diagonal: one for each order of the three steps along it.
  void marchCube(int corner) {
    std::array<int, 3> steps{1, side_, side_ * side_};
    do {
      const auto [first, second, third] = steps;
      marchTetrahedron(
          {corner, corner + first, corner + first + second, corner + first + second + third});
    } while (std::next_permutation(steps.begin(), steps.end()));
  }

  void marchTetrahedron(std::array<int, 4> corners) {
    const auto isInside = [&](int corner) { return values_[corner] < 0; };
    std::stable_partition(corners.begin(), corners.end(), isInside);
    const auto inside = std::count_if(corners.begin(), corners.end(), isInside);
    const auto& [a, b, c, d] = corners;
    if (inside == 1) {
      add(crossing(a, b), crossing(a, c), crossing(a, d), a);
    } else if (inside == 3) {
      add(crossing(a, d), crossing(b, d), crossing(c, d), a);
    } else if (inside == 2) {
      add(crossing(a, c), crossing(a, d), crossing(b, d), a);
      add(crossing(a, c), crossing(b, d), crossing(b, c), a);
    }
  }

  /// Adds a triangle that is counterclockwise as seen from outside.
  void add(int i, int j, int k, int inside) {
    const Vec3& p = soup_.positions[i];
    const Vec3 normal = (soup_.positions[j] - p).cross(soup_.positions[k] - p);
    if (normal.dot(p - corners_[inside]) < 0) std::swap(j, k);
    soup_.triangles.push_back({i, j, k});
  }

  int crossing(int a, int b) {
    const auto [place, isNew] =
        crossings_.try_emplace({std::min(a, b), std::max(a, b)}, soup_.positions.count());
    if (isNew) {
      const double part = values_[a] / (values_[a] - values_[b]);
      soup_.positions.push_back(corners_[a] + part * (corners_[b] - corners_[a]));
    }
    return place->second;
  }

  int side_;
  Array<Vec3> corners_;
  Array<double> values_;
  std::map<std::pair<int, int>, int> crossings_;
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup marchTetrahedra(const std::function<double(const Vec3&)>& function, int cubes) {
  return Marching(function, cubes).march();
}

TriangleSoup marchedSphere(int triangles) {
  constexpr double kRadius = 0.8;
  constexpr double kTrianglesPerSquare = 17.9;  // for each side of the grid
  const int cubes = static_cast<int>(std::lround(std::sqrt(triangles / kTrianglesPerSquare))) - 1;
  TriangleSoup soup = marchTetrahedra([](const Vec3& x) { return x.norm() - kRadius; }, cubes);
  for (Vec3& p : soup.positions) p.normalize();
  return soup;
}

}  // namespace karcher

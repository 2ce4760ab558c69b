#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

/// The basic types that every part of the engine shares.
namespace karcher {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
/// Corner indices of a triangle, counterclockwise seen from outside.
using Triangle = Eigen::Vector3i;

/// A std::vector with int indices. Vertices, faces and half-edges have int numbers, and -1 stands
/// for none.
template <class T>
class Array : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  Array() = default;
  Array(const Array&) = default;
  Array(Array&&) noexcept = default;
  Array& operator=(Array&&) noexcept = default;
  Array& operator=(const Array&) = default;
  T& operator[](std::integral auto i) { return std::vector<T>::operator[](static_cast<size_t>(i)); }
  const T& operator[](std::integral auto i) const {
    return std::vector<T>::operator[](static_cast<size_t>(i));
  }
  int count() const { return static_cast<int>(this->size()); }
};

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The z-component of the cross product of two plane vectors: positive if b is to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vector v, turned by the angle of the unit vector `rotation` (a product of complex numbers).
inline Vec2 rotate(const Vec2& rotation, const Vec2& v) {
  return {rotation.x() * v.x() - rotation.y() * v.y(), rotation.x() * v.y() + rotation.y() * v.x()};
}

/// The vector v, turned back by the angle of the unit vector `rotation`.
inline Vec2 rotateBack(const Vec2& rotation, const Vec2& v) {
  return {rotation.x() * v.x() + rotation.y() * v.y(), rotation.x() * v.y() - rotation.y() * v.x()};
}

/// The unit vector at `angle` (radians) from the x axis.
inline Vec2 unitVector(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The angle of v from the x axis, in (-pi, pi].
inline double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

}  // namespace karcher

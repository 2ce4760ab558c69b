#pragma once

#include "mesh/types.h"

namespace karcher {

/// The angle by which one vector turns counterclockwise to another, in (-pi, pi].
inline double angleFromTo(const Vec2& a, const Vec2& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

/// The angle between two vectors, in [0, pi].
inline double angleBetween(const Vec2& a, const Vec2& b) {
  return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

/// An angle without its full turns: in [-turn / 2, turn / 2].
inline double withoutTurns(double angle, double turn = 2 * kPi) {
  return angle - turn * std::rint(angle / turn);
}

}  // namespace karcher

#pragma once

#include <cmath>

#include "mesh/rounding.h"
#include "mesh/types.h"

/// Exact coordinates in a face. The face is mapped to the triangle (0, 0), (1, 0), (0, 1), where a
/// point's coordinates are its second and third barycentric weights. The map keeps orientations,
/// and makes needles no thinner than other faces. Coordinates are multiples of 2^-40. So
/// differences are exact, and so is the sign of a cross product of differences.
namespace karcher {

inline constexpr double kGridStep = 0x1p-40;

/// The distance below which points are merged, relative to an edge's length or a face's height.
inline constexpr double kTogether = 0x1p-32;

inline double onGrid(double x) { return std::round(x / kGridStep) * kGridStep; }

/// The cross product of two differences of places, with the right sign. If rounding could matter,
/// it uses W. Kahan's difference of products (C.-P. Jeannerod, N. Louvet, J.-M. Muller, 2013).
inline double exactCross(const Vec2& u, const Vec2& v) {
  const double p = u.x() * v.y();
  const double q = u.y() * v.x();
  const double difference = p - q;
  if (std::abs(difference) > kStepRounding * (std::abs(p) + std::abs(q))) return difference;
  return std::fma(u.x(), v.y(), -q) + std::fma(-u.y(), v.x(), q);
}

/// A number that is positive if c lies left of the line from a to b.
inline double leftOf(const Vec2& a, const Vec2& b, const Vec2& c) {
  return exactCross(b - a, c - a);
}

/// The place at parameter t along side k of a face.
inline Vec2 placeOnSide(int k, double t) {
  if (k == 0) return {t, 0};
  if (k == 1) return {1 - t, t};
  return {0, 1 - t};
}

}  // namespace karcher

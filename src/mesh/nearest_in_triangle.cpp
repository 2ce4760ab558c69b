#include "mesh/nearest_in_triangle.h"

namespace karcher {

/// The algorithm distinguishes the regions around the triangle (Ericson, Real-Time Collision
/// Detection, 5.1.5).
Vec3 nearestInTriangle(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(q - a);
  const double d2 = ac.dot(q - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = ab.dot(q - b);
  const double d4 = ac.dot(q - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double s = d1 / (d1 - d3);
    return {1 - s, s, 0};
  }
  const double d5 = ab.dot(q - c);
  const double d6 = ac.dot(q - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double s = d2 / (d2 - d6);
    return {1 - s, 0, s};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - s, s};
  }
  const double total = va + vb + vc;
  return {va / total, vb / total, vc / total};
}

}  // namespace karcher

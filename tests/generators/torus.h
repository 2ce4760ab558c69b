#pragma once

#include "mesh/triangle_soup.h"

/// Irregular tessellations of the torus about the z axis with radii R = 1 (of the circle of
/// centers) and r = 0.4 (of the tube).
namespace karcher {

inline constexpr double kTorusMajor = 1;
inline constexpr double kTorusMinor = 0.4;

/// About `triangles` triangles from random points, moved apart: isotropic with stretch 1; with 8,
/// triangles 8 times as long along the circle of centers as across.
TriangleSoup irregularTorus(int triangles, double stretch, uint64_t seed);

Vec3 closestOnTorus(const Vec3& p);

}  // namespace karcher

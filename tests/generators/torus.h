#pragma once

#include "mesh/shapes.h"

/// Irregular tessellations of the torus about the z axis with radii kTorusMajor and kTorusMinor.
namespace karcher {

/// About `triangles` triangles from random points, moved apart: isotropic with stretch 1; with 8,
/// triangles 8 times as long along the circle of centers as across.
TriangleSoup irregularTorus(int triangles, double stretch, uint64_t seed);

Vec3 closestOnTorus(const Vec3& p);

}  // namespace karcher

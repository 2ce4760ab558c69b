#pragma once

#include "mesh/shapes.h"

/// Irregular tessellations of the torus about the z axis with radii kTorusMajor and kTorusMinor.
namespace karcher {

/// About `triangles` triangles of random points that moved apart: isotropic with stretch 1. With
/// stretch 8 they are 8 times as long along the circle of centers as across.
TriangleSoup irregularTorus(int triangles, double stretch, uint64_t seed);

Vec3 closestOnTorus(const Vec3& p);

}  // namespace karcher

#pragma once

#include "mesh/triangle_soup.h"

/// Irregular tessellations of the unit sphere, about `triangles` triangles each.
namespace karcher {

/// The convex hull of random points, uniform by area.
TriangleSoup randomSphere(int triangles, uint64_t seed);

/// The same sphere after its points moved apart: isotropic and irregular.
TriangleSoup relaxedSphere(int triangles, uint64_t seed);

/// A jittered grid of longitudes and latitudes, cut by random diagonals, with a vertex at each
/// pole.
TriangleSoup jitteredUvSphere(int triangles, uint64_t seed);

inline Vec3 closestOnSphere(const Vec3& p) { return p.normalized(); }

}  // namespace karcher

#pragma once

#include <functional>

#include "mesh/triangle_soup.h"

namespace karcher {

/// The zero set of a function inside the cube [-1, 1]^3 by marching tetrahedra (A. Doi and A.
/// Koide, "An efficient method of triangulating equi-valued surfaces by using tetrahedral cells",
/// 1991), on a grid of `cubes` cubes on each side, six tetrahedra each: triangles of very different
/// sizes and angles. The function is negative inside, and its zero set must stay away from the
/// cube's sides.
TriangleSoup marchTetrahedra(const std::function<double(const Vec3&)>& function, int cubes);

/// The unit sphere by marching tetrahedra, with about this many triangles and its vertices on the
/// sphere.
TriangleSoup marchedSphere(int triangles);

}  // namespace karcher

#pragma once

#include <functional>

#include "mesh/triangle_soup.h"

namespace karcher {

/// The zero of a function inside the cube [-1, 1]^3 by marching tetrahedra (A. Doi and A. Koide,
/// "An efficient method of triangulating equi-valued surfaces by using tetrahedral cells", 1991),
/// on a grid of so many cubes a side, six tetrahedra each: triangles of very different sizes and
/// angles. The function is negative inside, and its zero must not come to the cube's sides.
TriangleSoup marchTetrahedra(const std::function<double(const Vec3&)>& function, int cubes);

/// The unit sphere by them, about so many triangles, its vertices on the sphere.
TriangleSoup marchedSphere(int triangles);

}  // namespace karcher

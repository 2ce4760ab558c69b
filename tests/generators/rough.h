#pragma once

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// A mesh like a noisy scan: every face is cut into parts^2 triangles, then every vertex moves by a
/// random vector, uniform in the cube of half width `noise` mean edges of the cut mesh (a tenth is
/// rough).
TriangleSoup roughened(const TriangleMesh& mesh, int parts, uint64_t seed, double noise = 0.1);

}  // namespace karcher

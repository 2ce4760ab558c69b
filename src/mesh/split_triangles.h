#pragma once

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// Cuts every face into parts^2 triangles by lines parallel to its sides, in its own plane. The
/// mesh's vertices keep their numbers; those along the edges follow, then those inside the faces.
TriangleSoup splitTriangles(const TriangleMesh& mesh, int parts);

}  // namespace karcher

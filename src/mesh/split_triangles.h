#pragma once

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// Cuts every face into parts^2 triangles in its plane, by lines parallel to its sides. The mesh's
/// vertices keep their numbers; the new vertices on the edges follow, then the new vertices inside
/// the faces.
TriangleSoup splitTriangles(const TriangleMesh& mesh, int parts);

}  // namespace karcher

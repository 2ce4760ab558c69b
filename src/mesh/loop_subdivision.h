#pragma once

#include "mesh/triangle_mesh.h"
#include "mesh/triangle_soup.h"

namespace karcher {

/// One step of Loop subdivision (C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987),
/// with cubic B-splines along the boundary (H. Hoppe et al., "Piecewise Smooth Surface
/// Reconstruction", 1994). Vertices 0, ..., mesh.vertexCount() - 1 are the mesh's vertices at new
/// positions; a vertex for each edge follows. Face f becomes the faces 4 f + k at its corners k =
/// 0, 1, 2 and the face 4 f + 3 in its middle.
TriangleSoup loopSubdivision(const TriangleMesh& mesh);

}  // namespace karcher

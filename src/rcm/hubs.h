#pragma once

#include "mesh/triangle_mesh.h"

namespace karcher {

/// Whether a vertex is a hub: it has more than 64 edges, so that its neighbours are not near each
/// other.
bool isHub(const TriangleMesh& mesh, int vertex);

/// Whether each vertex is a hub or has an edge to one; empty if the mesh has no hub.
Array<char> besideHubs(const TriangleMesh& mesh);

}  // namespace karcher

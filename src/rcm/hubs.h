#pragma once

#include "mesh/triangle_mesh.h"

namespace karcher {

/// Whether a vertex is a hub. A hub has more than 64 edges, so that not all its neighbours are near
/// each other.
bool isHub(const TriangleMesh& mesh, int vertex);

/// Whether each vertex is a hub or has an edge to one; empty if the mesh has no hub.
Array<char> besideHubs(const TriangleMesh& mesh);

}  // namespace karcher

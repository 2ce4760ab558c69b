#pragma once

#include "mesh/triangle_mesh.h"

namespace karcher {

/// Whether a vertex has so many edges, more than 64, that it joins what is not near to each other.
bool isHub(const TriangleMesh& mesh, int vertex);

/// Of each vertex whether it is a hub or has an edge to one; empty where the mesh has no hub.
Array<char> besideHubs(const TriangleMesh& mesh);

}  // namespace karcher

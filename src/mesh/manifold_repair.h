#pragma once

#include "mesh/numbering.h"

namespace karcher {

struct ManifoldRepairs {
  int turnedOver = 0;  ///< the number of faces turned over
  int branching = 0;   ///< the number of edges with more than two faces
  /// the number of split vertices that are not ends of edges with more than two faces
  int bowTies = 0;
};

/// Repairs a mesh whose faces may not form a manifold. If neighbours run along an edge in the same
/// direction, the faces of the rarer orientation in each connected part turn over. If an edge has
/// more than two faces, the pairs of faces with the widest dihedral angles share an edge, and each
/// remaining face has an edge of its own. A vertex whose faces form several fans becomes one vertex
/// for each fan; the fan whose face comes first in the file keeps the vertex's number. Fills the
/// adjacency of `mesh` and changes its positions and faces and the numbers in `numbering`. Throws
/// Error kNotOrientable, whose sentence has the caller's numbers.
ManifoldRepairs connectRepaired(TriangleMesh& mesh, Numbering& numbering);

}  // namespace karcher

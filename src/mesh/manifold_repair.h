#pragma once

#include "mesh/numbering.h"

namespace karcher {

struct ManifoldRepairs {
  int turnedOver = 0;  ///< the number of faces turned over
  int branching = 0;   ///< the number of edges of more than two faces
  /// the number of split vertices, without those at the ends of edges of more than two faces
  int bowTies = 0;
};

/// Makes a manifold of faces that may not form one. If neighbours run along an edge in the same
/// direction, the faces of the rarer orientation in each connected part turn over. If an edge has
/// more than two faces, pairs of them with the widest dihedral angle share an edge, and the
/// remaining faces have edges of their own. A vertex whose faces form several fans becomes one
/// vertex for each fan; the fan with the file's first face keeps the vertex's number. Fills the
/// adjacency of `mesh` and changes its positions and faces and the numbers in `numbering`. Throws
/// Error kNotOrientable, whose sentence has the caller's numbers.
ManifoldRepairs connectRepaired(TriangleMesh& mesh, Numbering& numbering);

}  // namespace karcher

#pragma once

#include "mesh/numbering.h"

namespace karcher {

struct ManifoldRepairs {
  int turnedOver = 0;  ///< faces
  int branching = 0;   ///< edges of more than two faces
  int bowTies = 0;     ///< vertices that were split, without those at the ends of such edges
};

/// Makes a manifold of faces that may not form one. Faces that disagree with their neighbours on
/// the direction of an edge are turned over, the fewer ones of each connected part. Where an edge
/// has more than two faces, pairs of them with the widest dihedral angle are joined, and the others
/// get edges of their own. A vertex whose faces form several fans becomes one vertex for each; the
/// fan with the file's first face keeps the number. Fills the adjacency of `mesh` and changes its
/// positions and faces and the numbers in `numbering`. Throws Error kNotOrientable, with the
/// caller's numbers.
ManifoldRepairs connectRepaired(TriangleMesh& mesh, Numbering& numbering);

}  // namespace karcher

#pragma once

#include "mesh/numbering.h"

namespace karcher {

struct ManifoldRepairs {
  int turnedOver = 0;  ///< faces
  int branching = 0;   ///< edges of more than two faces
  int bowTies = 0;     ///< vertices that were split, but for those at the ends of such edges
};

/// The adjacency of faces that are no surface yet.
/// Faces that disagree with their neighbours on the direction of an edge are turned over, in each
/// connected part the fewer. Where an edge has more than two faces, pairs of them with the widest
/// dihedral angle are joined, and the others get an edge of their own. A vertex whose faces form
/// several fans becomes one for each; the one with the file's first face keeps its number.
/// Fills `mesh` but for its positions and faces, which it changes, and the numbers in `numbering`.
/// Throws Error kNotOrientable, with the caller's numbers.
ManifoldRepairs connectRepaired(TriangleMesh& mesh, Numbering& numbering);

}  // namespace karcher

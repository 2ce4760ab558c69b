#pragma once

#include "mesh/disjoint_sets.h"
#include "mesh/work_faces.h"

namespace karcher {

struct SeamOptions {
  /// Of the box around the vertices.
  double diagonal = 0;
  /// How far apart two vertices may lie that are welded; negative: the smaller of 1e-6 of the
  /// diagonal and 1 % of the shortest edge at either; 0: nothing is welded.
  double tolerance = -1;
  /// Only vertices at exactly the same place, and only if all edges have two faces at most then, in
  /// opposite directions; no face is left out.
  bool exact = false;
};

/// A face at the place of another.
struct DuplicateFace {
  int source;      ///< the input triangle
  int keptSource;  ///< the one that stays
  /// Per corner of the one the corner of the other at its place.
  std::array<int, 3> corner;
};

struct SeamRepairs {
  int welded = 0;     ///< vertices that became another one
  int keptApart = 0;  ///< vertices at the place of another that stayed
  Array<DuplicateFace> duplicates;
};

/// Welds vertices where two faces lie along each other with an edge: those at the same place (0 and
/// -0 are the same), and on boundaries those within the tolerance. Parts that only touch stay
/// apart, and the corners of one face. Where the two edges run in the same direction, one side is
/// turned over (`connectRepaired`) unless that would leave the surface with one side. Faces that
/// are at the place of an earlier one are left out: with the same orientation always, with the
/// opposite one if an edge has more than two faces, and the face hangs on no other. `order` lists
/// the vertices of the faces, equal positions one after another (`mortonOrder`). `target` is per
/// vertex the one that stands for it before, and after.
SeamRepairs closeSeams(const Array<Vec3>& positions, const Array<int>& order, WorkFaces& faces,
                       const SeamOptions& options, DisjointSets& target);

}  // namespace karcher

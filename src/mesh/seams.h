#pragma once

#include "mesh/disjoint_sets.h"
#include "mesh/work_faces.h"

namespace karcher {

struct SeamOptions {
  /// The diagonal of the box around the vertices.
  double diagonal = 0;
  /// The function welds vertices up to this distance from each other, but at most up to a third of
  /// the shortest edge at either vertex. 0 welds nothing. A negative value stands for the smaller
  /// of 1e-6 of the diagonal and 1 % of the shortest edge at either vertex.
  double tolerance = -1;
  /// Whether to weld only vertices at exactly the same place. In this case the function omits no
  /// face, and welds nothing unless every edge then has one face, or two in opposite directions.
  bool exact = false;
};

/// A face at the place of another.
struct DuplicateFace {
  int source;      ///< the input triangle of the face
  int keptSource;  ///< the input triangle of the face that stays
  /// For each corner of the face, the corner of the kept face at the same place.
  std::array<int, 3> corner;
};

struct SeamRepairs {
  /// the number of vertices that were welded to another vertex, without those of repeated faces
  int welded = 0;
  int keptApart = 0;  ///< the number of vertices not welded to another at their place
  Array<DuplicateFace> duplicates;
};

/// Welds vertices where two faces have an edge at the same place: vertices at the same position (0
/// and -0 are the same), and boundary vertices within the tolerance. Parts that only touch stay
/// apart, and so do the corners of one face. If the two faces run along the edge in the same
/// direction, `connectRepaired` turns one side over later. The function does not weld such an edge
/// if that would make the surface one-sided.
///
/// No third face may join an edge that two faces share. If welding would add a third face, the
/// vertices at one end of the edge stay apart. If both ends are to be welded, the end with the
/// smaller index stays apart.
///
/// The function omits a face at the place of an earlier one if both have the same orientation. If
/// the orientations are opposite, it omits the face only if an edge of the face has more than two
/// faces, and the face either shares no vertex with another face or has the same vertices as the
/// earlier face.
///
/// `order` lists the vertices of the faces; vertices at equal positions are consecutive
/// (`mortonOrder`). `target` maps each vertex to its representative; the function updates it.
SeamRepairs closeSeams(const Array<Vec3>& positions, const Array<int>& order, WorkFaces& faces,
                       const SeamOptions& options, DisjointSets& target);

}  // namespace karcher

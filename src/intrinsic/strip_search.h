#pragma once

#include "mesh/sparse_index.h"
#include "mesh/surface_point.h"

/// A strip of faces between two points, by an A* search over faces towards the target in space.
namespace karcher {

/// Faces of which consecutive ones share an edge: the first one and the half-edges that are
/// crossed, in order, each in the face that the strip leaves.
struct Strip {
  int face = -1;
  Array<int> crossings;
};

/// Scratch memory of the search. A workspace that is used again spares the allocations.
struct StripSearchWorkspace {
  struct Node {
    int face = -1;
    int enteredBy = -1;  ///< half-edge of the face before, -1 where the search starts
    bool expanded = false;
    double length = 0;  ///< of the polyline from the start through the points of entry
    Vec3 entry;
  };
  struct QueueEntry {
    double key = 0;
    int node = 0;
  };
  Array<Node> nodes;
  Array<QueueEntry> queue;
  SparseIndex nodeOf;  ///< per face that was met, the number of its node
};

struct StripSearchOptions {
  int maxFaces = 4096;  ///< the search gives up after this many
  /// The face to begin in, which holds the start; -1 for any that does.
  int firstFace = -1;
  /// Of the way that is left: above 1 the search is faster, and the strip's path longer.
  double weight = 1;
};

/// Writes a strip from a face that holds `from` to one that holds `to`. Returns false where the
/// search ends without reaching `to`.
bool searchStrip(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                 const StripSearchOptions& options, StripSearchWorkspace& workspace, Strip& strip);

}  // namespace karcher

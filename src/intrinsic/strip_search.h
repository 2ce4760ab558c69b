#pragma once

#include "mesh/sparse_index.h"
#include "mesh/surface_point.h"

/// A* search over faces for a strip between two points. The straight distance to the target in
/// space estimates the remaining length.
namespace karcher {

/// A sequence of faces in which consecutive faces share an edge. It consists of the first face and
/// the crossed half-edges in order. Each half-edge belongs to the face that the strip leaves there.
struct Strip {
  int face = -1;
  Array<int> crossings;
};

/// Reusable scratch memory of the search.
struct StripSearchWorkspace {
  struct Node {
    int face = -1;
    int enteredBy = -1;  ///< the half-edge of the previous face, or -1 at the start
    bool expanded = false;
    double length = 0;  ///< the length of the polyline from the start through the points of entry
    Vec3 entry;
  };
  struct QueueEntry {
    double key = 0;
    int node = 0;
  };
  Array<Node> nodes;
  Array<QueueEntry> queue;
  SparseIndex nodeOf;  ///< the number of each visited face's node
};

struct StripSearchOptions {
  int maxFaces = 4096;  ///< the number of faces after which the search gives up
  /// The face in which the search begins. It must contain the start; -1 allows any face that does.
  int firstFace = -1;
  /// The weight of the estimated remaining length. A weight above 1 makes the search faster and the
  /// path in the strip longer.
  double weight = 1;
};

/// Writes a strip from a face that holds `from` to one that holds `to`. Returns false if the search
/// ends before it reaches `to`.
bool searchStrip(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                 const StripSearchOptions& options, StripSearchWorkspace& workspace, Strip& strip);

}  // namespace karcher

#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/strip_search.h"

/// A* search for a strip of faces between two points. It measures paths in the unfolded strip. As
/// in strip_search.h, it visits faces in order of the length so far plus the straight distance to
/// the target. Each entered edge stores a kind of window: the position of the unfolded source, and
/// the two vertices between which the source sees the edge. The length so far is that of a path
/// that is straight after its last bend. Each edge keeps only its best window. The search finds
/// better strips than `searchStrip`, and takes three times the work.
namespace karcher {

/// Reusable scratch memory of the search.
struct TautSearchWorkspace {
  /// A half-edge through which the search enters a face. In its frame the tail is the origin, the
  /// head lies on the positive x axis, and the source lies below the axis.
  struct Node {
    int halfedge = -1;
    int before = -1;  ///< the node of the previous face, or -1 at the start
    bool expanded = false;
    double key = 0;
    double base = 0;  ///< the length of the path up to the source, its last bend
    Vec2 source;
    Vec2 left;  ///< the vertices at the sides of the view
    Vec2 right;
    Vec3 entry;  ///< the point of the edge to which lengths are measured
  };
  struct QueueEntry {
    double key = 0;
    int node = 0;  ///< the node, or -1 - n for the target seen through node n
  };
  Array<Node> nodes;
  Array<QueueEntry> queue;
  SparseIndex nodeOf;  ///< the number of each visited half-edge's node
};

/// Writes a strip from a face that contains `from` to one that contains `to`; they must have no
/// face in common. Returns false if the points lie on different components.
bool searchTautStrip(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     TautSearchWorkspace& workspace, Strip& strip);

}  // namespace karcher

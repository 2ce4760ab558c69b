#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/strip_search.h"

/// A strip of faces between two points, by an A* search that measures paths in the unfolded strip.
///
/// As in strip_search.h faces are entered from the nearest on, by the way so far and the straight
/// way that is left. Here every entered edge holds where the source lies beyond it, unfolded, and
/// the two vertices that the view from there passes between, as a window of the exact distances
/// does: so the way so far is the length of a path that is pulled tight but for what lies before
/// its last bend. Each edge keeps its best window only. The strip is better than that of
/// searchStrip, in three times the work.
namespace karcher {

/// Scratch memory of the search; reuse one to spare the allocations.
struct TautSearchWorkspace {
  /// A half-edge through which a face is entered. In its frame the tail is the origin, the head
  /// lies on the positive x axis, and the source below.
  struct Node {
    int halfedge = -1;
    int before = -1;  ///< the node of the face before, -1 where the search starts
    bool expanded = false;
    double key = 0;
    double base = 0;  ///< the length of the path up to the source, its last bend
    Vec2 source;
    Vec2 left;  ///< the vertices that the view passes between
    Vec2 right;
    Vec3 entry;  ///< where the way is measured
  };
  struct QueueEntry {
    double key = 0;
    int node = 0;  ///< or -1 - n: the target, through node n
  };
  Array<Node> nodes;
  Array<QueueEntry> queue;
  SparseIndex nodeOf;  ///< per half-edge that was met, the number of its node
};

/// Writes a strip from a face that holds `from` to one that holds `to`; they must have no face in
/// common. Returns false where the points lie on different components.
bool searchTautStrip(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                     TautSearchWorkspace& workspace, Strip& strip);

}  // namespace karcher

#pragma once

#include "distance/visibility.h"
#include "intrinsic/geometry.h"

/// The graph of the paper's approximate distances (a variation of S. Xin, G. Wang 2007). Arcs join
/// each vertex to those vertices of its k-ring that it sees in a straight line across the faces of
/// the ring. An arc is as long as this line. Vertices that do not see each other have no arc: a
/// shortest path between them turns at vertices and consists of several arcs. The program of the
/// paper's authors also joins vertices whose path turns at a saddle. Its curves lie .02 to .08 mean
/// edges from ours; its fields take half the time.
namespace karcher {

struct RingGraph {
  int rings = 0;
  Array<int64_t> start;  ///< the index of each vertex's first arc; at the end, the number of arcs
  Array<int> target;
  Array<double> length;
  /// The unscaled direction of each arc's reverse, at the arc's target.
  Array<float> backDirection;
};

/// Throws Error kBadArgument if `rings` is outside 1 to 10.
void checkRings(int rings);

/// A builder of the graph in slices, so that a caller can show progress and stop the work.
class RingGraphBuilder {
 public:
  /// The geometry must outlive the builder. Throws what `checkRings` throws.
  RingGraphBuilder(const Geometry& geometry, int rings);

  /// Adds the next `vertices` vertices. Returns true when all are done.
  bool advance(int vertices);
  /// The completed part of the work, from 0 to 1.
  double progress() const;
  /// Moves the graph out once all vertices are done.
  RingGraph take() { return std::move(graph_); }

 private:
  void makeRoom(size_t arcs);

  const Geometry& geometry_;
  Visibility visibility_;
  RingGraph graph_;
  int nextVertex_ = 0;
};

RingGraph buildRingGraph(const Geometry& geometry, int rings);

}  // namespace karcher

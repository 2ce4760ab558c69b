#pragma once

#include "distance/visibility.h"
#include "intrinsic/geometry.h"

/// The graph of the paper's approximate distances: each vertex joined to the vertices of its k-ring
/// by arcs as long as the straight line between them across the faces of the ring (a variation of
/// S. Xin, G. Wang 2007). Vertices of the ring that do not see each other have no arc of their own:
/// a shortest path between them turns at vertices, and is made of arcs. The program of the paper's
/// authors also joins those whose path turns round a saddle. Its curves lie .02 to .08 mean edges
/// from ours; its fields take half the time.
namespace karcher {

struct RingGraph {
  int rings = 0;
  Array<int64_t> start;  ///< per vertex the place of its first arc; one entry more at the end
  Array<int> target;
  Array<double> length;
  /// Per arc the unscaled direction at its target that leads back along it.
  Array<float> backDirection;
};

/// Throws Error kBadArgument for a number of rings outside 1 to 10.
void checkRings(int rings);

/// Builds the graph some vertices at a time: a caller can show the progress and stop the work.
class RingGraphBuilder {
 public:
  /// The geometry must outlive the builder. Throws as `checkRings` does.
  RingGraphBuilder(const Geometry& geometry, int rings);

  /// Does the next `vertices` vertices. Returns true when all are done.
  bool advance(int vertices);
  /// The part that is done, from 0 to 1.
  double progress() const;
  /// The graph, once, when all vertices are done.
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

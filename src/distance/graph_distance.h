#pragma once

#include <queue>
#include <utility>
#include <vector>

#include "distance/ring_graph.h"

namespace karcher {

/// Approximate distances by Dijkstra's algorithm on the k-ring graph. A source inside a face or on
/// an edge is joined to the vertices that it sees in the faces around it.
class GraphDistance {
 public:
  /// Both must outlive the solver.
  GraphDistance(const Geometry& geometry, const RingGraph& graph);

  /// Starts anew. Costs what was touched before.
  void setSource(const SurfacePoint& source);

  /// Goes on until every vertex within `radius` is final.
  void grow(double radius);

  /// Every vertex as near as this is final.
  double reached() const { return queue_.empty() ? kInfinity : queue_.top().first; }
  bool isFinal(int vertex) const { return distance(vertex) <= reached(); }

  /// Length of the shortest path of arcs; kInfinity where there is none (yet).
  double distance(int vertex) const { return distance_[vertex]; }
  /// Unscaled direction in which that path leaves the vertex towards the source; 0 at the source.
  double direction(int vertex) const { return direction_[vertex]; }

 private:
  using Entry = std::pair<double, int>;

  void reach(int vertex, double distance, double direction);

  const Geometry& geometry_;
  const RingGraph& graph_;
  Visibility visibility_;
  Array<double> distance_;
  Array<double> direction_;
  Array<int> touched_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

}  // namespace karcher

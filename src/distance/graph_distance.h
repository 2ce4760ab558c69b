#pragma once

#include <queue>
#include <utility>
#include <vector>

#include "distance/distance_solver.h"
#include "distance/ring_graph.h"

namespace karcher {

/// Approximate distances by Dijkstra's algorithm on the k-ring graph. A source inside a face or on
/// an edge has arcs to the vertices that it sees in the faces around it.
class GraphDistance final : public DistanceSolver {
 public:
  /// The geometry and the graph must outlive the solver.
  GraphDistance(const Geometry& geometry, const RingGraph& graph);

  void setSource(const SurfacePoint& source) override;
  void grow(double radius) override;
  double growTo(int vertex) override { return growInSteps(*this, geometry_, source_, vertex); }

  double reached() const override { return queue_.empty() ? kInfinity : queue_.top().first; }
  bool isFinal(int vertex) const override { return distance(vertex) <= reached(); }

  double distance(int vertex) const override { return distance_[vertex]; }
  /// The unscaled direction (geometry.h) in which the path leaves the vertex towards the source; 0
  /// at the source.
  double direction(int vertex) const { return direction_[vertex]; }
  Vec2 logVector(int vertex) const override {
    return logVectorAlong(geometry_, vertex, distance(vertex), direction(vertex));
  }

  int64_t bytesHeld() const override {
    return static_cast<int64_t>((distance_.size() + direction_.size()) * sizeof(double));
  }

 private:
  using Entry = std::pair<double, int>;

  void reach(int vertex, double distance, double direction);

  const Geometry& geometry_;
  const RingGraph& graph_;
  Visibility visibility_;
  SurfacePoint source_;
  Array<double> distance_;
  Array<double> direction_;
  Array<int> touched_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

}  // namespace karcher

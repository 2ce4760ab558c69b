#include "distance/graph_distance.h"

namespace karcher {

GraphDistance::GraphDistance(const Geometry& geometry, const RingGraph& graph)
    : geometry_(geometry), graph_(graph), visibility_(geometry) {
  distance_.assign(geometry.mesh->positions.size(), kInfinity);
  direction_.assign(geometry.mesh->positions.size(), 0);
}

void GraphDistance::setSource(const SurfacePoint& source) {
  source_ = source;
  for (const int v : touched_) {
    distance_[v] = kInfinity;
    direction_[v] = 0;
  }
  touched_.clear();
  queue_ = {};
  const PointLocation location = locate(*geometry_.mesh, source);
  if (location.simplex == Simplex::kVertex) {
    reach(location.vertex, 0, 0);
    return;
  }
  for (const Visibility::Sight& sight : visibility_.fromPoint(source)) {
    reach(sight.vertex, sight.length, sight.direction);
  }
}

void GraphDistance::grow(double radius) {
  while (!queue_.empty() && queue_.top().first <= radius) {
    const auto [d, v] = queue_.top();
    queue_.pop();
    if (d > distance_[v]) continue;
    for (int64_t arc = graph_.start[v]; arc < graph_.start[v + 1]; ++arc) {
      reach(graph_.target[arc], d + graph_.length[arc],
            static_cast<double>(graph_.backDirection[arc]));
    }
  }
}

void GraphDistance::reach(int vertex, double distance, double direction) {
  if (distance >= distance_[vertex]) return;
  if (distance_[vertex] == kInfinity) touched_.push_back(vertex);
  distance_[vertex] = distance;
  direction_[vertex] = direction;
  queue_.emplace(distance, vertex);
}

}  // namespace karcher

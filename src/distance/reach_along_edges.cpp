#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "distance/window_distance.h"

// The last part of a search by windows: paths along edges to vertices that no window reaches.
namespace karcher {

/// Continues along edges, from the reached vertices to all others (E. Dijkstra's algorithm).
void WindowDistance::reachAlongEdges() {
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> waiting;
  const auto leave = [&](int v) {
    const double distance = vertices_.touch(v).arrival.distance;
    const auto reach = [&](int w, double edge, int via, double crossing) {
      VertexRecord& record = vertices_.touch(w);
      if (!(distance + edge < record.arrival.distance)) return;
      reachedCount_ += record.arrival.distance == kInfinity;
      record.arrival = {distance + edge, distance, v};
      record.via = via;
      record.crossing = crossing;
      waiting.emplace(distance + edge, w);
    };
    for (const int h : outgoingHalfedges(mesh_, v)) {
      const int via = previous(h);
      reach(mesh_.head(h), geometry_.edgeLength[h], via, geometry_.edgeLength[via]);
      reach(mesh_.opposite(h), geometry_.edgeLength[via], h, 0);
    }
  };
  // Windows come first: paths along edges start only at vertices with an unreached neighbour.
  Array<int> reached;
  vertices_.forEach([&](int v) {
    if (vertices_.touch(v).arrival.distance == kInfinity) return;
    for (const int h : outgoingHalfedges(mesh_, v)) {
      if (distance(mesh_.head(h)) != kInfinity && distance(mesh_.opposite(h)) != kInfinity)
        continue;
      reached.push_back(v);
      return;
    }
  });
  for (const int v : reached) leave(v);
  while (!waiting.empty()) {
    const auto [distance, v] = waiting.top();
    waiting.pop();
    if (distance == vertices_.touch(v).arrival.distance) leave(v);
  }
}

}  // namespace karcher

#include "distance/edge_dijkstra.h"

#include <functional>
#include <queue>
#include <utility>

namespace karcher {

Array<double> edgeDijkstra(const Geometry& geometry, int source) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<double> distance(mesh.positions.size(), kInfinity);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto reach = [&](int v, double d) {
    if (d >= distance[v]) return;
    distance[v] = d;
    queue.emplace(d, v);
  };
  reach(source, 0);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const int h : outgoingHalfedges(mesh, v)) {
      reach(mesh.head(h), d + geometry.edgeLength[h]);
      const int back = previous(h);
      if (mesh.twin[back] < 0) reach(mesh.tail(back), d + geometry.edgeLength[back]);
    }
  }
  return distance;
}

}  // namespace karcher

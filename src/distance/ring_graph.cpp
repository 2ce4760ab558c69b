#include "distance/ring_graph.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {

void checkRings(int rings) {
  constexpr int kMostRings = 10;
  if (rings >= 1 && rings <= kMostRings) return;
  throw Error(ErrorCode::kBadArgument, "the graph takes 1 to " + std::to_string(kMostRings) +
                                           " rings, not " + std::to_string(rings));
}

RingGraphBuilder::RingGraphBuilder(const Geometry& geometry, int rings)
    : geometry_(geometry), visibility_(geometry) {
  checkRings(rings);
  graph_.rings = rings;
  graph_.start.push_back(0);
}

bool RingGraphBuilder::advance(int vertices) {
  const int count = geometry_.mesh->vertexCount();
  const int end = vertices < count - nextVertex_ ? nextVertex_ + vertices : count;
  for (; nextVertex_ < end; ++nextVertex_) {
    const Array<Visibility::Sight>& sights = visibility_.fromVertex(nextVertex_, graph_.rings);
    makeRoom(sights.size());
    for (const Visibility::Sight& sight : sights) {
      graph_.target.push_back(sight.vertex);
      graph_.length.push_back(sight.length);
      graph_.backDirection.push_back(static_cast<float>(sight.direction));
    }
    graph_.start.push_back(static_cast<int64_t>(graph_.target.size()));
  }
  return nextVertex_ == count;
}

/// Grows the arrays to the estimated size of the whole graph. Arrays that grow by doubling could
/// take twice the memory on a large mesh.
void RingGraphBuilder::makeRoom(size_t arcs) {
  const size_t needed = graph_.target.size() + arcs;
  if (needed <= graph_.target.capacity()) return;
  const double share = (nextVertex_ + 1.0) / geometry_.mesh->vertexCount();
  constexpr double kMargin = 1.05;
  const size_t room = static_cast<size_t>(kMargin * static_cast<double>(needed) / share);
  graph_.target.reserve(room);
  graph_.length.reserve(room);
  graph_.backDirection.reserve(room);
}

double RingGraphBuilder::progress() const {
  return static_cast<double>(nextVertex_) / geometry_.mesh->vertexCount();
}

RingGraph buildRingGraph(const Geometry& geometry, int rings) {
  RingGraphBuilder builder(geometry, rings);
  builder.advance(geometry.mesh->vertexCount());
  return builder.take();
}

}  // namespace karcher

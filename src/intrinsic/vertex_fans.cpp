#include "intrinsic/vertex_fans.h"

#include <algorithm>

namespace karcher {
namespace {

/// Numbers the edges of all fans: per half-edge the number of its edge at its tail.
Array<int> numberEdges(const TriangleMesh& mesh, VertexFans& fans) {
  Array<int> number(static_cast<size_t>(mesh.halfedgeCount()));
  fans.begin.reserve(mesh.positions.size() + 1);
  fans.begin.push_back(0);
  int count = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    for (const int h : outgoingHalfedges(mesh, v)) number[h] = count++;
    if (mesh.onBoundary[v]) ++count;
    fans.begin.push_back(count);
  }
  return number;
}

/// The number at the head of half-edge h of the edge along it.
int reverseNumber(const TriangleMesh& mesh, const VertexFans& fans, const Array<int>& number,
                  int h) {
  const int t = mesh.twin[h];
  return t >= 0 ? number[t] : fans.end(mesh.head(h)) - 1;
}

/// How much later than a corner's vertex the nearer end of the opposite edge is reached at most, if
/// the shortest path crosses that edge: half the edge less the median, for a path over its
/// midpoint.
double delayOfCorner(const Geometry& geometry, int h) {
  const double a = geometry.edgeLength[h];
  const double b = geometry.edgeLength[previous(h)];
  const double c = geometry.edgeLength[next(h)];
  return c / 2 - std::sqrt(std::max(0.0, 2 * a * a + 2 * b * b - c * c)) / 2;
}

/// A path that crosses an edge is known once the edge's nearer end is, which may be late itself.
/// That adds up over few obtuse corners, and to no more than half the longest edge: twice the
/// largest delay of a corner in the 1-ring was enough on planes of all kinds of triangles,
/// stretched up to 20:1; once was not.
Array<float> delaysOfVertices(const Geometry& geometry) {
  constexpr double kChain = 2;
  /// Rounding must not decide what is late: this part of the longest edge at a vertex is always
  /// granted.
  constexpr double kTie = 0.1;
  const TriangleMesh& mesh = *geometry.mesh;
  Array<double> ofCorners(mesh.positions.size(), 0);
  Array<double> length(mesh.positions.size(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int tail = mesh.tail(h);
    const int head = mesh.head(h);
    ofCorners[tail] = std::max(ofCorners[tail], delayOfCorner(geometry, h));
    length[tail] = std::max(length[tail], geometry.edgeLength[h]);
    length[head] = std::max(length[head], geometry.edgeLength[h]);
  }
  Array<double> ofRing = ofCorners;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int tail = mesh.tail(h);
    const int head = mesh.head(h);
    ofRing[tail] = std::max(ofRing[tail], ofCorners[head]);
    ofRing[head] = std::max(ofRing[head], ofCorners[tail]);
  }
  const double most = *std::max_element(length.begin(), length.end()) / 2;
  Array<float> delay;
  delay.reserve(mesh.positions.size());
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    delay.push_back(static_cast<float>(std::min(most, kChain * ofRing[v] + kTie * length[v])));
  }
  return delay;
}

}  // namespace

VertexFans buildVertexFans(const Geometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  VertexFans fans;
  const Array<int> number = numberEdges(mesh, fans);
  fans.edges.resize(static_cast<size_t>(fans.begin.back()));
  fans.angles.resize(fans.edges.size());
  fans.turn.reserve(mesh.positions.size());
  fans.flags.assign(mesh.positions.size(), 0);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    double narrowest = kInfinity;
    int last = -1;
    for (const int h : outgoingHalfedges(mesh, v)) {
      narrowest = std::min(narrowest, geometry.cornerAngle[h]);
      const double length = geometry.edgeLength[h];
      const Vec2 nextEdge = geometry.edgeLength[previous(h)] * unitVector(geometry.cornerAngle[h]);
      fans.edges[number[h]] = {length * unitVector(geometry.cumulatedAngle[h]),
                               length,
                               length * nextEdge.y(),
                               length * nextEdge.x(),
                               mesh.head(h),
                               reverseNumber(mesh, fans, number, h)};
      fans.angles[number[h]] = geometry.cumulatedAngle[h];
      last = previous(h);
    }
    const double total = geometry.totalAngle[v];
    fans.turn.push_back(unitVector(total));
    if (mesh.onBoundary[v]) {
      fans.edges[fans.end(v) - 1] = {geometry.edgeLength[last] * fans.turn[v],
                                     geometry.edgeLength[last],
                                     0,
                                     0,
                                     mesh.tail(last),
                                     number[last]};
      fans.angles[fans.end(v) - 1] = total;
      fans.flags[v] |= VertexFans::kBoundary;
    }
    if (total > 2 * kPi + narrowest) fans.flags[v] |= VertexFans::kWide;
  }
  fans.delay = delaysOfVertices(geometry);
  return fans;
}

int fanEdge(const VertexFans& fans, int vertex, int head) {
  int edge = fans.begin[vertex];
  while (fans.edges[edge].head != head) ++edge;
  return edge;
}

}  // namespace karcher

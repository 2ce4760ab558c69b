#include "intrinsic/vertex_fans.h"

namespace karcher {
namespace {

/// Numbers the edges of all fans: per half-edge the number of its edge at its tail.
Array<int> numberEdges(const TriangleMesh& mesh, VertexFans& fans) {
  Array<int> number(static_cast<size_t>(mesh.halfedgeCount()));
  fans.begin.reserve(mesh.positions.size() + 1);
  fans.begin.push_back(0);
  int count = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const int first = mesh.outgoing[v];
    int h = first;
    do {
      number[h] = count++;
      h = rotateLeft(mesh, h);
    } while (h >= 0 && h != first);
    if (h < 0) ++count;
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
    const int first = mesh.outgoing[v];
    double narrowest = kInfinity;
    int h = first;
    for (;;) {
      narrowest = std::min(narrowest, geometry.cornerAngle[h]);
      const double length = geometry.edgeLength[h];
      fans.edges[number[h]] = {
          length * unitVector(geometry.cumulatedAngle[h]), length,
          length * geometry.edgeLength[previous(h)] * std::sin(geometry.cornerAngle[h]),
          mesh.head(h), reverseNumber(mesh, fans, number, h)};
      fans.angles[number[h]] = geometry.cumulatedAngle[h];
      const int left = rotateLeft(mesh, h);
      if (left < 0 || left == first) break;
      h = left;
    }
    const double total = geometry.totalAngle[v];
    fans.turn.push_back(unitVector(total));
    if (mesh.onBoundary[v]) {
      const int last = previous(h);
      fans.edges[fans.end(v) - 1] = {geometry.edgeLength[last] * fans.turn[v],
                                     geometry.edgeLength[last], 0, mesh.tail(last), number[last]};
      fans.angles[fans.end(v) - 1] = total;
      fans.flags[v] |= VertexFans::kBoundary;
    }
    if (total > 2 * kPi + narrowest) fans.flags[v] |= VertexFans::kWide;
  }
  return fans;
}

int fanEdge(const VertexFans& fans, int vertex, int head) {
  int edge = fans.begin[vertex];
  while (fans.edges[edge].head != head) ++edge;
  return edge;
}

}  // namespace karcher

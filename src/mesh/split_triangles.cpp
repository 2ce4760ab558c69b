#include "mesh/split_triangles.h"

namespace karcher {
namespace {

/// The new vertices that divide the edges, parts - 1 on each edge. For each half-edge, `first` is
/// the new vertex nearest to the tail, and `step` (1 or -1) leads from one number to the next.
struct EdgeVertices {
  Array<int> first;
  Array<int> step;
};

EdgeVertices addEdgeVertices(const TriangleMesh& mesh, int parts, Array<Vec3>& positions) {
  EdgeVertices vertices;
  vertices.first.resize(static_cast<size_t>(mesh.halfedgeCount()));
  vertices.step.resize(static_cast<size_t>(mesh.halfedgeCount()));
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int t = mesh.twin[h];
    if (t >= 0 && t < h) {
      vertices.first[h] = vertices.first[t] + parts - 2;
      vertices.step[h] = -1;
      continue;
    }
    vertices.first[h] = positions.count();
    vertices.step[h] = 1;
    const Vec3& a = mesh.positions[mesh.tail(h)];
    const Vec3& b = mesh.positions[mesh.head(h)];
    for (int i = 1; i < parts; ++i) positions.push_back(a + (b - a) * i / parts);
  }
  return vertices;
}

}  // namespace

TriangleSoup splitTriangles(const TriangleMesh& mesh, int parts) {
  TriangleSoup soup;
  soup.positions = mesh.positions;
  const EdgeVertices edges = addEdgeVertices(mesh, parts, soup.positions);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Vec3& a = mesh.positions[mesh.corner(f, 0)];
    const Vec3 u = (mesh.positions[mesh.corner(f, 1)] - a) / parts;
    const Vec3 v = (mesh.positions[mesh.corner(f, 2)] - a) / parts;
    const int inside = soup.positions.count();
    for (int j = 1; j < parts - 1; ++j) {
      for (int i = 1; i < parts - j; ++i) soup.positions.push_back(a + i * u + j * v);
    }
    const auto alongEdge = [&](int k, int i) {
      return edges.first[3 * f + k] + (i - 1) * edges.step[3 * f + k];
    };
    // The vertex at i steps from corner 0 towards corner 1 and j steps towards corner 2.
    const auto vertex = [&](int i, int j) {
      if (i == 0 && j == 0) return mesh.corner(f, 0);
      if (i == parts) return mesh.corner(f, 1);
      if (j == parts) return mesh.corner(f, 2);
      if (j == 0) return alongEdge(0, i);
      if (i + j == parts) return alongEdge(1, j);
      if (i == 0) return alongEdge(2, parts - j);
      const int above = parts - 1 - j;  // the number of inner vertices in row j
      return inside + (parts - 1) * (parts - 2) / 2 - above * (above + 1) / 2 + i - 1;
    };
    for (int j = 0; j < parts; ++j) {
      for (int i = 0; i < parts - j; ++i) {
        soup.triangles.emplace_back(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 1 < parts) {
          soup.triangles.emplace_back(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
      }
    }
  }
  return soup;
}

}  // namespace karcher

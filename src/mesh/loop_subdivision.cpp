#include "mesh/loop_subdivision.h"

namespace karcher {
namespace {

/// The weight of each neighbour of an interior vertex of this valence. The rest is the weight of
/// the vertex itself.
double neighbourWeight(int valence) {
  const double c = 0.375 + 0.25 * std::cos(2 * kPi / valence);
  return (0.625 - c * c) / valence;
}

Vec3 movedVertex(const TriangleMesh& mesh, int v) {
  const Vec3& p = mesh.positions[v];
  const int first = mesh.outgoing[v];
  if (mesh.onBoundary[v]) {
    // Of the vertex's two boundary edges, one is `first`; the other is the far side of the vertex's
    // last face.
    int last = first;
    for (const int h : outgoingHalfedges(mesh, v)) last = h;
    return 0.75 * p +
           0.125 * (mesh.positions[mesh.head(first)] + mesh.positions[mesh.tail(previous(last))]);
  }
  Vec3 sum = Vec3::Zero();
  int valence = 0;
  for (const int h : outgoingHalfedges(mesh, v)) {
    sum += mesh.positions[mesh.head(h)];
    ++valence;
  }
  const double weight = neighbourWeight(valence);
  return (1 - valence * weight) * p + weight * sum;
}

Vec3 edgeVertex(const TriangleMesh& mesh, int h) {
  const Vec3 ends = mesh.positions[mesh.tail(h)] + mesh.positions[mesh.head(h)];
  if (mesh.twin[h] < 0) return ends / 2;
  return 0.375 * ends +
         0.125 * (mesh.positions[mesh.opposite(h)] + mesh.positions[mesh.opposite(mesh.twin[h])]);
}

}  // namespace

TriangleSoup loopSubdivision(const TriangleMesh& mesh) {
  TriangleSoup soup;
  soup.positions.reserve(mesh.positions.size() + 3 * mesh.faces.size() / 2 + 1);
  for (int v = 0; v < mesh.vertexCount(); ++v) soup.positions.push_back(movedVertex(mesh, v));

  Array<int> middle(static_cast<size_t>(mesh.halfedgeCount()));
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int t = mesh.twin[h];
    if (t >= 0 && t < h) {
      middle[h] = middle[t];
    } else {
      middle[h] = soup.positions.count();
      soup.positions.push_back(edgeVertex(mesh, h));
    }
  }
  soup.triangles.reserve(4 * mesh.faces.size());
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      soup.triangles.emplace_back(mesh.tail(h), middle[h], middle[previous(h)]);
    }
    soup.triangles.emplace_back(middle[3 * f], middle[3 * f + 1], middle[3 * f + 2]);
  }
  return soup;
}

}  // namespace karcher

#include "rcm/hubs.h"

namespace karcher {
namespace {

constexpr int kMostEdges = 64;

}  // namespace

bool isHub(const TriangleMesh& mesh, int vertex) {
  int edges = 0;
  for ([[maybe_unused]] const int h : outgoingHalfedges(mesh, vertex)) {
    if (++edges > kMostEdges) return true;
  }
  return false;
}

Array<char> besideHubs(const TriangleMesh& mesh) {
  Array<int> corners(static_cast<size_t>(mesh.vertexCount()), 0);
  for (const Triangle& face : mesh.faces) {
    for (int k = 0; k < 3; ++k) ++corners[face[k]];
  }
  Array<char> beside;
  for (const Triangle& face : mesh.faces) {
    for (int k = 0; k < 3; ++k) {
      if (corners[face[k]] <= kMostEdges) continue;
      beside.resize(static_cast<size_t>(mesh.vertexCount()), 0);
      for (int i = 0; i < 3; ++i) beside[face[i]] = 1;
    }
  }
  return beside;
}

}  // namespace karcher

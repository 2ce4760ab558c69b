#include "generators/renumbered.h"

#include <numeric>
#include <utility>

#include "generators/random.h"

namespace karcher {

SurfacePoint Renumbered::at(const SurfacePoint& point) const {
  const int face = newFace[point.face];
  Vec3 bary;
  for (int k = 0; k < 3; ++k) bary[k] = point.bary[(k + rotations[face]) % 3];
  return {face, bary};
}

SurfacePoint Renumbered::before(const SurfacePoint& point) const {
  Vec3 bary;
  for (int k = 0; k < 3; ++k) bary[(k + rotations[point.face]) % 3] = point.bary[k];
  return {oldFace[point.face], bary};
}

Renumbered renumbered(const TriangleMesh& mesh, uint64_t seed) {
  Random random(seed);
  const int vertices = mesh.vertexCount();
  const int faces = mesh.faceCount();
  Renumbered result;
  Array<int>& oldFace = result.oldFace;
  oldFace.resize(static_cast<size_t>(faces));
  Array<int> newVertex(static_cast<size_t>(vertices));
  std::iota(newVertex.begin(), newVertex.end(), 0);
  std::iota(oldFace.begin(), oldFace.end(), 0);
  random.shuffle(newVertex);
  random.shuffle(oldFace);
  Array<Vec3> positions(static_cast<size_t>(vertices));
  for (int v = 0; v < vertices; ++v) positions[newVertex[v]] = mesh.positions[v];
  result.newFace.resize(static_cast<size_t>(faces));
  Array<Triangle> triangles;
  for (int f = 0; f < faces; ++f) {
    result.rotations.push_back(random.index(3));
    result.newFace[oldFace[f]] = f;
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      triangle[k] = newVertex[mesh.corner(oldFace[f], (k + result.rotations[f]) % 3)];
    }
    triangles.push_back(triangle);
  }
  result.mesh = buildMesh(std::move(positions), std::move(triangles));
  return result;
}

}  // namespace karcher

#pragma once

#include <iterator>

#include "mesh/types.h"

/// A manifold, consistently oriented triangle mesh with half-edge adjacency.
///
/// Half-edge 3 f + k runs along face f from corner k to corner k + 1 (mod 3). It also stands for
/// the corner at its tail. The corner opposite to it is corner k + 2.
namespace karcher {

struct TriangleMesh {
  Array<Vec3> positions;
  Array<Triangle> faces;
  /// For each half-edge, the opposite one in the neighbouring face; -1 at the boundary.
  Array<int> twin;
  /// For each vertex, a half-edge that leaves it. At a boundary vertex it is the first in
  /// counterclockwise order; it has no twin. So `outgoingHalfedges` meets every face.
  Array<int> outgoing;
  /// 1 for each vertex on the boundary, else 0.
  Array<uint8_t> onBoundary;

  int vertexCount() const { return positions.count(); }
  int faceCount() const { return faces.count(); }
  int halfedgeCount() const { return 3 * faceCount(); }

  int tail(int h) const { return corner(h / 3, h % 3); }
  int head(int h) const { return corner(h / 3, h % 3 == 2 ? 0 : h % 3 + 1); }
  /// The vertex opposite to half-edge h in its face.
  int opposite(int h) const { return corner(h / 3, h % 3 == 0 ? 2 : h % 3 - 1); }
  int corner(int f, int k) const { return faces[f][k]; }
};

inline int faceOf(int h) { return h / 3; }
inline int cornerOf(int h) { return h % 3; }
/// The next half-edge of the same face, counterclockwise.
inline int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// The half-edge that leaves h's tail next after h, counterclockwise; -1 past the boundary.
inline int rotateLeft(const TriangleMesh& mesh, int h) { return mesh.twin[previous(h)]; }

/// The half-edges that leave a vertex of a mesh (or of another `Connectivity` with `rotateLeft`),
/// counterclockwise from the first: for (const int h : ...).
template <class Connectivity>
class HalfedgesAround {
 public:
  HalfedgesAround(const Connectivity& mesh, int first) : mesh_(mesh), first_(first) {}

  class Iterator {
   public:
    Iterator(const Connectivity& mesh, int first) : mesh_(mesh), first_(first), here_(first) {}
    int operator*() const { return here_; }
    Iterator& operator++() {
      here_ = rotateLeft(mesh_, here_);
      if (here_ == first_) here_ = -1;
      return *this;
    }
    bool operator!=(std::default_sentinel_t) const { return here_ >= 0; }

   private:
    const Connectivity& mesh_;
    int first_;
    int here_;
  };

  Iterator begin() const { return {mesh_, first_}; }
  std::default_sentinel_t end() const { return {}; }

 private:
  const Connectivity& mesh_;
  int first_;
};

/// All half-edges that leave a vertex, starting with `outgoing`.
inline HalfedgesAround<TriangleMesh> outgoingHalfedges(const TriangleMesh& mesh, int vertex) {
  return {mesh, mesh.outgoing[vertex]};
}

/// Whether the triangle's corners lie on a line: its height over its longest edge is at most 1e-12
/// of that edge, so that its angles are rounding noise.
bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c);

/// Builds the adjacency. Every vertex must belong to a face; the mesh may have any number of
/// components and boundaries. Throws Error: kBadFile (no faces), kBadIndex, kNotFinite,
/// kBadArgument (size), kDegenerateFace, kNonManifoldEdge, kNonManifoldVertex. Each error names the
/// place by the caller's indices.
TriangleMesh buildMesh(Array<Vec3> positions, Array<Triangle> faces);

/// The first half of `buildMesh`, for callers that renumber the mesh before the second half. Checks
/// positions and triangles one by one. Throws what `buildMesh` throws, except for manifold errors
/// and vertices without a face.
void checkTriangles(const Array<Vec3>& positions, const Array<Triangle>& triangles);

/// The part of `checkTriangles` that checks the number of faces, and that their vertices exist.
void checkCorners(int vertexCount, const Array<Triangle>& triangles);

/// The part of `checkTriangles` that checks one triangle: its corners must differ and its area must
/// be positive. Errors call the triangle by the number `name`.
void checkArea(const Array<Vec3>& positions, const Triangle& triangle, int name);

/// The numbers by which errors name vertices and faces, if they differ from the mesh's own.
struct MeshNames {
  const Array<int>* vertex = nullptr;  ///< the number of each vertex of the mesh
  const Array<int>* face = nullptr;    ///< the number of each face of the mesh

  int ofVertex(int v) const { return vertex ? (*vertex)[v] : v; }
  int ofFace(int f) const { return face ? (*face)[f] : f; }
};

/// The second half of `buildMesh`: the adjacency of checked triangles.
/// Throws Error: kNonManifoldEdge, kNonManifoldVertex, kBadIndex (a vertex without a face).
TriangleMesh connectMesh(Array<Vec3> positions, Array<Triangle> faces, const MeshNames& names);

/// Fills `outgoing` and `onBoundary` from `twin`. If a vertex has several fans of faces, its
/// `outgoing` half-edge belongs to one of the fans, if possible to a fan at the boundary. Every
/// vertex must belong to a face.
void connectVertices(TriangleMesh& mesh);

/// The length of the bounding box's diagonal.
double boundingBoxDiagonal(const TriangleMesh& mesh);

/// The mean length of the edges, each counted once.
double meanEdgeLength(const TriangleMesh& mesh);

struct Topology {
  int components = 0;
  int boundaryLoops = 0;
  int genus = 0;  ///< the sum over the components, with their boundary loops filled in
};

Topology topology(const TriangleMesh& mesh);

/// The connected component of each vertex, numbered from 0 in the order of the vertices.
Array<int> componentOfVertices(const TriangleMesh& mesh);

}  // namespace karcher

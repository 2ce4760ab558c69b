#include "mesh/triangle_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "mesh/edges.h"
#include "mesh/error.h"
#include "mesh/positions.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Throws Error for an edge that is not manifold.
[[noreturn]] void throwEdge(const TriangleMesh& mesh, std::span<const EdgeSide> sides,
                            const MeshNames& names) {
  const int h = sides[0].halfedge;
  const std::string name = "edge " + std::to_string(names.ofVertex(mesh.tail(h))) + "-" +
                           std::to_string(names.ofVertex(mesh.head(h)));
  if (sides.size() == 2) {
    throw Error(ErrorCode::kNonManifoldEdge,
                "faces " + std::to_string(names.ofFace(faceOf(h))) + " and " +
                    std::to_string(names.ofFace(faceOf(sides[1].halfedge))) + " run along " + name +
                    " in the same direction; their orientations must agree");
  }
  throw Error(ErrorCode::kNonManifoldEdge,
              name + " has " + std::to_string(sides.size()) + " faces; a surface allows two");
}

void pairHalfedges(TriangleMesh& mesh, const MeshNames& names) {
  mesh.twin.assign(static_cast<size_t>(mesh.halfedgeCount()), -1);
  forEachEdge(mesh.faces, mesh.vertexCount(), [&](int, std::span<const EdgeSide> sides) {
    if (!isManifoldEdge(mesh.faces, sides)) throwEdge(mesh, sides, names);
    if (sides.size() == 2) {
      mesh.twin[sides[0].halfedge] = sides[1].halfedge;
      mesh.twin[sides[1].halfedge] = sides[0].halfedge;
    }
  });
}

/// Throws Error for a vertex without a face, or with several fans of faces.
void checkFans(const TriangleMesh& mesh, const MeshNames& names) {
  Array<int> valence(mesh.positions.size(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) ++valence[mesh.tail(h)];
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.outgoing[v] < 0) {
      throw Error(ErrorCode::kBadIndex,
                  "vertex " + std::to_string(names.ofVertex(v)) + " belongs to no face");
    }
    int seen = 0;
    for ([[maybe_unused]] const int h : outgoingHalfedges(mesh, v)) ++seen;
    if (seen != valence[v]) {
      throw Error(ErrorCode::kNonManifoldVertex,
                  "vertex " + std::to_string(names.ofVertex(v)) +
                      " joins more than one fan of faces: " + std::to_string(seen) + " of its " +
                      std::to_string(valence[v]) + " faces are connected around it");
    }
  }
}

}  // namespace

bool isDegenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
  return !(u.cross(v).norm() > kLocalRounding * longest);
}

void checkCorners(int vertexCount, const Array<Triangle>& triangles) {
  if (triangles.empty()) throw Error(ErrorCode::kBadFile, "the mesh has no faces");
  constexpr size_t kMostFaces = static_cast<size_t>(std::numeric_limits<int>::max()) / 3;
  if (triangles.size() > kMostFaces) {
    throw Error(ErrorCode::kBadArgument, "the mesh has " + std::to_string(triangles.size()) +
                                             " faces; at most " + std::to_string(kMostFaces) +
                                             " can be numbered");
  }
  for (int f = 0; f < triangles.count(); ++f) {
    for (const int v : triangles[f]) {
      if (v >= 0 && v < vertexCount) continue;
      throw Error(ErrorCode::kBadIndex, "face " + std::to_string(f) + " uses vertex " +
                                            std::to_string(v) + ", but the mesh has " +
                                            std::to_string(vertexCount) + " vertices");
    }
  }
}

void checkArea(const Array<Vec3>& positions, const Triangle& face, int f) {
  for (int k = 0; k < 3; ++k) {
    if (face[k] == face[(k + 1) % 3]) {
      throw Error(ErrorCode::kDegenerateFace, "face " + std::to_string(f) + " uses vertex " +
                                                  std::to_string(face[k]) + " twice");
    }
  }
  if (isDegenerate(positions[face[0]], positions[face[1]], positions[face[2]])) {
    throw Error(ErrorCode::kDegenerateFace,
                "face " + std::to_string(f) + " is too thin: the height of its triangle " +
                    std::to_string(face[0]) + ", " + std::to_string(face[1]) + ", " +
                    std::to_string(face[2]) + " is at most 1e-12 of its longest edge");
  }
}

void checkTriangles(const Array<Vec3>& positions, const Array<Triangle>& triangles) {
  checkCorners(positions.count(), triangles);
  checkPositions(positions);
  for (int f = 0; f < triangles.count(); ++f) checkArea(positions, triangles[f], f);
}

TriangleMesh connectMesh(Array<Vec3> positions, Array<Triangle> faces, const MeshNames& names) {
  TriangleMesh mesh;
  mesh.positions = std::move(positions);
  mesh.faces = std::move(faces);
  pairHalfedges(mesh, names);
  connectVertices(mesh);
  checkFans(mesh, names);
  return mesh;
}

void connectVertices(TriangleMesh& mesh) {
  mesh.outgoing.assign(mesh.positions.size(), -1);
  mesh.onBoundary.assign(mesh.positions.size(), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int v = mesh.tail(h);
    const bool boundary = mesh.twin[h] < 0;
    if (mesh.outgoing[v] < 0 || boundary) mesh.outgoing[v] = h;
    if (boundary) {
      mesh.onBoundary[v] = 1;
      mesh.onBoundary[mesh.head(h)] = 1;
    }
  }
}

TriangleMesh buildMesh(Array<Vec3> positions, Array<Triangle> faces) {
  checkTriangles(positions, faces);
  return connectMesh(std::move(positions), std::move(faces), {});
}

double boundingBoxDiagonal(const TriangleMesh& mesh) {
  Vec3 low = mesh.positions.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

double meanEdgeLength(const TriangleMesh& mesh) {
  double sum = 0;
  int count = 0;
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int t = mesh.twin[h];
    if (t >= 0 && t < h) continue;
    sum += (mesh.positions[mesh.tail(h)] - mesh.positions[mesh.head(h)]).norm();
    ++count;
  }
  return sum / count;
}

Array<int> componentOfVertices(const TriangleMesh& mesh) {
  Array<int> component(mesh.positions.size(), -1);
  Array<int> stack;
  int count = 0;
  for (int seed = 0; seed < mesh.vertexCount(); ++seed) {
    if (component[seed] >= 0) continue;
    component[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int v = stack.back();
      stack.pop_back();
      for (const int h : outgoingHalfedges(mesh, v)) {
        for (const int w : {mesh.head(h), mesh.opposite(h)}) {
          if (component[w] >= 0) continue;
          component[w] = count;
          stack.push_back(w);
        }
      }
    }
    ++count;
  }
  return component;
}

Topology topology(const TriangleMesh& mesh) {
  Topology result;
  const Array<int> component = componentOfVertices(mesh);
  result.components = 1 + *std::max_element(component.begin(), component.end());

  int boundaryEdges = 0;
  Array<uint8_t> seen(static_cast<size_t>(mesh.halfedgeCount()), 0);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    if (mesh.twin[h] >= 0) continue;
    ++boundaryEdges;
    if (seen[h]) continue;
    ++result.boundaryLoops;
    // The `outgoing` half-edge of a boundary vertex has no twin, so that it continues the boundary.
    for (int g = h; !seen[g]; g = mesh.outgoing[mesh.head(g)]) {
      seen[g] = 1;
    }
  }
  const int edges = (mesh.halfedgeCount() + boundaryEdges) / 2;
  const int euler = mesh.vertexCount() - edges + mesh.faceCount() + result.boundaryLoops;
  result.genus = (2 * result.components - euler) / 2;
  return result;
}

}  // namespace karcher

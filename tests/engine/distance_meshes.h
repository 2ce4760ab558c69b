#pragma once

#include <utility>

#include "generators/random_points.h"
#include "intrinsic/geometry.h"
#include "mesh/shapes.h"
#include "mesh/triangle_soup.h"

/// Helpers that tests of distances and paths share.
namespace karcher {

/// A mesh with its geometry, which refers to it.
struct MeasuredMesh {
  explicit MeasuredMesh(TriangleMesh m) : mesh(std::move(m)), geometry(buildGeometry(mesh)) {}
  explicit MeasuredMesh(const TriangleSoup& soup)
      : MeasuredMesh(buildMesh(soup.positions, soup.triangles)) {}
  MeasuredMesh(const MeasuredMesh&) = delete;
  MeasuredMesh& operator=(const MeasuredMesh&) = delete;

  const TriangleMesh mesh;
  const Geometry geometry;
};

/// The square from (0, 0) to (2n, 2n) without its upper right quarter. The boundary has a reentrant
/// corner at (n, n).
inline TriangleMesh lShape(int n) {
  const TriangleSoup square = [&] {
    TriangleSoup soup;
    for (int y = 0; y <= 2 * n; ++y) {
      for (int x = 0; x <= 2 * n; ++x) soup.positions.push_back(Vec3(x, y, 0));
    }
    const int row = 2 * n + 1;
    for (int y = 0; y < 2 * n; ++y) {
      for (int x = 0; x < 2 * n; ++x) {
        if (x >= n && y >= n) continue;
        const int a = y * row + x;
        soup.triangles.push_back({a, a + 1, a + row + 1});
        soup.triangles.push_back({a, a + row + 1, a + row});
      }
    }
    return soup;
  }();
  TriangleSoup used;
  Array<int> number(square.positions.size(), -1);
  for (Triangle t : square.triangles) {
    for (int& v : t) {
      if (number[v] < 0) {
        number[v] = used.positions.count();
        used.positions.push_back(square.positions[v]);
      }
      v = number[v];
    }
    used.triangles.push_back(t);
  }
  return buildMesh(used.positions, used.triangles);
}

/// Two meshes side by side as one.
inline TriangleMesh together(const TriangleMesh& a, const TriangleMesh& b, const Vec3& shift) {
  Array<Vec3> positions = a.positions;
  for (const Vec3& p : b.positions) positions.push_back(p + shift);
  Array<Triangle> faces = a.faces;
  for (const Triangle& f : b.faces) faces.push_back((f.array() + a.vertexCount()).matrix());
  return buildMesh(positions, faces);
}

}  // namespace karcher

#pragma once

#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>

#include "intrinsic/geometry.h"

/// Small meshes for the tests of distances and paths.
namespace karcher::testing {

/// A mesh with its geometry, which points into it.
struct Surface {
  explicit Surface(TriangleMesh m) : mesh(std::move(m)), geometry(buildGeometry(mesh)) {}
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const TriangleMesh mesh;
  const Geometry geometry;
};

/// columns x rows squares in the plane, spacing 1, cut along the diagonal from the lower left.
/// Inner vertices are moved by up to `jitter` in x and y.
inline TriangleMesh planeGrid(int columns, int rows, double jitter = 0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  Array<Vec3> positions;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const bool inside = x > 0 && y > 0 && x < columns && y < rows;
      const double dx = inside ? shift(random) : 0;
      const double dy = inside ? shift(random) : 0;
      positions.push_back({x + dx, y + dy, 0});
    }
  }
  Array<Triangle> faces;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int a = y * (columns + 1) + x;
      const int b = a + columns + 1;
      faces.push_back({a, a + 1, b + 1});
      faces.push_back({a, b + 1, b});
    }
  }
  return buildMesh(positions, faces);
}

/// The unit icosphere: an icosahedron, its faces cut in four `levels` times.
inline TriangleMesh icosphere(int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Array<Vec3> positions = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                           {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                           {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : positions) p.normalize();
  Array<Triangle> faces = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, isNew] = middles.insert({std::minmax(a, b), positions.count()});
      if (isNew) positions.push_back((positions[a] + positions[b]).normalized());
      return it->second;
    };
    Array<Triangle> finer;
    for (const Triangle& f : faces) {
      const int ab = middle(f[0], f[1]);
      const int bc = middle(f[1], f[2]);
      const int ca = middle(f[2], f[0]);
      finer.push_back({f[0], ab, ca});
      finer.push_back({ab, f[1], bc});
      finer.push_back({ca, bc, f[2]});
      finer.push_back({ab, bc, ca});
    }
    faces = finer;
  }
  return buildMesh(positions, faces);
}

/// The npm package's bunny (1,839 vertices, closed).
inline TriangleMesh bunny() {
  std::ifstream in(KARCHER_BUNNY_OBJ);
  Array<Vec3> positions;
  Array<Triangle> faces;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p[0] >> p[1] >> p[2];
      positions.push_back(p);
    } else if (kind == "f") {
      Triangle f;
      words >> f[0] >> f[1] >> f[2];
      faces.push_back((f.array() - 1).matrix());
    }
  }
  return buildMesh(positions, faces);
}

/// A random point: in a face, or one time in four each on an edge or at a vertex.
inline SurfacePoint randomPoint(const TriangleMesh& mesh, std::mt19937& random) {
  std::uniform_int_distribution<int> face(0, mesh.faceCount() - 1);
  std::uniform_int_distribution<int> kind(0, 3);
  std::uniform_int_distribution<int> corner(0, 2);
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  const int f = face(random);
  switch (kind(random)) {
    case 0:
      return edgePoint(3 * f + corner(random), unit(random));
    case 1:
      return edgePoint(3 * f + corner(random), 0);
    default: {
      const double s = std::sqrt(unit(random));
      const double t = unit(random);
      return {f, Vec3(1 - s, s * (1 - t), s * t)};
    }
  }
}

}  // namespace karcher::testing

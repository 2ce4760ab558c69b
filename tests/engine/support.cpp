#include "support.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>

namespace karcher {

TriangleMesh planeGrid(int columns, int rows) {
  Array<Vec3> positions;
  Array<Triangle> faces;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) positions.emplace_back(i, j, 0);
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int v = i + (columns + 1) * j;
      const int above = v + columns + 1;
      faces.emplace_back(v, v + 1, above + 1);
      faces.emplace_back(v, above + 1, above);
    }
  }
  return buildMesh(positions, faces);
}

TriangleMesh meshOf(const TriangleSoup& soup) { return buildMesh(soup.positions, soup.triangles); }

Vec2 inVertexFrame(const Geometry& geometry, int vertex, const Vec3& vector) {
  const int h = geometry.mesh->outgoing[vertex];
  return rotateBack(geometry.vertexToFace[h], toFace(geometry, faceOf(h), vector));
}

TriangleMesh bunnyMesh() {
  std::ifstream file(KARCHER_BUNNY_OBJ);
  if (!file) throw std::runtime_error(KARCHER_BUNNY_OBJ " is missing: run npm test");
  Array<Vec3> positions;
  Array<Triangle> faces;
  std::string kind;
  while (file >> kind) {
    if (kind == "v") {
      Vec3& p = positions.emplace_back();
      file >> p[0] >> p[1] >> p[2];
    } else {
      Triangle& f = faces.emplace_back();
      file >> f[0] >> f[1] >> f[2];
      f.array() -= 1;
    }
  }
  return buildMesh(positions, faces);
}

bool longRun() {
  const char* value = std::getenv("KARCHER_LONG");
  return value != nullptr && std::string(value) == "1";
}

ErrorCode codeOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error was thrown";
  return ErrorCode::kBadFile;
}

}  // namespace karcher

#include "support.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "mesh/mesh_import.h"

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

TriangleMesh twoGrids() {
  const TriangleMesh one = planeGrid(3, 3);
  Array<Vec3> positions = one.positions;
  Array<Triangle> faces = one.faces;
  for (const Vec3& p : one.positions) positions.push_back(p + Vec3(10, 0, 0));
  for (const Triangle& f : one.faces) faces.push_back(f.array() + one.vertexCount());
  return buildMesh(positions, faces);
}

TriangleMesh gridWithCorner() {
  const TriangleMesh square = planeGrid(12, 12);
  Array<Triangle> faces;
  for (const Triangle& face : square.faces) {
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k) middle += square.positions[face[k]] / 3;
    if (middle.x() < 4 || middle.y() < 4) faces.push_back(face);
  }
  return importMesh({square.positions, faces}).mesh;
}

TriangleMesh meshOf(const TriangleSoup& soup) { return buildMesh(soup.positions, soup.triangles); }

Vec2 inVertexFrame(const Geometry& geometry, int vertex, const Vec3& vector) {
  const int h = geometry.mesh->outgoing[vertex];
  return rotateBack(geometry.vertexToFace[h], toFace(geometry, faceOf(h), vector));
}

bool longRun() {
  const char* value = std::getenv("KARCHER_LONG");
  return value != nullptr && std::string(value) == "1";
}

bool leavesLongestOut() {
#ifdef KARCHER_SANITIZED
  const char* value = std::getenv("KARCHER_SANITIZED");
  return value == nullptr || std::string(value) != "all";
#else
  return false;
#endif
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

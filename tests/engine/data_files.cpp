// This is the only file that contains the path of the checkout: the other files compile to the same
// everywhere.
#include <stdexcept>

#include "support.h"

namespace karcher {
namespace {

std::ifstream opened(const std::string& path, const std::string& remedy) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + " is missing: " + remedy);
  return file;
}

}  // namespace

std::ifstream testData(const std::string& name) {
  return opened(KARCHER_TEST_DATA "/" + name, "it belongs to the sources");
}

TriangleMesh bunnyMesh() {
  std::ifstream file = opened(KARCHER_BUNNY_OBJ, "run npm test");
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

}  // namespace karcher

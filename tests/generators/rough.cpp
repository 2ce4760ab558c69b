#include "generators/rough.h"

#include "generators/random.h"
#include "mesh/split_triangles.h"

namespace karcher {

TriangleSoup roughened(const TriangleMesh& mesh, int parts, uint64_t seed, double noise) {
  TriangleSoup soup = splitTriangles(mesh, parts);
  const double amplitude = noise * meanEdgeLength(mesh) / parts;
  Random random(seed);
  for (Vec3& p : soup.positions) {
    for (int k = 0; k < 3; ++k) p[k] += random.uniform(-amplitude, amplitude);
  }
  return soup;
}

}  // namespace karcher

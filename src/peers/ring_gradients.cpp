#include "peers/ring_gradients.h"

#include "peers/descent.h"

namespace karcher {

Array<Vec2> ringGradients(const Geometry& geometry, const Array<double>& values) {
  const TriangleMesh& mesh = *geometry.mesh;
  Array<Vec2> gradients(values.size(), Vec2::Zero());
  Array<double> areas(values.size(), 0);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    const Vec2 inFace = faceGradient(geometry, values, f);
    const double area = doubleArea(geometry, f);
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      gradients[mesh.tail(h)] += area * rotateBack(geometry.vertexToFace[h], inFace);
      areas[mesh.tail(h)] += area;
    }
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    if (areas[v] > 0) gradients[v] /= areas[v];
  }
  return gradients;
}

}  // namespace karcher

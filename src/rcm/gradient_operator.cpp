#include "rcm/gradient_operator.h"

#include <algorithm>
#include <utility>

namespace karcher {

GradientOperator buildGradientOperator(const Geometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  const int vertexCount = mesh.vertexCount();
  GradientOperator result(2 * vertexCount, vertexCount);
  // A vertex's row has itself and its ring: a face, and at the boundary one vertex more.
  Array<int> rowSize(static_cast<size_t>(2 * vertexCount), 1);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int v = mesh.tail(h);
    const int neighbours = 1 + (h == mesh.outgoing[v] && mesh.onBoundary[v] ? 1 : 0);
    rowSize[2 * v] += neighbours;
    rowSize[2 * v + 1] += neighbours;
  }
  result.reserve(rowSize);

  Array<std::pair<int, Vec2>> row;
  const auto add = [&](int column, const Vec2& value) {
    for (auto& [existing, sum] : row) {
      if (existing == column) {
        sum += value;
        return;
      }
    }
    row.emplace_back(column, value);
  };
  for (int v = 0; v < vertexCount; ++v) {
    row.clear();
    double area = 0;
    const int first = mesh.outgoing[v];
    int h = first;
    do {
      const int f = faceOf(h);
      // The gradient of a corner's hat function, times twice the face's area: the opposite edge,
      // turned a quarter. The mean's area weight cancels that factor.
      for (int k = 0; k < 3; ++k) {
        const Vec2 edge = halfedgeInFace(geometry, 3 * f + (k + 1) % 3);
        add(mesh.corner(f, k), rotateBack(geometry.vertexToFace[h], Vec2(-edge.y(), edge.x())));
      }
      area += doubleArea(geometry, f);
      h = rotateLeft(mesh, h);
    } while (h >= 0 && h != first);
    std::sort(row.begin(), row.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (int component = 0; component < 2; ++component) {
      for (const auto& [column, value] : row) {
        result.insert(2 * v + component, column) = value[component] / area;
      }
    }
  }
  result.makeCompressed();
  return result;
}

Array<Vec2> applyGradient(const GradientOperator& gradient, const Array<double>& values) {
  const Eigen::Map<const Eigen::VectorXd> x(values.data(), gradient.cols());
  Array<Vec2> result(values.size());
  Eigen::Map<Eigen::VectorXd>(result.data()->data(), gradient.rows()).noalias() = gradient * x;
  return result;
}

}  // namespace karcher

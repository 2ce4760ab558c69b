#include "rcm/gradient_operator.h"

#include <algorithm>
#include <utility>

namespace karcher {

namespace {

/// A row of the operator under construction: columns in ascending order and their coefficients.
struct Row {
  Array<std::pair<int, Vec2>> entries;
  double area = 0;

  void add(int column, const Vec2& value) {
    const auto place =
        std::lower_bound(entries.begin(), entries.end(), column,
                         [](const auto& entry, int wanted) { return entry.first < wanted; });
    if (place != entries.end() && place->first == column) {
      place->second += value;
    } else {
      entries.insert(place, {column, value});
    }
  }
};

/// The gradient of the hat function of corner k of face f, times twice the face's area: the
/// opposite edge, turned by a right angle. The area weight of the mean cancels the factor.
Vec2 hatGradient(const Geometry& geometry, int f, int k) {
  const Vec2 edge = halfedgeInFace(geometry, 3 * f + (k + 1) % 3);
  return {-edge.y(), edge.x()};
}

/// Adds the face of h to the row of h's tail.
void addFace(const Geometry& geometry, int h, Row& row) {
  const int f = faceOf(h);
  for (int k = 0; k < 3; ++k) {
    row.add(geometry.mesh->corner(f, k),
            rotateBack(geometry.vertexToFace[h], hatGradient(geometry, f, k)));
  }
  row.area += doubleArea(geometry, f);
}

/// Adds the face, if any, across the edge opposite to h's tail.
void addOuterFace(const Geometry& geometry, int h, Row& row) {
  const int inward = geometry.mesh->twin[next(h)];
  if (inward < 0) return;
  const int f = faceOf(inward);
  for (int k = 0; k < 3; ++k) {
    const Vec2 inFaceOfH = acrossEdge(geometry, inward, hatGradient(geometry, f, k));
    row.add(geometry.mesh->corner(f, k), rotateBack(geometry.vertexToFace[h], inFaceOfH));
  }
  row.area += doubleArea(geometry, f);
}

}  // namespace

GradientOperator buildGradientOperator(const Geometry& geometry, Star star) {
  const TriangleMesh& mesh = *geometry.mesh;
  const int vertexCount = mesh.vertexCount();
  GradientOperator result(2 * vertexCount, vertexCount);
  // An upper bound on the columns in a vertex's row: a column for the vertex itself, and two for
  // each face around it (a ring vertex, and the vertex across the outer edge). At the boundary,
  // there is one more for the last ring vertex.
  Array<int> rowSize(static_cast<size_t>(2 * vertexCount), 2);
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    rowSize[2 * mesh.tail(h)] += 2;
    rowSize[2 * mesh.tail(h) + 1] += 2;
  }
  result.reserve(rowSize);

  Row row;
  for (int v = 0; v < vertexCount; ++v) {
    row.entries.clear();
    row.area = 0;
    for (const int h : outgoingHalfedges(mesh, v)) {
      addFace(geometry, h, row);
      if (star == Star::kWide) addOuterFace(geometry, h, row);
    }
    for (int component = 0; component < 2; ++component) {
      for (const auto& [column, value] : row.entries) {
        result.insert(2 * v + component, column) = value[component] / row.area;
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

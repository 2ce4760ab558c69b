#include "bindings/wire.h"

#include <cmath>
#include <string>

#include "mesh/error.h"

namespace karcher::bindings {
namespace {

constexpr int kNumbersPerPoint = 4;

void appendPoint(Array<double>& array, const Numbering& numbering, const SurfacePoint& point) {
  const SurfacePoint input = toInput(numbering, point);
  array.push_back(input.face);
  append(array, input.bary);
}

/// The engine's number of a caller's vertex.
int engineVertex(const Numbering& numbering, int vertex) {
  const int count = numbering.engineVertex.count();
  if (vertex < 0 || vertex >= count) {
    throw Error(ErrorCode::kBadIndex, "there is no vertex " + std::to_string(vertex) +
                                          ": the mesh has " + std::to_string(count) +
                                          " vertices, numbered from 0");
  }
  const int result = numbering.engineVertex[vertex];
  if (result < 0) {
    throw Error(ErrorCode::kBadIndex,
                "vertex " + std::to_string(vertex) + " belongs to no face and was dropped");
  }
  return result;
}

SurfacePoint point(const Numbering& numbering, const TriangleMesh& mesh, const double* numbers) {
  if (std::isnan(numbers[0])) {
    return vertexPoint(mesh, engineVertex(numbering, static_cast<int>(numbers[1])));
  }
  return toEngine(numbering, mesh, static_cast<int>(numbers[0]),
                  {numbers[1], numbers[2], numbers[3]});
}

}  // namespace

val toJs(const Vec3& vector) {
  val list = val::array();
  for (int i = 0; i < 3; ++i) list.set(i, vector[i]);
  return list;
}

val toJs(const Numbering& numbering, const SurfacePoint& point) {
  Array<double> numbers;
  appendPoint(numbers, numbering, point);
  return toJs(numbers);
}

val toJs(const Numbering& numbering, const Array<SurfacePoint>& points) {
  Array<double> numbers;
  for (const SurfacePoint& point : points) appendPoint(numbers, numbering, point);
  return toJs(numbers);
}

SurfacePoint pointFromJs(const Numbering& numbering, const TriangleMesh& mesh, const val& numbers) {
  return point(numbering, mesh, fromJs<double>(numbers).data());
}

Array<SurfacePoint> pointsFromJs(const Numbering& numbering, const TriangleMesh& mesh,
                                 const val& points) {
  const Array<double> numbers = fromJs<double>(points);
  Array<SurfacePoint> result;
  for (int i = 0; i < numbers.count(); i += kNumbersPerPoint) {
    result.push_back(point(numbering, mesh, &numbers[i]));
  }
  return result;
}

}  // namespace karcher::bindings

#pragma once

#include <emscripten/val.h>

#include "mesh/mesh_import.h"
#include "mesh/surface_point.h"

/// Conversion of values between JavaScript and the engine. Arrays are copied. A point is four
/// numbers (face, b0, b1, b2); JavaScript may pass a vertex as (NaN, vertex, 0, 0). Faces and
/// vertices have the caller's numbers in JavaScript and the engine's numbers here.
namespace karcher::bindings {

using emscripten::val;

/// A copy as a typed array of JavaScript.
template <class T>
val toJs(const std::vector<T>& array) {
  return val(emscripten::typed_memory_view(array.size(), array.data())).template call<val>("slice");
}

/// A copy of a typed array of JavaScript.
template <class T>
Array<T> fromJs(const val& numbers) {
  Array<T> array(numbers["length"].as<size_t>());
  val(emscripten::typed_memory_view(array.size(), array.data()))
      .template call<void>("set", numbers);
  return array;
}

/// A list [x, y, z].
val toJs(const Vec3& vector);

inline void append(Array<double>& array, const Vec3& vector) {
  array.insert(array.end(), {vector[0], vector[1], vector[2]});
}

val toJs(const Numbering& numbering, const SurfacePoint& point);
val toJs(const Numbering& numbering, const Array<SurfacePoint>& points);

/// Converts a caller's point (`toEngine`); errors name the caller's face. Throws Error kBadIndex
/// for a vertex that does not exist or belongs to no face.
SurfacePoint pointFromJs(const Numbering& numbering, const TriangleMesh& mesh, const val& point);
Array<SurfacePoint> pointsFromJs(const Numbering& numbering, const TriangleMesh& mesh,
                                 const val& points);

}  // namespace karcher::bindings

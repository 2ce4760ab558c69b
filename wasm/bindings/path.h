#pragma once

#include "bindings/wire.h"

namespace karcher::bindings {

/// A path on the surface as it travels, in arrays over its points. Where the engine gives a point
/// twice, seen from two faces, it is here once.
struct Path {
  bool closed = false;
  double length = 0;
  Array<int> faces;
  Array<double> bary;
  Array<double> positions;
  Array<double> lengths;  ///< from the start
};

/// Appends points of the engine with the length from the first to the last; what lies between two
/// of them is straight, or as good as straight. Returns the numbers of those that stayed.
Array<int> append(Path& path, const Numbering& numbering, const TriangleMesh& mesh,
                  const Array<SurfacePoint>& points, double length);

/// {closed, length, face, bary, position, lengths}
val toJs(const Path& path);

/// The same of points alone.
val pathToJs(const Numbering& numbering, const TriangleMesh& mesh,
             const Array<SurfacePoint>& points, double length, bool closed = false);

}  // namespace karcher::bindings

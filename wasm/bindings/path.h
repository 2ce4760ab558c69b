#pragma once

#include "bindings/wire.h"

namespace karcher::bindings {

/// A path on the surface for JavaScript. Its arrays have an entry for each point. If the engine
/// gives a point twice, in two faces, the path has it once.
struct Path {
  bool closed = false;
  double length = 0;
  Array<int> faces;
  Array<double> bary;
  Array<double> positions;
  Array<double> lengths;  ///< the lengths from the start
};

/// Appends points of the engine; `length` is the length of the path from the first to the last.
/// Between two points the path is straight, or nearly so. Omits points that repeat the previous
/// place. Returns the indices of the appended points.
Array<int> append(Path& path, const Numbering& numbering, const TriangleMesh& mesh,
                  const Array<SurfacePoint>& points, double length);

/// {closed, length, face, bary, position, lengths}
val toJs(const Path& path);

/// The path through these points of the engine, with this length, as `toJs` returns it.
val pathToJs(const Numbering& numbering, const TriangleMesh& mesh,
             const Array<SurfacePoint>& points, double length, bool closed = false);

}  // namespace karcher::bindings

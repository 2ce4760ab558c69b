#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"
#include "intrinsic/taut_search.h"

/// Fast search for a short path between any two points. Strips of faces are searched from both
/// ends, pulled tight, and led over vertices beside them if that makes them shorter; the shortest
/// is taken. The path is locally shortest, and seldom longer than the shortest path by more than a
/// thousandth. The work grows as the square of the distance up to a hundred mean edges; beyond,
/// greedier searches find a first path, which is then searched again piece by piece.
namespace karcher {

/// Scratch memory, which can be reused.
struct FindPathWorkspace {
  StripWorkspace strip;
  TautSearchWorkspace taut;
  Array<SurfacePoint> points;
  SurfacePath pieces;
  Array<SurfacePoint> piece;
};

struct FindPathOptions {
  /// Compare the path with the exact shortest one (shortest_path.h), which takes far longer, and
  /// return that if it is shorter.
  bool certified = false;
};

/// Writes the path to `out`. The path from `to` to `from` is the same one reversed. Returns false
/// and changes nothing if the points lie on different components.
bool findPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
              FindPathWorkspace& workspace, SurfacePath& out, const FindPathOptions& options = {});

}  // namespace karcher

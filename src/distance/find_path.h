#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"
#include "intrinsic/taut_search.h"

/// A fast search for a short path between any two points. It searches strips of faces from both
/// ends, and pulls the path in each strip tight. If a path becomes shorter on the other side of a
/// vertex beside it, the strip changes to that side. The result is the shortest of these paths. It
/// is locally shortest, and seldom longer than the shortest path by more than a thousandth. The
/// work grows as the square of the distance up to a hundred mean edges. For greater distances, a
/// greedier search finds a first path, which is then improved piece by piece.
namespace karcher {

/// Reusable scratch memory.
struct FindPathWorkspace {
  StripWorkspace strip;
  TautSearchWorkspace taut;
  Array<SurfacePoint> points;
  SurfacePath pieces;
  Array<SurfacePoint> piece;
};

struct FindPathOptions {
  /// Whether to compare the path with the exact shortest one (shortest_path.h) and to return the
  /// shorter of the two. The comparison takes far longer.
  bool certified = false;
};

/// Writes the path to `out`. The path from `to` to `from` is its reverse. Returns false and changes
/// nothing if the points lie on different components.
bool findPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
              FindPathWorkspace& workspace, SurfacePath& out, const FindPathOptions& options = {});

}  // namespace karcher

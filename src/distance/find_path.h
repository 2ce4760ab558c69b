#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"
#include "intrinsic/taut_search.h"

/// A fast search for a short path between any two points. Strips of faces are searched from both
/// ends and pulled tight; where that makes them shorter, they are led over vertices beside them.
/// The shortest of the resulting paths counts. It is locally shortest, and seldom longer than the
/// shortest path by more than a thousandth. The work grows as the square of the distance up to a
/// hundred mean edges. Beyond, greedier searches find a first path, which is then searched again
/// piece by piece.
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
  /// Whether to compare the path with the exact shortest one (shortest_path.h), which takes far
  /// longer, and to return the shorter of the two.
  bool certified = false;
};

/// Writes the path to `out`. The path from `to` to `from` is its reverse. Returns false and changes
/// nothing if the points lie on different components.
bool findPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
              FindPathWorkspace& workspace, SurfacePath& out, const FindPathOptions& options = {});

}  // namespace karcher

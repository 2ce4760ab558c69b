#pragma once

#include "intrinsic/strip_path.h"
#include "intrinsic/surface_path.h"
#include "intrinsic/taut_search.h"

/// A short path between two points wherever they lie, fast: strips of faces are searched from both
/// ends, pulled tight, led over the vertices beside them where this makes them shorter, and the
/// shortest is taken. It is locally shortest, and seldom longer than the shortest path of all by
/// more than a thousandth. Work that grows as the square of the distance is spent up to a hundred
/// mean edges; beyond, greedier searches find a first path, which is then searched again piece by
/// piece.
namespace karcher {

/// Scratch memory; reuse one to spare the allocations.
struct FindPathWorkspace {
  StripWorkspace strip;
  TautSearchWorkspace taut;
  Array<SurfacePoint> points;
  SurfacePath pieces;
  Array<SurfacePoint> piece;
};

struct FindPathOptions {
  /// Compares the path with the shortest one by exact windows (shortest_path.h), which takes far
  /// longer, and takes that where it is shorter.
  bool certified = false;
};

/// Writes the path to `out`; from `to` to `from` it is the same one reversed. Returns false, and
/// changes nothing, where the points lie on different components.
bool findPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
              FindPathWorkspace& workspace, SurfacePath& out, const FindPathOptions& options = {});

}  // namespace karcher

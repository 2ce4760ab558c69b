#pragma once

#include <optional>

#include "regions/arrangement.h"

/// Regions as sets of cells, regions that curves enclose, and booleans. The label of a cell on the
/// left of a path is one more than that of the cell on its right. If the paths bound a region, this
/// determines the labels of all cells up to a constant. If the changes of the label do not cancel
/// around a handle of the surface, or around the end of a path, the paths enclose no region. A
/// surface has no natural outside. On each component, the cells of one label are outside: the label
/// whose cells have the largest area together. Of equal areas, those right of the curves are
/// outside. The label of a given cell that must lie inside is never outside.
namespace karcher {

/// A region: 1 for each cell that belongs to it, else 0.
using Region = Array<uint8_t>;

enum class FillRule {
  kEvenOdd,  ///< the cells that an odd number of crossings separates from the outside
  /// the cells to which a way from the outside crosses the paths more often in one direction than
  /// in the other
  kNonZero,
};

enum class Boolean { kUnion, kIntersection, kDifference, kExclusion };

/// A range of the arrangement's paths: `count` of them, starting with `first`.
struct PathRange {
  int first = 0;
  int count = 0;
};

/// The region that paths enclose together. If the cell `inside` is given, the region contains it.
/// Throws Error kBadArgument if the paths do not bound a region.
Region enclosed(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                std::optional<int> inside = std::nullopt);

/// The sides of a path, seen along it.
enum class PathSide { kLeft, kRight };

/// The cell on a side of the first of these paths. It is the cell at the path's first place where
/// the labels on the two sides differ (with kEvenOdd, by an odd number). Places inside the surface
/// take precedence over those on its boundary. The result is empty if there is no such place, or if
/// the side lies beyond the boundary.
std::optional<int> cellBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                              PathSide side);

/// The region that paths enclose together, on a side of the first path. If this path moves, the
/// region moves with it. Throws Error kBadArgument if the paths do not bound a region.
Region enclosedBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                      PathSide side);

Region combined(const Region& a, const Region& b, Boolean how);

double areaOf(const Arrangement& arrangement, const Region& region);

/// The half-edges that have the region on their left but not on their right, in loops. They include
/// half-edges on the surface's boundary. Where a region touches itself at a vertex, a loop stays in
/// its own corner of the region and does not pass into another one.
Array<Array<int>> boundaryOf(const Arrangement& arrangement, const Region& region);

/// A loop of half-edges as a path that ends where it starts.
SurfacePath pathOf(const Geometry& geometry, const Arrangement& arrangement,
                   const Array<int>& loop);

}  // namespace karcher

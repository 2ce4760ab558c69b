#pragma once

#include <optional>

#include "regions/arrangement.h"

/// Regions as sets of cells, regions that curves enclose, and booleans.
///
/// A cell on the left of a path counts one more than on the right of it. Summed from cell to cell,
/// this labels all cells up to a constant if the paths bound a region. If the counts do not cancel
/// around a handle of the surface, or around the end of a path, nothing is enclosed. A surface has
/// no natural outside: it is the label of the greatest area, unless a point decides otherwise.
namespace karcher {

/// 1 for each cell that belongs to the region.
using Region = Array<uint8_t>;

enum class FillRule {
  kEvenOdd,  ///< what is reached from outside by an odd number of crossings
  kNonZero,  ///< what is reached by more crossings from right to left than the other way, or fewer
};

enum class Boolean { kUnion, kIntersection, kDifference, kExclusion };

/// A range of the arrangement's paths: `count` of them from `first` on.
struct PathRange {
  int first = 0;
  int count = 0;
};

/// The region that paths enclose together. `inside` is a cell that must be inside. Throws Error
/// kBadArgument if the paths do not bound a region.
Region enclosed(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                std::optional<int> inside = std::nullopt);

/// The sides of a path, seen along it.
enum class PathSide { kLeft, kRight };

/// The cell on a side of the first of these paths, where it first has other cells on its two sides
/// (by parity, where `rule` is that); none where it has not, or beyond the boundary.
std::optional<int> cellBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                              PathSide side);

/// The region that paths enclose together on a side of the first one, which moves along with that
/// path. Throws Error kBadArgument if the paths do not bound a region.
Region enclosedBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                      PathSide side);

Region combined(const Region& a, const Region& b, Boolean how);

double areaOf(const Arrangement& arrangement, const Region& region);

/// The half-edges that have the region only on their left, including the surface's boundary, in
/// loops. Where a region touches itself at a vertex, the loops turn back.
Array<Array<int>> boundaryOf(const Arrangement& arrangement, const Region& region);

/// A loop of half-edges as a path that ends where it starts.
SurfacePath pathOf(const Geometry& geometry, const Arrangement& arrangement,
                   const Array<int>& loop);

}  // namespace karcher

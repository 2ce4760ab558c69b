#pragma once

#include <optional>

#include "regions/arrangement.h"

/// Regions as sets of cells, what curves enclose, and booleans.
///
/// Left of a path a cell counts one more than right of it. Summed from cell to cell this labels
/// all, up to a constant, where the paths bound: on a way round a handle of the surface, or round
/// the end of a path, the counts cancel, or they do not and nothing is enclosed. What is outside is
/// not known on a surface; it is the label of the greatest area, unless a point says otherwise.
namespace karcher {

/// Per cell 1 where it belongs to the region.
using Region = Array<uint8_t>;

enum class FillRule {
  kEvenOdd,  ///< what is reached from outside by an odd number of crossings
  kNonZero,  ///< what is reached by more crossings from right to left than the other way, or fewer
};

enum class Boolean { kUnion, kIntersection, kDifference, kExclusion };

/// Which of the arrangement's paths are looked at: from `first`, so many of them.
struct PathRange {
  int first = 0;
  int count = 0;
};

/// What paths enclose together. `inside` is a cell that shall be inside.
/// Throws Error kBadArgument where they do not bound.
Region enclosed(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                std::optional<int> inside = std::nullopt);

/// The sides of a path, seen along it.
enum class PathSide { kLeft, kRight };

/// The cell on a side of the first of these paths, where it first has other cells on its two sides
/// (by parity, where `rule` is that); none where it has not, or beyond the boundary.
std::optional<int> cellBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                              PathSide side);

/// What paths enclose together, on a side of the first one: where that path is moved, this is what
/// moves along. Throws Error kBadArgument where they do not bound.
Region enclosedBeside(const Arrangement& arrangement, const PathRange& paths, FillRule rule,
                      PathSide side);

Region combined(const Region& a, const Region& b, Boolean how);

double areaOf(const Arrangement& arrangement, const Region& region);

/// The half-edges that have the region on their left only, the boundary of the surface among them,
/// in loops. Where a region touches itself at a vertex the loops turn back.
Array<Array<int>> boundaryOf(const Arrangement& arrangement, const Region& region);

/// A loop of half-edges as a path that ends where it starts.
SurfacePath pathOf(const Geometry& geometry, const Arrangement& arrangement,
                   const Array<int>& loop);

/// Both sides of the theorem of Gauss and Bonnet for a region whose corners at one vertex count as
/// many: the sum of the angles that are missing at vertices inside and of the turns of the
/// boundary, and 2 pi times the Euler characteristic.
struct GaussBonnet {
  double curvature = 0;
  int euler = 0;
};
GaussBonnet gaussBonnet(const Geometry& geometry, const Arrangement& arrangement,
                        const Region& region);

}  // namespace karcher

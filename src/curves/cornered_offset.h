#pragma once

#include <cmath>

#include "curves/offset.h"
#include "distance/path_distance.h"

/// Offsets with mitred or bevelled corners.
///
/// Paths are divided at their corners, and where they have turned by a right angle since, so that
/// no piece comes back in front of its own end. What lies within the distance of a piece, but not
/// in front of its ends, is its strip. At a corner a gap is left between two strips on the outer
/// side: a mitre continues the sides of both by geodesics until they meet, a bevel joins their
/// ends. The offset is the boundary of all strips and tips together, found in the surface cut by
/// their lines into cells (regions/arrangement.h): a cell is inside if a point of it is.
///
/// Corners at which a connection or a side ends at the boundary of the surface stay round, and so
/// do turns by less than kLeastCorner.
namespace karcher {

/// The field of an offset extends a little beyond the line, so that chords outside of it are
/// measured, too.
inline constexpr double kOffsetReach = 1.1;

/// The tip of a mitre over a smaller turn, in radians, is within kOffsetTolerance of the arc.
inline const double kLeastCorner = std::sqrt(8 * kOffsetTolerance);

/// The vertices of the surface, times the pieces between corners.
inline constexpr int64_t kMostCorneredVertices = 20'000'000;

/// A line of points at one distance, or a part of it whose shortest connections arrive from one
/// side. Nearer points lie on its left.
struct OffsetRun {
  Array<SurfacePoint> points;
  SideOfPath side = SideOfPath::kEnd;
  bool isClosed = false;
};

Array<OffsetRun> offsetRuns(const Geometry& geometry, const PathDistance& field, double distance);

Array<Isoline> corneredOffset(const Geometry& geometry, std::span<const SurfacePath> paths,
                              double distance, OffsetSide side, const OffsetCorners& corners);

}  // namespace karcher

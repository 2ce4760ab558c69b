#pragma once

#include <cmath>

#include "curves/offset.h"
#include "distance/path_distance.h"

/// Offsets with mitred or bevelled corners. Perpendiculars divide a path into pieces at its
/// corners, and wherever it has turned by a right angle since the last division. So no piece turns
/// back to the area in front of its own end. The strip of a piece is the part of the surface within
/// the offset's distance from the piece, without the area in front of an end at which a
/// perpendicular divides the path. On the outer side of a corner, a tip fills the gap between the
/// strips: a mitre continues the sides of both strips by geodesics until they meet; a bevel joins
/// the ends of the sides. The offset is the boundary of the union of all strips and tips.
///
/// The lines of the strips and tips divide the surface into cells (regions/arrangement.h); a cell
/// belongs to the union if a point inside the cell does. A corner stays round if it lies on the
/// boundary of the surface, if a perpendicular on its outer side meets the boundary, or if it turns
/// by less than kLeastCorner.
namespace karcher {

/// The longest side of the pieces into which the tracer divides faces, relative to the scale of
/// `offsetRuns`. An arc over a chord of this length is 8.7e-4 of its radius high.
inline constexpr double kLongestSide = 1.0 / 12;

/// The reach of an offset's field, relative to the offset's distance. It exceeds 1 so that the
/// field can also measure chords outside the line.
inline constexpr double kOffsetReach = 1.1;

/// The smallest turn, in radians, at which a corner has a tip. At smaller turns, the tip would lie
/// within kOffsetTolerance of the round corner.
inline const double kLeastCorner = std::sqrt(8 * kOffsetTolerance);

/// The largest product of the number of vertices and the number of pieces between corners.
inline constexpr int64_t kMostCorneredVertices = 20'000'000;

/// A line of points at one distance from a path, or a part of such a line. The shortest connections
/// of its points all meet the path from the same side, or all at an end. Nearer points lie on the
/// left of the run.
struct OffsetRun {
  Array<SurfacePoint> points;
  SideOfPath side = SideOfPath::kEnd;
  bool isClosed = false;
};

/// All runs at `distance` from the paths of a field. Tolerances are relative to `scale`.
Array<OffsetRun> offsetRuns(const Geometry& geometry, const PathDistance& field, double distance,
                            double scale);

Array<Isoline> corneredOffset(const Geometry& geometry, std::span<const SurfacePath> paths,
                              double distance, OffsetSide side, const OffsetCorners& corners);

}  // namespace karcher

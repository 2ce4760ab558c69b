#pragma once

#include <span>

#include "curves/isoline.h"
#include "intrinsic/surface_path.h"

namespace karcher {

enum class OffsetSide { kLeft, kRight, kBoth };

enum class CornerShape { kRound, kMiter, kBevel };

/// The shape of the paths' corners on their outer side.
struct OffsetCorners {
  CornerShape shape = CornerShape::kRound;
  /// The largest distance between the tip of a mitre and its corner, relative to the offset's
  /// distance, as in SVG. A corner whose mitre would be longer has a bevel.
  double miterLimit = 4;
};

/// The offset of paths: the isolines of the exact distance from them (path_distance.h), with round
/// corners and without self-intersections. An offset on one side consists of the points whose
/// shortest connection meets a path from that side, and its lines run in the direction of the
/// paths. An offset on both sides also has the points around the ends of open paths, and its lines
/// have nearer points on their left.
///
/// The tracer halves faces at their longest sides until all sides are short compared with the
/// distance. Since distances are Lipschitz, it can skip pieces too near or too far to contain the
/// line. Points lie at the distance up to rounding, and chords deviate from it by at most
/// kOffsetTolerance, relative to the distance. The lines may omit features narrower than a twelfth
/// of the distance.
///
/// Several distances belong to equally spaced places along each path, and are interpolated linearly
/// by length between these places. On a closed path, the first distance follows the last. The lines
/// are then the border of a union of disks: each point of the paths is the center of a disk, and
/// its distance is the radius. Along a straight piece the border is straight, and touches the disks
/// at both ends. Tolerances are relative to the smallest distance or to kNarrowestOffset times the
/// largest, whichever is larger.
///
/// Corners that are not round follow cornered_offset.h.
///
/// Throws Error kBadArgument: no positive distance; a negative or infinite distance; several
/// distances with corners that are not round; a path without length; consecutive points without a
/// common face; a mitre limit below 1; more than kMostOffsetPieces pieces of faces; too many
/// corners that are not round.
Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                           std::span<const double> distances, OffsetSide side,
                           const OffsetCorners& corners = {});
inline Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                                  double distance, OffsetSide side,
                                  const OffsetCorners& corners = {}) {
  return offsetLines(geometry, paths, std::span(&distance, 1), side, corners);
}
inline constexpr double kOffsetTolerance = 5e-4;
inline constexpr double kNarrowestOffset = 1.0 / 16;
inline constexpr int64_t kMostOffsetPieces = 20'000'000;

}  // namespace karcher

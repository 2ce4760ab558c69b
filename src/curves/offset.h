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
  /// The largest distance between the tip of a mitre and its corner, in distances of the offset, as
  /// in SVG. Corners that would exceed it are bevelled.
  double miterLimit = 4;
};

/// The points at one distance from paths: isolines of the exact distance (path_distance.h), whose
/// corners are round and which do not intersect themselves. On one side, these are the points whose
/// shortest connection arrives from that side; on both, also those around the ends of open paths.
/// Lines on one side run in the direction of the paths; on both, they have nearer points on their
/// left.
///
/// Faces are halved along their longest sides until these are short compared with the distance.
/// Since distances are Lipschitz, pieces too near or too far to contain the line are skipped.
/// Points lie at the distance up to rounding, and chords stay within kOffsetTolerance of it.
/// Features narrower than a twelfth of the distance may be missed.
///
/// Corners that are not round follow cornered_offset.h.
///
/// Throws Error kBadArgument (distance not positive and finite, a path without length, points
/// without a face in common, a limit of mitres below 1, more than kMostOffsetPieces pieces of
/// faces, or more corners that are not round than there is room for).
Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                           double distance, OffsetSide side, const OffsetCorners& corners = {});
inline constexpr double kOffsetTolerance = 5e-4;
inline constexpr int64_t kMostOffsetPieces = 20'000'000;

}  // namespace karcher

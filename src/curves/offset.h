#pragma once

#include <span>

#include "curves/isoline.h"
#include "intrinsic/surface_path.h"

namespace karcher {

enum class OffsetSide { kLeft, kRight, kBoth };

/// The points at one distance from paths: isolines of the exact distance (path_distance.h), whose
/// corners are round and which do not intersect themselves. On one side, these are points whose
/// shortest connection arrives from there; on both, also those around the ends of open paths. Lines
/// on one side run as the paths do; on both, they have nearer points on their left.
///
/// Faces are halved along their longest sides until these are short compared with the distance;
/// pieces that cannot have such points are skipped, since distances are Lipschitz. Points lie at
/// the distance up to rounding, and chords stay within kOffsetTolerance of it. Features narrower
/// than a twelfth of the distance may be missed.
///
/// Throws Error kBadArgument (distance not positive and finite, a path without length, points
/// without a face in common, or more than kMostOffsetPieces pieces of faces).
Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                           double distance, OffsetSide side);
inline constexpr double kOffsetTolerance = 5e-4;
inline constexpr int64_t kMostOffsetPieces = 20'000'000;

}  // namespace karcher

#pragma once

#include <span>

#include "curves/isoline.h"
#include "intrinsic/surface_path.h"

namespace karcher {

enum class OffsetSide { kLeft, kRight, kBoth };

/// The points at one distance from paths: isolines of the exact distance (path_distance.h), so
/// corners are round, and what runs into itself is trimmed. Of one side those points whose shortest
/// way comes from there; of both also those round the ends of open paths. Lines of one side run as
/// the paths do, of both with what is nearer on their left.
///
/// Faces are halved along their longest sides until these are short beside the distance; what
/// cannot have such points is passed over, since a distance changes by no more than the way. Points
/// lie at the distance to rounding, and chords keep to it within kOffsetTolerance of it. What is
/// narrower than a twelfth of the distance may be missed.
///
/// Throws Error kBadArgument (distance not positive and finite, a path without length, points
/// without a face in common, or more than kMostOffsetPieces pieces of faces).
Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                           double distance, OffsetSide side);
inline constexpr double kOffsetTolerance = 5e-4;
inline constexpr int64_t kMostOffsetPieces = 20'000'000;

}  // namespace karcher

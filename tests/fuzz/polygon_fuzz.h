#pragma once

#include <string>

#include "curves/curve.h"

/// Random control polygons, and the properties that every curve must have.
namespace karcher {

/// The distance of a random polygon's control points, as a part of the bounding box's diagonal; 0
/// stands for anywhere on the surface.
inline constexpr double kSpacings[] = {0.01, 0.03, 0.1, 0.3, 0};
inline constexpr int kSpacingCount = 5;

/// Findings, summed over curves.
struct FuzzTally {
  struct OfSpacing {
    int polygons = 0;
    int curves = 0;
    double marked = 0;  ///< the sum of the curves' marked parts of the parameter
  };
  OfSpacing spacings[kSpacingCount];
  int steps = 0;              ///< the number of steps between samples, outside marked intervals
  int lostBetween = 0;        ///< searches between two converged samples that do not converge
  double largestJump = 0;     ///< the largest jump without a mark, in mean edges
  double largestJoin = 0;     ///< the largest gap between segments, as a part of the diagonal
  double largestEdit = 0;     ///< edited curves against new ones, as a part of the diagonal
  Array<std::string> faults;  ///< the faults, as sentences
};

/// Checks one random polygon as curves of all kinds, open and closed. The marks and the points on
/// the surface are sound. No step outside a mark stays longer than kLongestStep however finely t is
/// divided. Segments meet, and edits equal new traces. Everything depends on the seed alone. With
/// levels, or kAutomaticLevels, it takes only the kinds with levels.
void fuzzPolygon(Surface& surface, int spacing, uint64_t seed, FuzzTally& tally, int levels = 0);

}  // namespace karcher

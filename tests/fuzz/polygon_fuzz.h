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
    double marked = 0;  ///< sum of the curves' parts of the parameter that are marked
  };
  OfSpacing spacings[kSpacingCount];
  int steps = 0;              ///< between samples, outside marked intervals
  int lostBetween = 0;        ///< searches between two converged samples that do not converge
  double largestJump = 0;     ///< that is not marked, in mean edges
  double largestJoin = 0;     ///< between segments, as a part of the diagonal
  double largestEdit = 0;     ///< edited curves against traced anew, as a part of the diagonal
  Array<std::string> faults;  ///< sentences
};

/// Checks one random polygon as curves of all kinds, open and closed: that the marks and the points
/// on the surface are sound, that no step outside a mark stays longer than kLongestStep however
/// finely t is divided, that segments meet, and that edits give what tracing anew gives. Everything
/// depends on the seed alone. With levels, or kAutomaticLevels, the kinds that take them alone.
void fuzzPolygon(Surface& surface, int spacing, uint64_t seed, FuzzTally& tally, int levels = 0);

}  // namespace karcher

#pragma once

#include "mesh/types.h"

/// How exact shortest paths end, and what of them is decided by more than rounding.
namespace karcher {

/// The end of a shortest path.
struct Arrival {
  double distance = kInfinity;
  double pseudoSourceDistance = 0;  ///< distance of the last vertex that the path turns round
  int pseudoSource = -1;            ///< that vertex, or -1: straight from the source
};

/// A line that misses its window by this part of the edge still counts as seen through it.
inline constexpr double kSeenTolerance = 1e-10;

/// Paths with a slight bend, at the end of a window, count as longer by this part: the straight
/// path wins, whose direction is exact.
inline constexpr double kBentPenalty = 1e-12;

/// Whether two lengths differ by rounding alone. Of two such paths the mesh's numbering chooses: a
/// mesh that is moved has the same, where its coordinates are not rounded by more than that.
inline bool isTie(double a, double b) {
  constexpr double kRounding = 2e-13;
  return b < kInfinity && std::abs(a - b) <= kRounding * b;
}

}  // namespace karcher

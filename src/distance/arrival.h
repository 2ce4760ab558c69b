#pragma once

#include "mesh/rounding.h"
#include "mesh/types.h"

/// Ends of exact shortest paths, and comparisons of paths up to rounding.
namespace karcher {

/// The end of a shortest path.
struct Arrival {
  double distance = kInfinity;
  double pseudoSourceDistance = 0;  ///< distance of the last vertex at which the path turns
  int pseudoSource = -1;            ///< that vertex, or -1 if the path is straight
};

/// A line that misses its window by at most this part of the edge counts as passing through it.
inline constexpr double kSeenTolerance = 1e-10;

/// The length of a path with a slight bend at the end of a window, as it is compared: a straight
/// path of the same length wins, whose direction is exact.
inline double bentLength(double length) { return length * (1 + kLocalRounding); }

/// Whether two lengths differ only by rounding. The mesh's numbering then decides between the
/// paths, so that a moved mesh has the same path unless its coordinates are rounded more coarsely.
inline bool isTie(double a, double b) {
  constexpr double kRounding = 2e-13;
  return b < kInfinity && std::abs(a - b) <= kRounding * b;
}

}  // namespace karcher

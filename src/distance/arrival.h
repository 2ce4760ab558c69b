#pragma once

#include "mesh/rounding.h"
#include "mesh/types.h"

/// Ends of exact shortest paths, and comparisons of paths up to rounding.
namespace karcher {

/// The end of a shortest path.
struct Arrival {
  double distance = kInfinity;
  double pseudoSourceDistance = 0;  ///< the distance of the last vertex at which the path turns
  int pseudoSource = -1;  ///< the last vertex at which the path turns, or -1 if it is straight
};

/// A line that misses a window by at most this length, relative to the edge, counts as a line
/// through the window.
inline constexpr double kSeenTolerance = 1e-10;

/// The length of a path that bends slightly at the end of a window, for comparisons with other
/// paths. It exceeds the true length by a rounding error, so that a straight path of the same
/// length wins: the direction of a straight path is exact.
inline double bentLength(double length) { return length * (1 + kLocalRounding); }

/// Whether two lengths differ only by rounding. If so, the indices of half-edges and vertices
/// decide between the paths. A moved copy of the mesh then has the same path unless its coordinates
/// are rounded more coarsely.
inline bool isTie(double a, double b) {
  constexpr double kRounding = 2e-13;
  return b < kInfinity && std::abs(a - b) <= kRounding * b;
}

}  // namespace karcher

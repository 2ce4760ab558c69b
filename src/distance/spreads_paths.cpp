#include <cmath>

#include "distance/window_distance.h"
#include "intrinsic/angles.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The angle of a sliver's tip, in radians. If a vertex is flat up to kChainRounding and one of its
/// corners has an angle below this, the whole corner may lie in the vertex's shadow.
constexpr double kSliver = 1e-8;

}  // namespace

bool spreadsPaths(const Geometry& geometry, int vertex) {
  const double flat = geometry.mesh->onBoundary[vertex] ? kPi : 2 * kPi;
  const double excess = geometry.totalAngle[vertex] - flat;
  if (std::abs(excess) > kChainRounding) return excess > 0;
  for (const int h : outgoingHalfedges(*geometry.mesh, vertex)) {
    if (geometry.cornerAngle[h] < kSliver) return true;
  }
  return false;
}

}  // namespace karcher

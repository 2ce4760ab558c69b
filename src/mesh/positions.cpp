#include "mesh/positions.h"

#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// Between them lengths are floats, by which the distances' queue is ordered, and products of
/// several are doubles.
constexpr double kLargestCoordinate = 1e30;
constexpr double kSmallestExtent = 1e-30;

}  // namespace

void checkPositions(const Array<Vec3>& positions) {
  if (positions.empty()) return;
  Vec3 low = positions.front();
  Vec3 high = low;
  for (int v = 0; v < positions.count(); ++v) {
    const Vec3& p = positions[v];
    if (!p.allFinite()) {
      throw Error(ErrorCode::kNotFinite,
                  "vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
    }
    const double largest = p.cwiseAbs().maxCoeff();
    if (largest > kLargestCoordinate) {
      refuse("vertex " + std::to_string(v) + " has a coordinate of size " + inSentence(largest) +
             "; at most " + inSentence(kLargestCoordinate) + " is allowed: scale the mesh first");
    }
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  if (extent > 0 && extent < kSmallestExtent) {
    refuse("the mesh is only " + inSentence(extent) + " wide; it must be at least " +
           inSentence(kSmallestExtent) + ": scale the mesh first");
  }
}

}  // namespace karcher

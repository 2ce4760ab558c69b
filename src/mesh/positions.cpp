#include "mesh/positions.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// The largest coordinate. Its inverse is the least width of a mesh. Between these limits, lengths
/// fit floats, and products of several lengths fit doubles.
constexpr double kLargestCoordinate = 1e30;

class Check {
 public:
  void vertex(int v, const Vec3& p) {
    if (!p.allFinite()) {
      throw Error(ErrorCode::kNotFinite,
                  "vertex " + std::to_string(v) + " has a coordinate that is not a finite number");
    }
    const double largest = p.cwiseAbs().maxCoeff();
    if (largest > kLargestCoordinate) {
      refuse("vertex " + std::to_string(v) + " has a coordinate of size " + inSentence(largest) +
             "; at most " + inSentence(kLargestCoordinate) + " is allowed: scale the mesh first");
    }
    low_ = low_.cwiseMin(p);
    high_ = high_.cwiseMax(p);
  }

  /// The diagonal of the box around all checked positions.
  double diagonal() const {
    const double extent = (high_ - low_).maxCoeff();
    if (extent > 0 && extent < 1 / kLargestCoordinate) {
      refuse("the mesh is only " + inSentence(extent) + " wide; it must be at least " +
             inSentence(1 / kLargestCoordinate) + ": scale the mesh first");
    }
    return (high_ - low_).norm();
  }

 private:
  Vec3 low_ = Vec3::Constant(kInfinity);
  Vec3 high_ = Vec3::Constant(-kInfinity);
};

}  // namespace

double checkPositions(const Array<Vec3>& positions, const Array<int>* vertices) {
  const int count = vertices ? vertices->count() : positions.count();
  Check check;
  for (int i = 0; i < count; ++i) {
    const int v = vertices ? (*vertices)[i] : i;
    check.vertex(v, positions[v]);
  }
  return count == 0 ? 0 : check.diagonal();
}

void checkPlace(const Vec3& place) {
  if (!place.allFinite()) {
    throw Error(ErrorCode::kNotFinite, "the place has a coordinate that is not a finite number");
  }
  const double largest = place.cwiseAbs().maxCoeff();
  if (largest > kLargestCoordinate) {
    throw Error(ErrorCode::kBadArgument, "the place has a coordinate of size " +
                                             inSentence(largest) + "; at most " +
                                             inSentence(kLargestCoordinate) + " is allowed");
  }
}

double extentOf(const Array<Vec3>& positions) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : positions) middle += p / static_cast<double>(positions.count());
  double farthest = 0;
  for (const Vec3& p : positions) farthest = std::max(farthest, (p - middle).norm());
  return 2 * farthest;
}

}  // namespace karcher

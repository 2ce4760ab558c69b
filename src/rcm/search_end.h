#pragma once

#include "mesh/surface_point.h"

/// The end of a search for a center of mass.
namespace karcher {

/// The result of a search. With kConverged the point is a center of mass (a local minimum of K);
/// otherwise it is the place where the search ended.
enum class Status {
  kConverged,
  kIndefinite,  ///< the Hessian is not positive definite: the points are too far apart
  kBoundary,    ///< the minimum lies on the boundary, where grad K does not vanish
  kNoProgress,  ///< no point along the Newton step has a smaller gradient
  kLimit,       ///< the search reached its bound on iterations
  /// The point is a zero, but K by exact distances is lower near it (exact_minimum.h). This status
  /// is only for checked means (mean.h).
  kLowerNearby,
};

/// The name of a status in reports: "converged".
inline const char* statusName(Status status) {
  switch (status) {
    case Status::kConverged:
      return "converged";
    case Status::kIndefinite:
      return "indefinite";
    case Status::kBoundary:
      return "boundary";
    case Status::kNoProgress:
      return "noProgress";
    case Status::kLimit:
      return "limit";
    case Status::kLowerNearby:
      return "lowerNearby";
  }
  return "unknown";
}

struct SearchEnd {
  SurfacePoint point;
  Status status = Status::kConverged;
  int iterations = 0;
};

}  // namespace karcher

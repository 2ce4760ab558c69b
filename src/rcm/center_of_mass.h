#pragma once

#include "rcm/field_blend.h"

/// The Riemannian center of mass of weighted points: the zero of grad K.
namespace karcher {

/// How a search ended. Only kConverged is a center of mass (a local minimum of K); with the others
/// the point is where the search stood.
enum class Status {
  kConverged,
  kIndefinite,  ///< the Hessian is not positive definite: the points lie too far apart
  kBoundary,    ///< the minimum lies on the boundary, where grad K does not vanish
  kNoProgress,  ///< no point along the Newton step has a smaller gradient
  kLimit,       ///< the bound on iterations was reached
  /// The point is a zero, but K by exact distances is lower near it (exact_minimum.h). Only for
  /// checked means (mean.h).
  kLowerNearby,
};

/// The name of a status in reports: "converged".
const char* statusName(Status status);

/// A zero lies in the face if no barycentric weight is further below 0.
inline constexpr double kInsideTolerance = 1e-10;

struct CenterOfMass {
  SurfacePoint point;
  Status status = Status::kConverged;
  int iterations = 0;
};

/// Whether grad K vanishes at a point, up to rounding, and the Hessian there is positive definite.
/// A search that starts there ends at once, though another zero may lie deeper in a face near by
/// (deepest_zero.h).
bool isZero(FieldBlend& fields, Weights weights, const SurfacePoint& point);

/// The zero on an edge if the cells on both sides each have theirs behind it, or around the end of
/// the edge that it lies beyond. `h` is a half-edge of a cell, not on the boundary.
CenterOfMass centerBetween(FieldBlend& fields, Weights weights, int h);

/// Finds the zero of the blended field by walking from face to face. In each face the zero has a
/// closed form; if it lies outside, the walk crosses the edge that it lies behind. A near start
/// takes one or two faces. Zeros between faces are taken on their edge or vertex.
CenterOfMass walkToCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start);

}  // namespace karcher

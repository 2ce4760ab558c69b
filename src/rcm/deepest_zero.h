#pragma once

#include "rcm/field_blend.h"

namespace karcher {

/// The choice between zeros of adjacent cells.
///
/// The field is not continuous across edges. So near an edge, both cells may have a zero, or
/// neither cell. If both have a zero, the zero that lies deeper inside its cell counts. So a center
/// does not depend on the cell that the search visited first.
///
/// `zero` is the blend's zero in `cell`, and lies inside the cell. Returns the deepest of this zero
/// and the zeros around it. Usually `isTheOnlyZero` shows quickly that no other zero is near.
SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int cell, const CellZero& zero);

/// If all weights of a zero exceed this bound, no other zero is near, since the field's
/// discontinuity moves a zero by a smaller fraction of an edge. (Larger discontinuities make a
/// curve jump; curves/trace/bridge.h finds such jumps.)
inline constexpr double kNearEdge = 0.1;

/// Whether no adjacent face can have another zero, given the cell's zero and its depth inside the
/// face.
inline bool isTheOnlyZero(const CellZero& zero, double depth) {
  // In the zero's face, the values at an edge's ends make an angle of less than pi. The other face
  // turns these values relative to each other by at most `holonomy`.
  const double most =
      std::max({zero.field.corner[0].squaredNorm(), zero.field.corner[1].squaredNorm(),
                zero.field.corner[2].squaredNorm()});
  return depth >= kNearEdge || depth * zero.determinant > zero.holonomy * most;
}

}  // namespace karcher

#pragma once

#include "rcm/field_blend.h"

namespace karcher {

/// The field is not continuous across edges: near an edge two cells may each have a zero, or
/// neither of them. Where both have one, the zero that lies deeper inside its cell counts, so that
/// a center does not depend on the cell that the search met first.
///
/// `zero` is the blend's zero in `cell` and lies inside it. Returns the deepest of it and the zeros
/// around it. Where `isTheOnlyZero` holds, which is usual and quickly told, that is `zero` itself.
SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int cell, const CellZero& zero);

/// A zero whose weights are no smaller than this is the only one near by: the field's discontinuity
/// moves a zero by a smaller part of an edge (or makes the curve jump, which curves/trace/bridge.h
/// finds).
inline constexpr double kNearEdge = 0.1;

/// Whether no face beside an edge can have another zero where the blend is that of `zero` and the
/// zero so far inside the face.
inline bool isTheOnlyZero(const CellZero& zero, double depth) {
  // Seen from the side of a zero, the values at an edge's ends make an angle of less than pi. Seen
  // from the other face they are turned by `holonomy` at most.
  const double most =
      std::max({zero.field.corner[0].squaredNorm(), zero.field.corner[1].squaredNorm(),
                zero.field.corner[2].squaredNorm()});
  return depth >= kNearEdge || depth * zero.determinant > zero.holonomy * most;
}

}  // namespace karcher

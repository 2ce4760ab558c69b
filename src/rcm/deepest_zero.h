#pragma once

#include "rcm/field_blend.h"

namespace karcher {

/// The field jumps a little from face to face: near an edge two cells may each have a zero of their
/// own, or neither. Where both have one, the deeper inside its cell counts, so that a center does
/// not depend on the face that the search for it found first.
///
/// `zero`: of the blend in `cell`, inside it. Returns the deepest of it and those around it.
/// With isTheOnlyZero, which is the usual case and quickly told, that is `zero` itself.
SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int cell, const FaceZero& zero);

/// A zero whose weights are no smaller than this is the only one near by: jumps of the field are a
/// smaller part of an edge (or are found as jumps of the curve, curves/bridge.h).
inline constexpr double kNearEdge = 0.1;

/// Whether no face beside an edge can have another zero where the blend is that of `zero` and the
/// zero so far inside the face.
inline bool isTheOnlyZero(const FaceZero& zero, double depth) {
  // Seen from the side of a zero, the values at an edge's ends make an angle of less than pi. Seen
  // from the other face they are turned by `jump` at most.
  const double most =
      std::max({zero.field.corner[0].squaredNorm(), zero.field.corner[1].squaredNorm(),
                zero.field.corner[2].squaredNorm()});
  return depth >= kNearEdge || depth * zero.determinant > zero.jump * most;
}

}  // namespace karcher

#pragma once

#include "rcm/field_blend.h"

namespace karcher {

/// The field jumps a little from face to face: near an edge two faces may each have a zero of their
/// own, or neither. Where both have one, the deeper inside its face counts, so that a center does
/// not depend on the face that the search for it found first.
///
/// `zero`: of the blend in `face`, inside it. Returns the deepest of it and those around it.
SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int face, const FaceZero& zero);

}  // namespace karcher

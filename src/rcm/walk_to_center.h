#pragma once

#include "rcm/field_blend.h"
#include "rcm/search_end.h"

/// The walk to the zero of grad K, which is a center of mass.
namespace karcher {

/// The tolerance of a zero's barycentric weights. The zero counts as inside the face if no weight
/// is below 0 by more than this tolerance.
inline constexpr double kInsideTolerance = 1e-10;

/// Whether grad K vanishes at a point, up to rounding, and the Hessian there is positive definite.
/// A search that starts there ends at once, although a nearby face may hold another zero, deeper
/// inside (deepest_zero.h).
bool isZero(FieldBlend& fields, Weights weights, const SurfacePoint& point);

/// The zero between the two cells at half-edge h, if each cell has its zero beyond h. It is the
/// point of h where the field's component along h vanishes. If this point is an end of h, the
/// result is the zero around this end. The edge must not lie on the boundary.
SearchEnd centerBetween(FieldBlend& fields, Weights weights, int h);

/// Finds the zero of the blended field by walking from face to face. In each face a closed form
/// gives the zero. If the zero lies outside the face, the walk crosses an edge beyond which the
/// zero lies. From a start near the zero the walk visits one or two faces. A zero between faces
/// lies on their common edge or vertex.
SearchEnd walkToCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start);

}  // namespace karcher

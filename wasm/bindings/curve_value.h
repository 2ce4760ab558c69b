#pragma once

#include "bindings/legs.h"
#include "bindings/mesh_handle.h"
#include "curves/refine/refine.h"

namespace karcher::bindings {

CurveKind curveKind(const std::string& name);

/// {points, legs, areDrawn, shape, sampling, field}: the points one after the other, `legs` and
/// `areDrawn` as in legs.h, `shape` {kind, closed, degree, clamped, knots, weights, betas,
/// centripetal, basis} with numbers in Float64Arrays, empty if unused, and `basis` undefined or a
/// function of the number of points and t that returns a Float64Array; `sampling` {samples,
/// tolerance, exact, levels, leastLevels, levelsTolerance}, `field` as for `fieldOptionsFromJs`.
CurveValue curveValueFromJs(const MeshHandle& mesh, const val& value, Legs& legs);

/// {points} with the shape's properties, without the basis.
val toJs(const MeshHandle& mesh, const CurveParts& parts);

}  // namespace karcher::bindings

#pragma once

#include "bindings/legs.h"
#include "bindings/mesh_handle.h"
#include "curves/refine/refine.h"

namespace karcher::bindings {

CurveKind curveKind(const std::string& name);

/// Reads {points, legs, areDrawn, shape, sampling, field}. `points` is a Float64Array with one
/// point after the other; `legs` and `areDrawn` are as in legs.h. `shape` is {kind, closed, degree,
/// clamped, knots, weights, betas, centripetal, basis}; `knots`, `weights` and `betas` are
/// Float64Arrays, empty if unused; `basis` is undefined, or a function that takes the number of
/// points and t and returns a Float64Array. `sampling` is {samples, tolerance, exact, levels,
/// leastLevels, levelsTolerance}, and `field` is an argument for `fieldOptionsFromJs`.
CurveValue curveValueFromJs(const MeshHandle& mesh, const val& value, Legs& legs);

/// An object with `points` and the properties of the shape, without the basis.
val toJs(const MeshHandle& mesh, const CurveParts& parts);

}  // namespace karcher::bindings

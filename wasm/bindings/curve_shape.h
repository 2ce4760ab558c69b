#pragma once

#include "bindings/wire.h"
#include "curves/refine/refine.h"

namespace karcher::bindings {

CurveKind curveKind(const std::string& name);

/// {kind, closed, degree, clamped, knots, weights, betas, centripetal, basis}: the numbers as
/// Float64Arrays, empty where there are none; `basis` a function of the number of points and t that
/// gives a Float64Array, or undefined.
CurveShape curveShapeFromJs(const val& shape);

/// The same without the basis. Weights, betas and a B-spline's knots are given in full.
val toJs(const CurveShape& shape, int points);

/// The same with {points}, and with arrays as they are: empty where there are none.
val toJs(const Numbering& numbering, const CurveParts& parts);

}  // namespace karcher::bindings

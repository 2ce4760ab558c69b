#pragma once

#include <string>

#include "curves/spec/curve_shape.h"

namespace karcher {

/// Every kind, open and closed where it can be, with uneven weights and betas for that many points.
Array<CurveShape> everyShape(int points);

/// "bspline closed degree 3 rule 0"
std::string describe(const CurveShape& shape);

}  // namespace karcher

#pragma once

#include <string>

#include "curves/curve_value.h"

namespace karcher {

/// Every kind, open and closed if possible, with uneven weights and betas for that many points.
Array<CurveShape> everyShape(int points);

/// Options that make each segment one center of mass, even where that is unsafe.
CurveOptions ofLevelZero(const CurveShape& shape, int samples, const FieldOptions& field,
                         double tolerance = 0);

/// "bspline closed degree 3 rule 0"
std::string describe(const CurveShape& shape);

}  // namespace karcher

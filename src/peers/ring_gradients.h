#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The gradient at each vertex, in its frame, of a function with one value a vertex: the
/// area-weighted mean of the constant gradients of the faces around it (Mancinelli, Puppo, Eq. 3 as
/// printed). The engine's own operator averages the faces beyond as well (rcm/gradient_operator.h).
Array<Vec2> ringGradients(const Geometry& geometry, const Array<double>& values);

}  // namespace karcher

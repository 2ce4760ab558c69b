#pragma once

#include "curves/curve.h"

namespace karcher {

/// The largest distance, on a flat mesh, of a curve's samples from the Euclidean curve: the sum of
/// the control points with the weights of the curve of level 0.
double planeDeviation(Surface& surface, const CurveOptions& options,
                      const Array<SurfacePoint>& points);

}  // namespace karcher

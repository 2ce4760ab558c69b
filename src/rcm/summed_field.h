#pragma once

#include "rcm/point_field.h"

namespace karcher {

/// The weighted sum of the fields of any number of points as one field. One solver computes them in
/// turn, in the memory of one field over the whole surface. If the estimator is linear, log vectors
/// and squared distances are summed before it is applied.
///
/// There is one weight for each point. The values are those of the weighted sum of `PointField`s up
/// to rounding. The surface must outlive the field.
ControlField sumOfFields(Surface& surface, const Array<SurfacePoint>& points,
                         const Array<double>& weights, const FieldOptions& options);

}  // namespace karcher

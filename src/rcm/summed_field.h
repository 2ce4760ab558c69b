#pragma once

#include "rcm/point_field.h"

namespace karcher {

/// The weighted sum of the fields of any number of points as one field, by one solver that takes
/// them in turn: in the memory of one field over the whole surface, and in the time of as many.
/// Where the estimator is linear, log vectors and squared distances are summed before it.
///
/// One weight a point. The values are those of the weighted sum of `PointField`s but for rounding.
/// The surface must outlive the field.
ControlField sumOfFields(Surface& surface, const Array<SurfacePoint>& points,
                         const Array<double>& weights, const FieldOptions& options);

}  // namespace karcher

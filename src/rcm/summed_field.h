#pragma once

#include "rcm/point_field.h"

namespace karcher {

/// The weighted sum of the fields of any number of points as one field. One solver computes the
/// fields one after the other, in the memory of one field over the whole surface. A linear
/// estimator is applied to the sums of log vectors and squared distances; any other estimator is
/// applied to each field before the sum. There is one weight for each point. Up to rounding, the
/// values are those of the weighted sum of `PointField`s. The surface must outlive the field.
ControlField sumOfFields(Surface& surface, const Array<SurfacePoint>& points,
                         const Array<double>& weights, const FieldOptions& options);

}  // namespace karcher

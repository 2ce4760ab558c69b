#pragma once

#include "curves/curve_value.h"

/// Which legs of a control polygon stay when its points are changed.
namespace karcher {

/// The legs of a curve of this shape whose point i had the number order[i] among the `points` of
/// before, or is new where that is -1. A leg goes with its two ends as long as they are neighbours,
/// turned round where these have changed places; none goes to two pairs. The others are the
/// shortest; without legs where all are. `legs`: those of before, some.
Array<SurfacePath> keptLegs(const Array<SurfacePath>& legs, int points, const Array<int>& order,
                            const CurveShape& shape);

/// The value with other control points. A leg is kept where both its ends stay: as many points stay
/// by their numbers, of more or fewer those from the first on and from the last back.
CurveValue withPoints(CurveValue value, Array<SurfacePoint> points);

}  // namespace karcher

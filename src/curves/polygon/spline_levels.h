#pragma once

#include "curves/polygon/levels.h"

namespace karcher {

/// Subdivides a B-spline's control polygon `levels` times by a knot in the middle of each span. A
/// new point is the repeated average of its parents, with the weights of the knot insertion. `legs`
/// are those of `refinePolygon`, which it is a part of.
RefinedPolygon refinedSpline(const Geometry& geometry, const CurveShape& shape,
                             Array<WeightedPoint> points, const Array<SurfacePath>& legs,
                             int levels);

}  // namespace karcher

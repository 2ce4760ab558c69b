#pragma once

#include "curves/polygon/leg_average.h"
#include "curves/spec/curve_shape.h"

/// A Catmull-Rom curve as cubic Bezier curves from point to point. The derivative at a point
/// follows Barry and Goldman's pyramid, with log maps along the legs that meet at the point.
namespace karcher {

/// The inner control points of a cubic Bezier curve, as ends of straightest geodesics.
struct BezierHandles {
  SurfacePath after;   ///< the path from the curve's start to the first handle
  SurfacePath before;  ///< the path from the curve's end to the second handle
};

/// Reusable scratch memory of handles.
struct HandleWorkspace {
  Array<double> gaps;
  Array<double> spacings;
  Array<BezierHandles> handles;  ///< the handles of each segment of the curve
};

/// Finds the handles of a curve through points. `legs` are paths from each point to the next, and
/// for a closed curve also from the last to the first. Returns false if a handle would lie beyond
/// the surface's boundary.
bool findHandles(const Geometry& geometry, const CurveShape& shape,
                 const Array<SurfacePoint>& points, const Array<SurfacePath>& legs,
                 HandleWorkspace& workspace);

/// Writes the Bezier polygon of segment j, whose handles must be known. The polygon's middle leg is
/// a path that the function straightens: back along the first handle, then along leg j, and then
/// along the second handle.
void takeBezierPolygon(const Geometry& geometry, const Array<SurfacePoint>& points,
                       const Array<SurfacePath>& legs, int j, StripWorkspace& strip,
                       const HandleWorkspace& workspace, LeggedPolygon& polygon);

}  // namespace karcher

#include "curves/polygon/through_points.h"

#include "curves/spec/curve_layout.h"
#include "intrinsic/straighten.h"
#include "intrinsic/tangent.h"

namespace karcher {
namespace {

/// The derivative at the point between two legs.
Vec2 derivativeAt(const Geometry& geometry, const Array<SurfacePath>& legs,
                  const Array<double>& spacings, int before, int after) {
  const Vec2 onward = logAlong(geometry, legs[after]) / spacings[after];
  const Vec2 back = -logBack(geometry, legs[before]) / spacings[before];
  const double sum = spacings[before] + spacings[after];
  return (spacings[before] * onward + spacings[after] * back) / sum;
}

}  // namespace

bool findHandles(const Geometry& geometry, const CurveShape& shape,
                 const Array<SurfacePoint>& points, const Array<SurfacePath>& legs,
                 HandleWorkspace& workspace) {
  const int count = legs.count();
  workspace.gaps.clear();
  for (const SurfacePath& leg : legs) workspace.gaps.push_back(leg.length());
  Array<double>& spacings = workspace.spacings;
  catmullRomSpacings(workspace.gaps, shape.centripetal, spacings);
  workspace.handles.resize(legs.size());
  bool areOnSurface = true;
  for (int j = 0; j < count; ++j) {
    auto& [after, before] = workspace.handles[j];
    const double length = legs[j].length();
    // The handle is start + derivative / 3.
    if (j == 0 && !shape.closed) {
      takePart(*geometry.mesh, legs[j], 0, length / 3, after);
    } else {
      const int last = (j + count - 1) % count;
      const Vec2 derivative = derivativeAt(geometry, legs, spacings, last, j);
      areOnSurface &= expAlong(geometry, points[j], spacings[j] / 3 * derivative, after);
    }
    // The handle is end - derivative / 3.
    if (j == count - 1 && !shape.closed) {
      takePart(*geometry.mesh, legs[j], length, length * 2 / 3, before);
    } else {
      const Vec2 derivative = derivativeAt(geometry, legs, spacings, j, (j + 1) % count);
      const SurfacePoint& end = points[(j + 1) % points.count()];
      areOnSurface &= expAlong(geometry, end, -spacings[j] / 3 * derivative, before);
    }
  }
  return areOnSurface;
}

void takeBezierPolygon(const Geometry& geometry, const Array<SurfacePoint>& points,
                       const Array<SurfacePath>& legs, int j, StripWorkspace& strip,
                       const HandleWorkspace& workspace, LeggedPolygon& polygon) {
  const TriangleMesh& mesh = *geometry.mesh;
  const auto& [after, before] = workspace.handles[j];
  const SurfacePoint& end = points[(j + 1) % points.count()];
  polygon.points.clear();
  for (const SurfacePoint& point : {points[j], after.end(), before.end(), end}) {
    polygon.points.push_back({point, 1});
  }
  polygon.legs.resize(3);
  polygon.legs[0] = after;
  Chain chain(mesh, polygon.legs[1]);
  chain.appendReversed(after);
  chain.append(legs[j]);
  chain.append(before);
  straighten(geometry, polygon.legs[1], strip);
  polygon.legs[2] = before;
  reverse(polygon.legs[2]);
}

}  // namespace karcher

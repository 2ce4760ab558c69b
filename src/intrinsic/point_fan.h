#pragma once

#include "intrinsic/geometry.h"

namespace karcher {

/// The angles around a point, unscaled and counterclockwise from a first direction.
struct PointFan {
  /// The part of the fan in a face, and the angle in the face's frame at which it begins.
  struct Corner {
    int face;
    double begin;
    double end;
    double inFrame;
    Vec2 middle;  ///< the point in the face's frame
  };
  Array<Corner> corners;
  double total = 0;
  bool isRound = true;  ///< whether the fan goes all around; false on the boundary of the surface
};

PointFan fanAt(const Geometry& geometry, const SurfacePoint& point);

/// The angle, in a point's fan, of another point that shares a face with it. Throws Error
/// kBadArgument if they share none.
double angleTowards(const Geometry& geometry, const PointFan& fan, const SurfacePoint& point,
                    const SurfacePoint& towards);

}  // namespace karcher

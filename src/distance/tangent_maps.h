#pragma once

#include "distance/find_path.h"
#include "intrinsic/tangent.h"

/// Log and exp maps of points with directions, by parallel transport. The paths of the log map are
/// the fast ones (find_path.h): locally shortest, and the same in both directions. The exp map
/// follows straightest geodesics. The maps are inverse to each other where the log map, given the
/// end of such a geodesic, finds this geodesic. Vectors and directions are those of tangent planes
/// (tangent.h). A direction of length 0 stands for no direction.
namespace karcher {

/// The path of the log map. Throws Error kUnreachable if the points lie on different components.
SurfacePath pathBetween(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                        FindPathWorkspace& workspace);

/// A point and a direction there, as seen in the tangent plane of another point.
struct LogMapped {
  Vec2 vector = Vec2::Zero();     ///< the log vector, as long as the path
  Vec2 direction = Vec2::Zero();  ///< the direction at the point, transported along the path
};

LogMapped logMap(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& point,
                 const Vec2& direction, FindPathWorkspace& workspace);

struct ExpMapped {
  SurfacePoint point;
  Vec2 direction = Vec2::Zero();
  double remaining = 0;  ///< the rest of the vector's length if the path met the boundary
};

ExpMapped expMap(const Geometry& geometry, const SurfacePoint& from, const Vec2& vector,
                 const Vec2& direction);

/// Mirrors a point and a direction in a geodesic line. The path leads to the line's nearest point,
/// is reflected there and continues by the same length. At the nearest point the path is
/// perpendicular to the line, up to rounding. The search for this point begins near the best of a
/// dozen points of the line. Throws Error kUnreachable as above, and kBadArgument if the line has
/// no length, or if its nearest point is an end at which the path is not perpendicular to the line.
ExpMapped mirrored(const Geometry& geometry, const SurfacePath& line, const SurfacePoint& point,
                   const Vec2& direction, FindPathWorkspace& workspace);

}  // namespace karcher

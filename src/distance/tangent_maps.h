#pragma once

#include "distance/find_path.h"
#include "intrinsic/tangent.h"

/// Log and exp maps of points with directions, which are carried along by parallel transport. The
/// paths of the log map are the fast ones (find_path.h): locally shortest, and the same both ways.
/// Each map is the other's inverse wherever the straightest geodesic of the exp map is the path
/// that is found to its end.
///
/// Vectors and directions are those of tangent planes (tangent.h); a direction of length 0 is none.
namespace karcher {

/// The path of the maps. Throws Error kUnreachable where none leads to the point.
SurfacePath pathBetween(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                        FindPathWorkspace& workspace);

/// Another point and a direction there, in the tangent plane of the point that they are seen from.
struct LogMapped {
  Vec2 vector = Vec2::Zero();     ///< as long as the path
  Vec2 direction = Vec2::Zero();  ///< at the other point, carried along the path
};

LogMapped logMap(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& point,
                 const Vec2& direction, FindPathWorkspace& workspace);

struct ExpMapped {
  SurfacePoint point;
  Vec2 direction = Vec2::Zero();
  double remaining = 0;  ///< of the vector's length, where the boundary was met
};

ExpMapped expMap(const Geometry& geometry, const SurfacePoint& from, const Vec2& vector,
                 const Vec2& direction);

/// Mirrors a point and a direction in a geodesic line. The path leads to the line's nearest point,
/// is reflected there and goes on by the same length. The nearest point is searched beside the
/// nearest of a dozen points of the line; there the path is perpendicular to the line, to rounding.
/// Throws Error kUnreachable as above, and kBadArgument if the line has no length, or if its
/// nearest point is an end, from which no perpendicular leads to the point.
ExpMapped mirrored(const Geometry& geometry, const SurfacePath& line, const SurfacePoint& point,
                   const Vec2& direction, FindPathWorkspace& workspace);

}  // namespace karcher

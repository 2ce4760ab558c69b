#pragma once

#include "distance/find_path.h"
#include "intrinsic/tangent.h"

/// Log and exp maps of points with directions at them, which are carried along by parallel
/// transport. The paths of the log map are the fast ones (find_path.h): locally shortest, and the
/// same there and back. So where the straightest geodesic of the exp map is the path that is found
/// to its end, each map is the other's inverse.
///
/// Vectors and directions are those of tangent planes (tangent.h); a direction of length 0 is none.
namespace karcher {

/// The path of the maps. Throws Error kUnreachable where none leads to the point.
SurfacePath pathBetween(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to,
                        FindPathWorkspace& workspace);

/// What lies at another point, in the tangent plane of the point that it is seen from.
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

/// A point with a direction mirrored in a geodesic: along the path to the line's nearest point, and
/// on from there as it is reflected, by the same length. The nearest of a dozen points of the line
/// tells where its nearest is looked for: there the path is perpendicular to the line, to rounding.
/// Throws Error kUnreachable as above, and kBadArgument for a line without length and where the
/// line's nearest point is an end of it, from which no perpendicular leads to the point.
ExpMapped mirrored(const Geometry& geometry, const SurfacePath& line, const SurfacePoint& point,
                   const Vec2& direction, FindPathWorkspace& workspace);

}  // namespace karcher

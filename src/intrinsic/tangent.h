#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/straightest.h"
#include "intrinsic/surface_path.h"

/// Log and exp maps at a point of the surface, and parallel transport, along given paths.
///
/// The tangent plane of a point in a face or on an edge is that of its face, point.face; that of a
/// vertex is its rescaled frame (geometry.h), in which opposite directions have as much angle on
/// one side as on the other.
namespace karcher {

/// The vector of a path at its start: the direction in which it leaves, as long as the path.
Vec2 logAlong(const Geometry& geometry, const SurfacePath& path);

/// The same of the reversed path: the vector back along a path at its end.
Vec2 logBack(const Geometry& geometry, const SurfacePath& path);

/// The straightest geodesic from a point along a vector of its tangent plane. Where it meets the
/// boundary it ends there.
SurfacePath expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector);

/// The same, written to a path whose memory is used again. Returns whether it has the vector's
/// length.
bool expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector,
              SurfacePath& path);

/// A vector of the tangent plane at a path's start carried to its end: along a locally shortest
/// path it keeps its angle with the path, but where the path turns round a vertex, which is
/// measured in the vertex's frame.
Vec2 transportAlong(const Geometry& geometry, const SurfacePath& path, const Vec2& vector);

/// A vector of the tangent plane at a point as a vector in space, in the plane of the point's face,
/// and the projection of one: at a vertex turned by the frames of its corners (vertexToFace).
Vec3 tangentToSpace(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector);
Vec2 tangentFromSpace(const Geometry& geometry, const SurfacePoint& point, const Vec3& vector);

}  // namespace karcher

#pragma once

#include "intrinsic/geometry.h"
#include "intrinsic/straightest.h"
#include "intrinsic/surface_path.h"

/// Log and exp maps at a point of the surface, and parallel transport along given paths.
///
/// At a point in a face or on an edge, the tangent plane is the plane of the point's face,
/// `point.face`. At a vertex, it is the vertex's rescaled frame (geometry.h), in which opposite
/// directions have equal angles on both sides.
namespace karcher {

/// The log vector of a path at its start: its initial direction, scaled to its length.
Vec2 logAlong(const Geometry& geometry, const SurfacePath& path);

/// The log vector of the reversed path, at the path's end.
Vec2 logBack(const Geometry& geometry, const SurfacePath& path);

/// The unscaled direction of a vector in the frame of a vertex. At the boundary it is from 0 to the
/// total angle: for a vector that points off the surface, the direction of the nearer side.
double directionAt(const Geometry& geometry, int vertex, const Vec2& vector);

/// The straightest geodesic from a point along a vector of its tangent plane. It ends where it
/// meets the boundary.
SurfacePath expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector);

/// The same geodesic, written to an existing path. Returns whether it has the vector's length.
bool expAlong(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector,
              SurfacePath& path);

/// Parallel transport of a vector along a path, from the tangent plane at its start to that at its
/// end. The vector keeps its angle with the path. Where the path turns around a vertex, this angle
/// changes by the turn, measured in the vertex's frame.
Vec2 transportAlong(const Geometry& geometry, const SurfacePath& path, const Vec2& vector);

/// Converts a vector of the tangent plane at a point to a vector in space, in the plane of the
/// point's face, and back by projection. At a vertex, the vector is also rotated between the frames
/// of the vertex and the face (vertexToFace).
Vec3 tangentToSpace(const Geometry& geometry, const SurfacePoint& point, const Vec2& vector);
Vec2 tangentFromSpace(const Geometry& geometry, const SurfacePoint& point, const Vec3& vector);

}  // namespace karcher

#pragma once

#include <functional>

#include "mesh/surface_point.h"
#include "peers/heat_operators.h"

/// The vector heat method: N. Sharp, Y. Soliman, K. Crane, "The Vector Heat Method", ACM
/// Transactions on Graphics 38 (2019). Short-time heat flow with the connection Laplacian
/// transports vectors along shortest paths. Heat that starts at a vertex as all outward directions
/// at once gives the directions in which shortest paths arrive (the radial field). Heat that starts
/// as the vertex's x axis transports this axis. The angle between these two directions is the angle
/// of the logarithm. The logarithm's length is the potential whose gradient is nearest to the
/// radial field.
namespace karcher {

/// The logarithm of each vertex; (kInfinity, 0) for a vertex on another component, or so far away
/// that the heat underflows (more than 600 mean edges).
using LogMap = Array<Vec2>;

inline Vec2 noLogarithm() { return {kInfinity, 0}; }

/// The log map from a vertex, in the vertex's rescaled frame (section 8.2 of the paper; the start
/// of the radial field as in its appendix A). It solves two systems of vectors and one of scalars.
LogMap vectorHeatLogMap(const HeatOperators& operators, int vertex);

/// A function that returns the log map from a vertex, such as vectorHeatLogMap with fixed
/// operators.
using LogMapFromVertex = std::function<LogMap(int vertex)>;

/// The rotation (a unit vector, see `rotate`) from the frame of corner k of a point's face into the
/// frame of the face. It keeps the direction of the half-edge that leaves the corner. For a point
/// on an edge, it keeps the direction of this edge, so that both faces at the edge agree. Since a
/// vertex's frame is rescaled, other directions turn by a little more or less.
Vec2 cornerRotation(const Geometry& geometry, const SurfacePoint& point, int k);

}  // namespace karcher

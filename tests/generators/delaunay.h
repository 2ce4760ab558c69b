#pragma once

#include "mesh/types.h"

/// Triangulations for generators, by insertion of one point after another and Lawson's edge flips
/// (C. Lawson, "Software for C1 surface interpolation", 1977). Plain doubles suffice for points in
/// general position, or for nearly cocircular ones whose diagonal does not matter.
namespace karcher {

/// The Delaunay triangulation of points in the plane, counterclockwise; it covers their convex
/// hull.
Array<Triangle> delaunay(const Array<Vec2>& points);

/// The convex hull of points on the unit sphere, which must not all lie in one hemisphere: their
/// Delaunay triangulation on the sphere. Counterclockwise seen from outside.
Array<Triangle> sphereHull(const Array<Vec3>& points);

}  // namespace karcher

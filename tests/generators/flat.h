#pragma once

#include "mesh/triangle_soup.h"

/// Surfaces that unroll onto the plane: prisms and pyramids of many sides. Their side lines are
/// edges of the mesh, so that the mesh itself is flat except at a cone's apex.
namespace karcher {

struct FlatCylinder {
  TriangleSoup soup;
  Array<Vec2> unrolled;  ///< the place of each vertex: x along the circumference, y along the axis
  double circumference = 0;
  double height = 0;
};

/// `sides` planes around a cylinder of radius 1, open at both ends, irregularly triangulated.
FlatCylinder flatCylinder(int sides, double height, uint64_t seed);

struct FlatCone {
  TriangleSoup soup;
  Array<Vec2> unrolled;  ///< for each vertex: distance from the apex, angle in [0, totalAngle)
  double totalAngle = 0;
};

/// `sides` planes around an apex (vertex 0) of total angle `totalAngle` < 2 pi; side lines of
/// length 1, open at the bottom, irregularly triangulated.
FlatCone flatCone(int sides, double totalAngle, uint64_t seed);

/// Distance between two unrolled points.
double cylinderDistance(const FlatCylinder& cylinder, const Vec2& a, const Vec2& b);
double coneDistance(const FlatCone& cone, const Vec2& a, const Vec2& b);

}  // namespace karcher

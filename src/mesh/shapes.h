#pragma once

#include "mesh/triangle_soup.h"

/// Built-in surfaces. Each is manifold and about 1 in size, and its faces are oriented outwards.
namespace karcher {

enum class Shape {
  kSphere,     ///< radius 1, an icosahedron's faces divided evenly
  kTorus,      ///< radii 1 and 0.4, nearly equilateral triangles
  kKnot,       ///< a tube along a trefoil knot
  kGenus3,     ///< three rings in a row, smoothly joined
  kOpenSheet,  ///< a rectangle that waves, with a boundary
};

inline constexpr Shape kShapes[] = {Shape::kSphere, Shape::kTorus, Shape::kKnot, Shape::kGenus3,
                                    Shape::kOpenSheet};

/// The name of a shape in the interface, such as "genus3".
const char* shapeName(Shape shape);

inline constexpr int kFewestShapeTriangles = 500;
inline constexpr int kMostShapeTriangles = 1'000'000;

/// A shape of about `triangles` triangles. Not every count is possible: the actual count is within
/// 5 % of the given number, or within 12 % below 2,000; for kGenus3 it is between 2/3 and 3/2 of
/// the given number. Throws Error kBadArgument for less than 500 or more than 1,000,000.
TriangleSoup makeShape(Shape shape, int triangles);

/// The unit sphere of 20 frequency^2 triangles.
TriangleSoup icosphere(int frequency);

/// The torus about the z axis. Its circle of centers has radius 1, and its tube has radius 0.4.
/// `conformalTorus` maps the plane to the torus, conformally and with the periods 2 pi and
/// kTorusPeriod. x is the longitude; y = 0 is the outer equator.
inline constexpr double kTorusMajor = 1;
inline constexpr double kTorusMinor = 0.4;
extern const double kTorusPeriod;
Vec3 conformalTorus(const Vec2& x);

}  // namespace karcher

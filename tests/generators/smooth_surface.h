#pragma once

#include <functional>

#include "mesh/types.h"

/// Smooth surfaces with their exponential and logarithmic maps, as a reference for their meshes.
/// Points and tangent vectors are in space.
namespace karcher {

struct SmoothSurface {
  /// The point of the surface nearest to x.
  std::function<Vec3(const Vec3& x)> project;
  /// The unit normal at p.
  std::function<Vec3(const Vec3& p)> normal;
  /// The end of the geodesic that leaves p along v, of length |v|.
  std::function<Vec3(const Vec3& p, const Vec3& v)> exp;
  /// The tangent vector at p that leads to q along the shortest geodesic, which must be unique.
  std::function<Vec3(const Vec3& p, const Vec3& q)> log;
};

/// The sphere of radius 1 about the origin, in closed form.
SmoothSurface smoothSphere();

/// The torus about the z axis with radii `major` > `minor`. The Runge-Kutta method of order 4 gives
/// geodesics, and Newton's method the logarithm, to 1e-10 over lengths up to `minor`.
SmoothSurface smoothTorus(double major, double minor);

/// The ellipsoid about the origin with these half axes, and the saddle z = height (x^2 - y^2).
/// The Runge-Kutta method of order 4 gives geodesics, and Newton's method the logarithm, to 1e-10
/// over lengths up to 1 of surfaces about as large as those here. `project` goes along the
/// gradient: for points as near as those of a mesh it finds the nearest point, up to the fourth
/// power of the edge.
SmoothSurface smoothEllipsoid(const Vec3& halfAxes);
SmoothSurface smoothSaddle(double height);

/// The center of mass of weighted points on a smooth surface, from a start near it: the fixed point
/// of p <- exp_p(sum_i w_i log_p(p_i)), to a step of 1e-12. Throws std::runtime_error if 200 steps
/// do not suffice.
Vec3 smoothCenter(const SmoothSurface& surface, const Array<Vec3>& points,
                  const Array<double>& weights, const Vec3& start);

}  // namespace karcher

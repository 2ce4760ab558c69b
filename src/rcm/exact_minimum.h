#pragma once

#include "intrinsic/straightest.h"
#include "rcm/field_blend.h"

/// Whether a center is a minimum of the energy K(p) = sum_i w_i d(p, p_i)^2 by exact distances.
///
/// A zero of blended fields is a minimum of K where the surface is smooth. Where it is rough or
/// creased K has many shallow minima, which estimates at vertices smooth away, and a zero may lie
/// beside all of them. So K is compared on circles round the zero, and where a point of them is
/// lower the search goes on from there.
///
/// Exact distances from a point are found for a few faces only, and only by windows that can still
/// get there (ExactDistance::aimAt): far fewer than those of a whole field.
namespace karcher {

/// The radius of the circle that `converged` is told by, in mean edges, and by how much of a square
/// mean edge K may be lower there.
inline constexpr double kCheckedRadius = 0.3;
inline constexpr double kLowerBy = 1e-3;

/// K by exact distances, of points that are all on one component. Values of weight 0 are not read.
class ExactEnergy {
 public:
  /// All must outlive the object.
  ExactEnergy(const Geometry& geometry, const Array<SurfacePoint>& points, Weights weights);

  /// K at places that lie within `radius` of `center`, along the surface. `guesses`, one a point,
  /// are distances of the center by some other way: the nearer to the truth, the faster.
  Array<double> at(const SurfacePoint& center, double radius, const Array<SurfacePoint>& places);

  /// Distances of the last center, or what a caller takes for them; one a point.
  Array<double> guesses;

 private:
  const Geometry& geometry_;
  const Array<SurfacePoint>& points_;
  Weights weights_;
};

/// The direction in which circles round a point begin, in the frame of its face or vertex: one that
/// the shape of the mesh gives, so that a circle has the same points whatever the numbers of the
/// faces are.
double circleStart(const Geometry& geometry, const SurfacePoint& center);

/// The `count` radii of the circle round a point, straightest geodesics, in equal parts of the
/// total angle, half a part beside `circleStart` first; shorter ones where the boundary is in the
/// way.
Array<StraightestPath> circleRadii(const Geometry& geometry, const SurfacePoint& center,
                                   double radius, int count);
/// Where they end.
Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count);

struct ExactMinimum {
  SurfacePoint point;
  /// Whether no point on a circle of kCheckedRadius mean edges round it is lower by more than
  /// kLowerBy square mean edges.
  bool isLowest = true;
  int moves = 0;
};

/// `start` itself where it is lowest so; else what is found from there, by a bounded number of
/// moves to the lowest point on circles.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start);

}  // namespace karcher

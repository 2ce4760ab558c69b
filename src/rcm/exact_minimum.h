#pragma once

#include "intrinsic/straightest.h"
#include "rcm/field_blend.h"
#include "rcm/one_source_energy.h"

/// Whether a center is a minimum of the energy K(p) = sum_i w_i d(p, p_i)^2 by exact distances.
///
/// On a smooth surface a zero of blended fields is a minimum of K. On a rough or creased one K has
/// many shallow minima. Estimates at vertices smooth them away, and a zero may lie beside all of
/// them. So K is compared on circles about the zero. If a point of a circle is lower, the search
/// goes on from there.
///
/// Exact distances are needed in a few faces only. They are found by the windows that can still
/// reach these faces (WindowDistance::aimAt), far fewer than those of a whole field.
namespace karcher {

/// A center is `converged` if K is nowhere lower by more than kLowerBy squared mean edges on the
/// circle about it whose radius is kCheckedRadius mean edges.
inline constexpr double kCheckedRadius = 0.3;
inline constexpr double kLowerBy = 1e-3;

/// K by exact distances, of points on one component. Points of weight 0 are left out.
class ExactEnergy {
 public:
  /// All must outlive the object.
  ExactEnergy(const Geometry& geometry, const Array<SurfacePoint>& points, Weights weights);

  /// K at places that lie within `radius` of `center`, along the surface. It starts from `guesses`:
  /// the better they are, the faster it is.
  Array<double> at(const SurfacePoint& center, double radius, const Array<SurfacePoint>& places);

  /// Per point its distance from the last center, or a caller's estimate of it.
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

/// The radius of the circle round a point, a straightest geodesic, that lies at this part of the
/// total angle from `circleStart`, 0 to 1; shorter where the boundary is in the way.
StraightestPath circleRadius(const Geometry& geometry, const SurfacePoint& center, double radius,
                             double part);

/// The ends of `count` radii, in equal parts of the total angle, half a part beside `circleStart`
/// first.
Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count);

struct ExactMinimum {
  SurfacePoint point;
  double energy = 0;
  /// Whether no point on a circle of kCheckedRadius mean edges round it is lower by more than
  /// kLowerBy square mean edges.
  bool isLowest = true;
  int moves = 0;
};

/// `start` itself where it is lowest so; else what is found from there, by a bounded number of
/// moves to the lowest place that was compared. Of few points those places are many, as their
/// distances are found for all places at once.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start);

/// The same for many points, whose distances are found for one place after another. So few places
/// of a circle are compared: the energy of many points is smooth, but for creases that are small
/// beside it, and the quadratic that fits these places tells where it is lower.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactOneSourceEnergy& energy,
                              const SurfacePoint& start);

}  // namespace karcher

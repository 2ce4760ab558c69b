#pragma once

#include "intrinsic/straightest.h"
#include "rcm/field_blend.h"
#include "rcm/one_source_energy.h"

/// Minima of the energy K(p) = sum_i w_i d(p, p_i)^2 by exact distances, near centers of mass.
///
/// On a smooth surface a zero of blended fields is a minimum of K. On a rough or creased surface K
/// has many shallow minima. The estimates at vertices smooth these minima away, so that a zero may
/// lie at none of them. So the search compares K on circles about the zero, and moves to the lowest
/// place if K is lower there.
///
/// Only a few faces need exact distances. The windows that can reach these faces
/// (WindowDistance::aimAt) are far fewer than the windows of a whole field.
namespace karcher {

/// The radius, in mean edges, of the checked circle about a center. On the circle of a `converged`
/// center, K is nowhere lower than at the center by more than kLowerBy square mean edges.
inline constexpr double kCheckedRadius = 0.3;
inline constexpr double kLowerBy = 1e-3;

/// K by exact distances, for points on one component. It omits points of weight 0.
class ExactEnergy {
 public:
  /// The arguments must outlive the object.
  ExactEnergy(const Geometry& geometry, const Array<SurfacePoint>& points, Weights weights);

  /// K at places that lie within `radius` of `center` along the surface. The search starts from
  /// `guesses`; better guesses make it faster.
  Array<double> at(const SurfacePoint& center, double radius, const Array<SurfacePoint>& places);

  /// The distance of each point from the last center, or a caller's estimate of it.
  Array<double> guesses;

 private:
  const Geometry& geometry_;
  const Array<SurfacePoint>& points_;
  Weights weights_;
};

/// A radius of a circle around a point: a straightest geodesic. Its angle from the circle's start
/// is the fraction `part`, from 0 to 1, of the total angle. The shape of the mesh determines the
/// start, so that a circle's points do not depend on the numbering of the faces. The geodesic ends
/// early if it meets the boundary.
StraightestPath circleRadius(const Geometry& geometry, const SurfacePoint& center, double radius,
                             double part);

/// The ends of `count` radii at equal angles from each other. The first radius is half of this
/// angle away from the circle's start.
Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count);

struct ExactMinimum {
  SurfacePoint point;
  double energy = 0;
  /// Whether the check succeeded. It compares K at the result with K on the circle of
  /// kCheckedRadius mean edges around the result. It fails if K is lower anywhere on the circle by
  /// more than kLowerBy, in squared mean edges.
  bool isLowest = true;
  int moves = 0;
};

/// Moves from `start` to the lowest compared place, again and again, until no place is lower by
/// more than a quarter of kLowerBy. The number of moves is bounded. For few points, a comparison
/// has many places, since one search from each point gives its distances to all places.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start);

/// The same for many points. Each place needs a search of its own, so that a comparison has only a
/// few places on a circle. The energy of many points is smooth except for small creases, so that
/// the minimum of a quadratic fit to these places is near the energy's minimum.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactOneSourceEnergy& energy,
                              const SurfacePoint& start);

}  // namespace karcher

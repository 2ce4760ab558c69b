#pragma once

#include "intrinsic/straightest.h"
#include "rcm/field_blend.h"
#include "rcm/one_source_energy.h"

/// Minima of the energy K(p) = sum_i w_i d(p, p_i)^2 by exact distances, near centers of mass.
///
/// On a smooth surface a zero of blended fields is a minimum of K. On a rough or creased one K has
/// many shallow minima. Estimates at vertices smooth them away, so that a zero may lie beside all
/// of them. So the search compares K on circles about the zero, and continues from a point of a
/// circle that is lower.
///
/// Only a few faces need exact distances. The windows that can reach these faces
/// (WindowDistance::aimAt) give them; they are far fewer than those of a whole field.
namespace karcher {

/// The radius, in mean edges, of the circle about a `converged` center on which K is nowhere lower
/// by more than kLowerBy squared mean edges.
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

/// The radius of a circle around a point: a straightest geodesic at this part, 0 to 1, of the total
/// angle from the circle's start. The shape of the mesh determines the start, so that a circle's
/// points do not depend on the numbers of the faces. The geodesic is shorter if it meets the
/// boundary.
StraightestPath circleRadius(const Geometry& geometry, const SurfacePoint& center, double radius,
                             double part);

/// The ends of `count` radii at equal parts of the total angle. The first lies half a part from the
/// circle's start.
Array<SurfacePoint> circleAround(const Geometry& geometry, const SurfacePoint& center,
                                 double radius, int count);

struct ExactMinimum {
  SurfacePoint point;
  double energy = 0;
  /// Whether no point on the circle of kCheckedRadius mean edges around the result is lower by more
  /// than kLowerBy square mean edges.
  bool isLowest = true;
  int moves = 0;
};

/// Returns `start` itself if it is lowest in this sense, else the result of a bounded number of
/// moves to the lowest compared place. With few points a comparison is of many places, since one
/// search from each point gives its distances to all of them.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactEnergy& energy,
                              const SurfacePoint& start);

/// The same for many points. A place needs a search of its own, so a comparison is of few places of
/// a circle. The energy of many points is smooth except for small creases, and a quadratic fit to
/// these places finds its minimum.
ExactMinimum exactMinimumNear(const Geometry& geometry, ExactOneSourceEnergy& energy,
                              const SurfacePoint& start);

}  // namespace karcher

#pragma once

#include "rcm/exact_minimum.h"
#include "rcm/one_source_energy.h"

namespace karcher {

/// An energy at a center and on the circle that decides whether it is `converged`
/// (exact_minimum.h). The energy's values and slopes at some places of the circle are interpolated
/// by a trigonometric polynomial. The polynomial's first harmonics give a quadratic.
///
/// The energy of many points has as many small creases: along each the shortest path to one point
/// changes sides. The circle shows what the creases sum to; the gradient at the center does not.
class EnergyRing {
 public:
  /// Compares every fourth of `count` places; `count` is a multiple of 4. `here` is the energy at
  /// the center. The geometry and the energy must outlive the object.
  EnergyRing(const Geometry& geometry, const SurfacePoint& center, double here, int count,
             ExactOneSourceEnergy& energy);

  /// Compares the places half-way between those compared so far, if any are left.
  void refine();
  bool isRefined() const { return step_ == 1; }
  /// The polynomial's error at the places that were compared last.
  double error() const { return error_; }

  /// Compares two points on either side of the lowest place, a third and two thirds of the way to
  /// the next one. A lower one replaces the lowest place. The polynomial stays.
  void lookBesideLowest();

  /// The number of the place where the energy is lowest, of those that were compared.
  int lowest() const;
  const SurfacePoint& place(int k) const { return places_[k]; }
  double value(int k) const { return values_[k]; }

  /// The unit vector, in the frame of the center's face, along which the polynomial is lowest, and
  /// its value there: `here` where the boundary cuts the circle off, of which it tells nothing.
  const Vec2& lowestDirection() const { return lowestDirection_; }
  double least() const { return isWhole_ ? least_ : here_; }

  /// To the minimum of the quadratic, in the frame of the center's face: 0 where the circle is not
  /// whole, and no longer than a few radii. Where the quadratic has no minimum or a far one, it is
  /// taken for one that rises by `leastBowl` at least from its minimum to a circle of this radius.
  Vec2 wayToMinimum(double leastBowl) const;

  /// By how much the quadratic is lower at the end of a way.
  double gainOf(const Vec2& way) const;

 private:
  void compare(int first, int step);
  void fit();
  double angleOf(int k) const;
  double polynomialAt(double angle) const;

  const Geometry& geometry_;
  SurfacePoint center_;
  double here_;
  ExactOneSourceEnergy& energy_;
  double radius_;
  double start_;  ///< the direction in which the circle begins
  int step_ = 4;  ///< from a place that was compared to the next
  double error_ = kInfinity;
  Array<SurfacePoint> places_;  ///< of the values, kInfinity where none was compared
  Array<double> values_;
  Array<double> slopes_;  ///< over the angle
  bool isWhole_ = true;
  Vec2 lowestDirection_ = Vec2::Zero();
  double least_ = kInfinity;
  double mean_ = 0;             ///< of the polynomial
  Vec2 first_ = Vec2::Zero();   ///< its coefficients of cosine and sine of the angle
  Vec2 second_ = Vec2::Zero();  ///< and of twice the angle
};

}  // namespace karcher

#pragma once

#include "rcm/exact_minimum.h"
#include "rcm/one_source_energy.h"

namespace karcher {

/// An energy at a center and on the circle that `converged` is told by (exact_minimum.h), and what
/// values and slopes at some places of the circle tell of it between them: the trigonometric
/// polynomial through them, and a quadratic with its first harmonics.
///
/// The energy of many points has as many small creases, where shortest paths to one of them change
/// sides. A circle sees what they sum to; the gradient at the center sees none.
class EnergyRing {
 public:
  /// Compares every fourth of `count` places, which four divides. `here` is the energy at the
  /// center. The geometry and the energy must outlive the object.
  EnergyRing(const Geometry& geometry, const SurfacePoint& center, double here, int count,
             ExactOneSourceEnergy& energy);

  /// Compares the places half-way between those that were compared, too, if any are left.
  void refine();
  bool isRefined() const { return step_ == 1; }
  /// How far the polynomial was off at the places that were compared last.
  double error() const { return error_; }

  /// Compares two points on either side of the lowest place, in thirds of the way to the next, and
  /// puts a lower one in its place. The polynomial stays.
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

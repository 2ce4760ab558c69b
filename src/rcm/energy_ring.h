#pragma once

#include <functional>

#include "intrinsic/geometry.h"
#include "rcm/exact_minimum.h"

namespace karcher {

/// A smooth energy at a center and on the circle that `converged` is told by (exact_minimum.h), and
/// what these values tell of it between them: its harmonics up to the second order, and the
/// quadratic through them.
///
/// The energy of many points has as many small creases, where shortest paths to one of them change
/// sides. A circle sees what they sum to; the gradient at a point sees none.
class EnergyRing {
 public:
  SurfacePoint center;
  double here = 0;             ///< at the center
  Array<SurfacePoint> places;  ///< of the values on the circle
  Array<double> values;
  /// The circle is round: no boundary cuts it off. Else there are no harmonics.
  bool isWhole = true;
  double mean = 0;             ///< of the values
  Vec2 first = Vec2::Zero();   ///< the coefficients of cosine and sine of the angle
  Vec2 second = Vec2::Zero();  ///< and of twice the angle

  /// The direction, a unit vector, in which the harmonics are lowest, and their value there.
  Vec2 lowestOfHarmonics() const;
  double leastOfHarmonics() const { return isWhole ? harmonicsAt(lowestOfHarmonics()) : here; }

  /// To the minimum of the quadratic, in the frame of the center's face: 0 where the circle is not
  /// whole, and no longer than a few radii. Where the quadratic has no minimum or a far one, it is
  /// taken for one that rises by `leastBowl` at least from its minimum to a circle of this radius.
  Vec2 wayToMinimum(double radius, double leastBowl) const;

  /// By how much the quadratic is lower at a place, in radii from the center.
  double gainOf(const Vec2& way) const;

  /// The number of the place where the energy is lowest.
  int lowest() const;

 private:
  double harmonicsAt(const Vec2& direction) const {
    return mean + first.dot(direction) + second.dot(rotate(direction, direction));
  }
};

/// `here` is the energy at the center. At least 5 places determine the harmonics.
EnergyRing energyRing(const Geometry& geometry, const SurfacePoint& center, double here, int count,
                      const std::function<double(const SurfacePoint&)>& energyAt);

/// Compares two points on either side of the lowest, in thirds of the way to the next, and puts a
/// lower one in its place. The harmonics stay.
void lookBesideLowest(const Geometry& geometry, EnergyRing& ring,
                      const std::function<double(const SurfacePoint&)>& energyAt);

}  // namespace karcher

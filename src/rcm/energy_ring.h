#pragma once

#include <functional>
#include <optional>

#include "intrinsic/geometry.h"
#include "rcm/exact_minimum.h"

namespace karcher {

/// A smooth energy at a center and on the circle that `converged` is told by (exact_minimum.h), and
/// what these values tell of it between them: its harmonics up to the second order, and the
/// quadratic through them.
///
/// The energy of many points has as many small creases, where shortest paths to one of them change
/// sides. A circle sees what they sum to; the gradient at a point sees none.
struct EnergyRing {
  /// One more than what determines the harmonics.
  static constexpr int kCount = 6;

  SurfacePoint center;
  double here = 0;             ///< at the center
  Array<SurfacePoint> places;  ///< of kCount values on the circle
  Array<double> values;
  /// The circle is round: no boundary cuts it off. Else there are no harmonics.
  bool isWhole = true;
  double mean = 0;  ///< of the values
  Vec2 first = Vec2::Zero();   ///< the coefficients of cosine and sine of the angle
  Vec2 second = Vec2::Zero();  ///< and of twice the angle

  /// The lowest on the circle, of values and harmonics.
  double least() const;

  /// To the minimum of the quadratic, in the frame of the center's face; none where it has none
  /// within the circle.
  std::optional<Vec2> wayToMinimum(double radius) const;

  /// The number of the place where the energy is lowest.
  int lowest() const;
};

EnergyRing energyRing(const Geometry& geometry, const SurfacePoint& center,
                      const std::function<double(const SurfacePoint&)>& energyAt);

}  // namespace karcher

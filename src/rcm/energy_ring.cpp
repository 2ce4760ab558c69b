#include "rcm/energy_ring.h"

#include <algorithm>

#include "distance/window.h"

namespace karcher {

double EnergyRing::least() const {
  double value = values[lowest()];
  constexpr int kBetween = 64;
  for (int k = 0; isWhole && k < kBetween; ++k) {
    const Vec2 one = unitVector(2 * kPi * k / kBetween);
    value = std::min(value, mean + first.dot(one) + second.dot(rotate(one, one)));
  }
  return value;
}

std::optional<Vec2> EnergyRing::wayToMinimum(double radius) const {
  // here + first . x + (bowl + second.x) x^2 + 2 second.y x y + (bowl - second.x) y^2, where the
  // circle has radius 1.
  const double bowl = mean - here;
  const double determinant = square(bowl) - second.squaredNorm();
  if (!isWhole || !(bowl > 0 && determinant > 0)) return std::nullopt;
  const Vec2 way(-(bowl - second.x()) * first.x() + second.y() * first.y(),
                 second.y() * first.x() - (bowl + second.x()) * first.y());
  const Vec2 scaled = way / (2 * determinant);
  if (!(scaled.norm() <= 1)) return std::nullopt;
  return radius * scaled;
}

int EnergyRing::lowest() const {
  return static_cast<int>(std::min_element(values.begin(), values.end()) - values.begin());
}

EnergyRing energyRing(const Geometry& geometry, const SurfacePoint& center,
                      const std::function<double(const SurfacePoint&)>& energyAt) {
  // Points of a circle that the boundary cuts off lie nearer than those on the steepest cones.
  constexpr double kNearest = 0.5;
  const double radius = kCheckedRadius * geometry.meanEdge;
  EnergyRing ring;
  ring.center = center;
  ring.here = energyAt(center);
  ring.places = circleAround(geometry, center, radius, EnergyRing::kCount);
  const Vec3 middle = position(*geometry.mesh, center);
  for (int k = 0; k < EnergyRing::kCount; ++k) {
    const double value = energyAt(ring.places[k]);
    const Vec2 one = unitVector(2 * kPi * (k + 0.5) / EnergyRing::kCount);
    ring.values.push_back(value);
    ring.mean += value / EnergyRing::kCount;
    ring.first += 2 * value / EnergyRing::kCount * one;
    ring.second += 2 * value / EnergyRing::kCount * rotate(one, one);
    const double chord = (position(*geometry.mesh, ring.places[k]) - middle).norm();
    ring.isWhole = ring.isWhole && chord >= kNearest * radius;
  }
  return ring;
}

}  // namespace karcher

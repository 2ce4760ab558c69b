#include "rcm/energy_ring.h"

#include <algorithm>

#include "distance/window.h"

namespace karcher {

Vec2 EnergyRing::lowestOfHarmonics() const {
  constexpr int kDirections = 64;
  Vec2 lowest(1, 0);
  for (int k = 1; k < kDirections; ++k) {
    const Vec2 direction = unitVector(2 * kPi * k / kDirections);
    if (harmonicsAt(direction) < harmonicsAt(lowest)) lowest = direction;
  }
  return lowest;
}

// With the circle's radius for 1 the quadratic is here + first . x + (bowl + second.x) x^2
// + 2 second.y x y + (bowl - second.x) y^2.
Vec2 EnergyRing::wayToMinimum(double radius, double leastBowl) const {
  if (!isWhole) return Vec2::Zero();
  const double bowl = std::max(mean - here, second.norm() + leastBowl);
  const double determinant = square(bowl) - second.squaredNorm();
  const Vec2 way = Vec2(second.y() * first.y() - (bowl - second.x()) * first.x(),
                        second.y() * first.x() - (bowl + second.x()) * first.y()) /
                   (2 * determinant);
  constexpr double kLongest = 3;
  return radius * std::min(1.0, kLongest / way.norm()) * way;
}

double EnergyRing::gainOf(const Vec2& way) const {
  const Vec2 squared = rotate(way, way);
  return -(first.dot(way) + (mean - here) * way.squaredNorm() + second.dot(squared));
}

int EnergyRing::lowest() const {
  return static_cast<int>(std::min_element(values.begin(), values.end()) - values.begin());
}

EnergyRing energyRing(const Geometry& geometry, const SurfacePoint& center, double here, int count,
                      const std::function<double(const SurfacePoint&)>& energyAt) {
  // Points of a circle that the boundary cuts off lie nearer than those on the steepest cones.
  constexpr double kNearest = 0.5;
  const double radius = kCheckedRadius * geometry.meanEdge;
  EnergyRing ring;
  ring.center = center;
  ring.here = here;
  ring.places = circleAround(geometry, center, radius, count);
  const double first = circleStart(geometry, center);
  const Vec3 middle = position(*geometry.mesh, center);
  for (int k = 0; k < count; ++k) {
    const double value = energyAt(ring.places[k]);
    const Vec2 one = unitVector(first + 2 * kPi * (k + 0.5) / count);
    ring.values.push_back(value);
    ring.mean += value / count;
    ring.first += 2 * value / count * one;
    ring.second += 2 * value / count * rotate(one, one);
    const double chord = (position(*geometry.mesh, ring.places[k]) - middle).norm();
    ring.isWhole = ring.isWhole && chord >= kNearest * radius;
  }
  return ring;
}

void lookBesideLowest(const Geometry& geometry, EnergyRing& ring,
                      const std::function<double(const SurfacePoint&)>& energyAt) {
  const int lowest = ring.lowest();
  const int count = 3 * ring.places.count();
  const Array<SurfacePoint> places =
      circleAround(geometry, ring.center, kCheckedRadius * geometry.meanEdge, count);
  for (const int beside : {-2, -1, 1, 2}) {
    const SurfacePoint& place = places[(3 * lowest + 1 + beside + count) % count];
    const double value = energyAt(place);
    if (!(value < ring.values[lowest])) continue;
    ring.values[lowest] = value;
    ring.places[lowest] = place;
  }
}

}  // namespace karcher

#include "rcm/energy_ring.h"

#include <algorithm>

#include "distance/window.h"

namespace karcher {

EnergyRing::EnergyRing(const Geometry& geometry, const SurfacePoint& center, double here, int count,
                       ExactOneSourceEnergy& energy)
    : geometry_(geometry),
      center_(center),
      here_(here),
      energy_(energy),
      radius_(kCheckedRadius * geometry.meanEdge),
      start_(circleStart(geometry, center)) {
  const auto places = static_cast<size_t>(count);
  places_.resize(places);
  values_.assign(places, kInfinity);
  slopes_.assign(places, 0);
  compare(0, step_);
  error_ = kInfinity;
  fit();
}

void EnergyRing::refine() {
  if (isRefined()) return;
  compare(step_ / 2, step_);
  step_ /= 2;
  fit();
}

void EnergyRing::compare(int first, int step) {
  // Points of a circle that the boundary cuts off lie nearer than those on the steepest cones.
  constexpr double kNearest = 0.5;
  const Vec3 middle = position(*geometry_.mesh, center_);
  const Array<StraightestPath> radii = circleRadii(geometry_, center_, radius_, places_.count());
  error_ = 0;
  for (int k = first; k < places_.count(); k += step) {
    places_[k] = radii[k].path.end();
    const EnergyAt there = energy_.at(places_[k]);
    values_[k] = there.energy;
    slopes_[k] = -2 * radius_ * cross(radii[k].direction, there.step);
    error_ = std::max(error_, std::abs(values_[k] - polynomialAt(angleOf(k))));
    const double chord = (position(*geometry_.mesh, places_[k]) - middle).norm();
    isWhole_ = isWhole_ && chord >= kNearest * radius_;
  }
}

/// What the polynomial through all that was compared is like.
void EnergyRing::fit() {
  constexpr int kDirections = 64;
  mean_ = 0;
  first_ = second_ = Vec2::Zero();
  least_ = kInfinity;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * kPi * k / kDirections;
    const Vec2 one = unitVector(angle);
    const double value = polynomialAt(angle);
    mean_ += value / kDirections;
    first_ += 2 * value / kDirections * one;
    second_ += 2 * value / kDirections * rotate(one, one);
    if (!(value < least_)) continue;
    least_ = value;
    lowestDirection_ = one;
  }
}

double EnergyRing::angleOf(int k) const { return start_ + 2 * kPi * (k + 0.5) / places_.count(); }

/// The interpolation of C. Hermite by trigonometric polynomials, at equally spaced places.
double EnergyRing::polynomialAt(double angle) const {
  constexpr double kThere = 1e-6;
  const int count = places_.count() / step_;
  double sum = 0;
  for (int k = 0; k < places_.count(); k += step_) {
    const double half = (angle - angleOf(k)) / 2;
    const double sine = std::sin(half);
    if (std::abs(sine) < kThere) return values_[k];
    sum += square(std::sin(count * half) / (count * sine)) *
           (values_[k] + 2 * slopes_[k] * sine * std::cos(half));
  }
  return sum;
}

void EnergyRing::lookBesideLowest() {
  const int place = lowest();
  const int count = 3 * places_.count();
  const Array<SurfacePoint> places = circleAround(geometry_, center_, radius_, count);
  for (const int beside : {-2, -1, 1, 2}) {
    const SurfacePoint& there = places[(3 * place + 1 + beside + count) % count];
    const double value = energy_.at(there).energy;
    if (!(value < values_[place])) continue;
    values_[place] = value;
    places_[place] = there;
  }
}

int EnergyRing::lowest() const {
  return static_cast<int>(std::min_element(values_.begin(), values_.end()) - values_.begin());
}

// With the circle's radius for 1 the quadratic is here + first . x + (bowl + second.x) x^2
// + 2 second.y x y + (bowl - second.x) y^2.
Vec2 EnergyRing::wayToMinimum(double leastBowl) const {
  if (!isWhole_) return Vec2::Zero();
  const double bowl = std::max(mean_ - here_, second_.norm() + leastBowl);
  const double determinant = square(bowl) - second_.squaredNorm();
  const Vec2 way = Vec2(second_.y() * first_.y() - (bowl - second_.x()) * first_.x(),
                        second_.y() * first_.x() - (bowl + second_.x()) * first_.y()) /
                   (2 * determinant);
  constexpr double kLongest = 3;
  return radius_ * std::min(1.0, kLongest / way.norm()) * way;
}

double EnergyRing::gainOf(const Vec2& way) const {
  const Vec2 x = way / radius_;
  return -(first_.dot(x) + (mean_ - here_) * x.squaredNorm() + second_.dot(rotate(x, x)));
}

}  // namespace karcher

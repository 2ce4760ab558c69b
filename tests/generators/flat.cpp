#include "generators/flat.h"

#include <algorithm>

#include "generators/random.h"

namespace karcher {
namespace {

/// Vertices along one side line, from its start: `first` to `first + heights.count() - 1`.
struct SideLine {
  int first = 0;
  Array<double> heights;
};

/// Values from low to high in steps of about `step`; inner ones are jittered.
Array<double> jitteredSteps(double low, double high, double step, Random& random) {
  const int count = std::max(1, static_cast<int>(std::lround((high - low) / step)));
  Array<double> result;
  for (int i = 0; i <= count; ++i) {
    const double jitter = i > 0 && i < count ? random.uniform(-0.35, 0.35) : 0;
    result.push_back(low + (high - low) * (i + jitter) / count);
  }
  return result;
}

/// Triangles between two side lines, the right one counterclockwise around the axis.
void fillStrip(const SideLine& left, const SideLine& right, Array<Triangle>& triangles) {
  int i = 0;
  int j = 0;
  while (i + 1 < left.heights.count() || j + 1 < right.heights.count()) {
    const bool canLeft = i + 1 < left.heights.count();
    const bool canRight = j + 1 < right.heights.count();
    if (canLeft && (!canRight || left.heights[i + 1] < right.heights[j + 1])) {
      triangles.emplace_back(left.first + i, right.first + j, left.first + i + 1);
      ++i;
    } else {
      triangles.emplace_back(left.first + i, right.first + j, right.first + j + 1);
      ++j;
    }
  }
}

}  // namespace

FlatCylinder flatCylinder(int sides, double height, uint64_t seed) {
  Random random(seed);
  FlatCylinder result;
  const double side = 2 * std::sin(kPi / sides);
  result.circumference = sides * side;
  result.height = height;
  Array<SideLine> lines;
  for (int s = 0; s < sides; ++s) {
    SideLine line{result.soup.positions.count(), jitteredSteps(0, height, side, random)};
    const Vec2 base = unitVector(2 * kPi * s / sides);
    for (const double z : line.heights) {
      result.soup.positions.emplace_back(base.x(), base.y(), z);
      result.unrolled.emplace_back(s * side, z);
    }
    lines.push_back(std::move(line));
  }
  for (int s = 0; s < sides; ++s)
    fillStrip(lines[s], lines[(s + 1) % sides], result.soup.triangles);
  return result;
}

FlatCone flatCone(int sides, double totalAngle, uint64_t seed) {
  Random random(seed);
  FlatCone result;
  result.totalAngle = totalAngle;
  const double sideAngle = totalAngle / sides;
  // Sine of the angle between the axis and a side line.
  const double slope = std::sin(sideAngle / 2) / std::sin(kPi / sides);
  result.soup.positions.emplace_back(0, 0, 0);
  result.unrolled.emplace_back(0, 0);
  const double step = 2 * std::sin(sideAngle / 2);
  Array<SideLine> lines;
  for (int s = 0; s < sides; ++s) {
    SideLine line{result.soup.positions.count(), jitteredSteps(step, 1, step, random)};
    const Vec2 base = unitVector(2 * kPi * s / sides);
    for (const double radius : line.heights) {
      result.soup.positions.emplace_back(radius * slope * base.x(), radius * slope * base.y(),
                                         -radius * std::sqrt(1 - slope * slope));
      result.unrolled.emplace_back(radius, s * sideAngle);
    }
    lines.push_back(std::move(line));
  }
  for (int s = 0; s < sides; ++s) {
    const SideLine& left = lines[s];
    const SideLine& right = lines[(s + 1) % sides];
    result.soup.triangles.emplace_back(0, left.first, right.first);
    // Seen from outside with the apex at the top, a side line runs downwards.
    fillStrip(right, left, result.soup.triangles);
  }
  return result;
}

double cylinderDistance(const FlatCylinder& cylinder, const Vec2& a, const Vec2& b) {
  const double turn = std::abs(std::remainder(a.x() - b.x(), cylinder.circumference));
  return std::hypot(turn, a.y() - b.y());
}

double coneDistance(const FlatCone& cone, const Vec2& a, const Vec2& b) {
  const double turn = std::abs(std::remainder(a.y() - b.y(), cone.totalAngle));
  if (turn >= kPi) return a.x() + b.x();
  // The chord's length, without the cancellation of the law of cosines.
  const double s = std::sin(turn / 2);
  return std::sqrt((a.x() - b.x()) * (a.x() - b.x()) + 4 * a.x() * b.x() * s * s);
}

}  // namespace karcher

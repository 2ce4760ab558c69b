#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "distance/joined_windows.h"
#include "distance/window_distance.h"
#include "distance_meshes.h"
#include "random_surfaces.h"
#include "rcm/field_options.h"
#include "support.h"

namespace karcher {
namespace {

/// The length of the shortest path through the windows to a place on their edge. Such a path is
/// straight, or bends at an end of a window and follows the edge.
double shortestThrough(const Array<Window>& windows, double x) {
  double least = kInfinity;
  for (const Window& w : windows) {
    const double bend = std::clamp(x, w.begin, w.end);
    least = std::min(least, distanceAt(w, bend) + std::abs(x - bend));
  }
  return least;
}

/// The distance that the windows give to a place, or infinity where there is no window.
double distanceThrough(const Array<Window>& windows, double x) {
  double least = kInfinity;
  for (const Window& w : windows) {
    if (w.begin <= x && x <= w.end) least = std::min(least, distanceAt(w, x));
  }
  return least;
}

/// By how much the joint windows are shorter than every path through the original ones.
double shorterByJoining(const Array<Window>& windows, double tolerance) {
  Array<Window> joint = windows;
  joinWindows(tolerance, joint);
  double shorter = 0;
  constexpr int kPlaces = 2000;
  for (const Window& w : joint) {
    for (int i = 0; i <= kPlaces; ++i) {
      // Half of the places lie in the narrow part at the begin.
      const double part = static_cast<double>(i) / kPlaces;
      const double x = w.begin + (w.end - w.begin) * part * part * part * part;
      shorter = std::max(shorter, shortestThrough(windows, x) - distanceThrough(joint, x));
    }
  }
  return shorter;
}

TEST(JoinedDistances, OfVeryDifferentWidthsAreNotShorterByMoreThanTheTolerance) {
  // The largest change lies between the narrow window and the middle of the wide one.
  const Array<Window> windows{{0, 0.0000554, -0.0000893, 0.0001891, 0.0016734, 1},
                              {0.0000554, 0.0402911, -0.0004148, 0.0006144, 0.0011379, 2}};
  EXPECT_LE(shorterByJoining(windows, 1.51e-6), 1.51e-6);
}

/// Windows that follow each other, with overlaps, and one distance where they meet up to some
/// tolerances.
Array<Window> windowsOfOneFront(double tolerance, Random& random) {
  Array<Window> windows;
  double begin = 0;
  for (int k = 0; k < 4; ++k) {
    Window w;
    w.begin = begin;
    w.end = begin + std::pow(10, random.uniform(-4, 0));
    w.sourceX = w.begin + random.uniform(-2, 2);
    w.depth = std::pow(10, random.uniform(-3, 0.5));
    if (k > 0) {
      w.offset = distanceAt(windows.back(), begin) - distanceAt(w, begin) +
                 random.uniform(-2, 2) * tolerance;
    }
    windows.push_back(w);
    begin = w.end + random.uniform(-0.3, 0) * (w.end - w.begin);
  }
  return windows;
}

TEST(JoinedDistances, AreNotShorterThanPathsByMoreThanTheTolerance) {
  const int count = longRun() ? 200'000 : 3000;
  int joins = 0;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(9100, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double tolerance = std::pow(10, random.uniform(-6, -1));
    const Array<Window> windows = windowsOfOneFront(tolerance, random);
    Array<Window> joint = windows;
    joinWindows(tolerance, joint);
    joins += windows.count() - joint.count();
    ASSERT_LE(shorterByJoining(windows, tolerance), tolerance * (1 + 1e-9) + 1e-12);
  }
  EXPECT_GT(joins, count / 10);
}

/// The slope of distances along the edge, which determines the direction of the ray.
double slopeOf(const Window& w, double x) {
  return (x - w.sourceX) / std::sqrt(squaredLegTo(w, x));
}

TEST(JoinedDistances, KeepTheRaysAtTheirEndsFromTurningInwards) {
  const int count = longRun() ? 200'000 : 3000;
  int joins = 0;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(9200, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double tolerance = std::pow(10, random.uniform(-6, -1));
    const Array<Window> windows = windowsOfOneFront(tolerance, random);
    Array<Window> joint = windows;
    joinWindows(tolerance, joint);
    joins += windows.count() - joint.count();
    for (const Window& j : joint) {
      for (const Window& w : windows) {
        if (w.begin == j.begin) {
          ASSERT_LE(slopeOf(j, j.begin), slopeOf(w, w.begin) + 1e-9);
        }
        if (w.end == j.end) {
          ASSERT_GE(slopeOf(j, j.end), slopeOf(w, w.end) - 1e-9);
        }
      }
    }
  }
  EXPECT_GT(joins, count / 10);
}

TEST(JoinedDistances, AreNotThroughGaps) {
  // Both windows have the same source. What ended them casts a shadow, and a place behind the gap
  // lies in it.
  Array<Window> windows{{0, 1, 1.2, 2, 0, -1}, {1.2, 2, 1.2, 2, 0, -1}};
  joinWindows(0.1, windows);
  EXPECT_EQ(windows.count(), 2);
}

/// A box with a round hole from its top to its bottom, whose faces are fans of thin triangles.
TriangleSoup drilledBox() {
  constexpr int kSides = 10;
  constexpr double kHeight = 3.68;
  constexpr double kStretch = 0.503;
  TriangleSoup soup;
  for (const double z : {0.0, kHeight}) {
    for (int i = 0; i < kSides; ++i) {
      const Vec2 onCircle = 0.083 * unitVector(2 * kPi * i / kSides) + Vec2(0.729, -0.343);
      soup.positions.push_back({kStretch * onCircle.x(), onCircle.y(), z});
    }
  }
  const int corners = 2 * kSides;
  for (const double z : {0.0, kHeight}) {
    for (const Vec2& p : {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)}) {
      soup.positions.push_back({kStretch * p.x(), p.y(), z});
    }
  }
  const auto add = [&](int a, int b, int c) { soup.triangles.push_back({a, b, c}); };
  for (int i = 0; i < kSides; ++i) {
    const int j = (i + 1) % kSides;
    add(j, i, kSides + i);
    add(j, kSides + i, kSides + j);
    const int corner = corners + 4 * i / kSides;
    const int after = corners + 4 * (i + 1) / kSides % 4;
    add(i, j, corner);
    add(kSides + j, kSides + i, corner + 4);
    if (after == corner) continue;
    add(j, after, corner);
    add(kSides + j, corner + 4, after + 4);
  }
  for (int k = 0; k < 4; ++k) {
    const int corner = corners + k;
    const int after = corners + (k + 1) % 4;
    add(corner, after, after + 4);
    add(corner, after + 4, corner + 4);
  }
  return soup;
}

TEST(JoinedDistances, KeepDistancesOfADrilledBoxWithinTheTolerance) {
  const TriangleSoup soup = drilledBox();
  const MeasuredMesh box(buildMesh(soup.positions, soup.triangles));
  WindowDistance exact(box.geometry);
  WindowDistance joined(box.geometry, kFastTolerance);
  for (int source = 0; source < box.mesh.vertexCount(); ++source) {
    for (WindowDistance* solver : {&exact, &joined}) {
      solver->setSource(vertexPoint(box.mesh, source));
      solver->grow(kInfinity);
    }
    for (int v = 0; v < box.mesh.vertexCount(); ++v) {
      EXPECT_NEAR(joined.distance(v), exact.distance(v), 0.01 * exact.distance(v))
          << source << " to " << v;
    }
  }
}

}  // namespace
}  // namespace karcher

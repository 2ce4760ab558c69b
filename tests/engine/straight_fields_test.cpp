#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "curves/curve.h"
#include "generators/curve_shapes.h"
#include "generators/random.h"
#include "support.h"

/// Curves on a flat side of a solid whose large triangles reach from rim to rim. The angles of the
/// rim's vertices do not sum to 2 pi. The curves are those of the side alone, a part of the plane.
namespace karcher {
namespace {

using Triangles = Array<std::array<int, 3>>;

/// The top of a prism of height 1 over a polygon, which goes around the left.
TriangleSoup topOf(const Array<Vec2>& outline, const Triangles& triangles) {
  TriangleSoup soup;
  for (const Vec2& corner : outline) soup.positions.emplace_back(corner.x(), corner.y(), 1);
  for (const auto& [a, b, c] : triangles) soup.triangles.push_back({a, b, c});
  return soup;
}

/// The whole prism; its first faces are those of its top.
TriangleSoup prismOf(const Array<Vec2>& outline, const Triangles& triangles) {
  const int corners = outline.count();
  TriangleSoup soup = topOf(outline, triangles);
  for (const Vec2& corner : outline) soup.positions.emplace_back(corner.x(), corner.y(), 0);
  for (const auto& [a, b, c] : triangles) {
    soup.triangles.push_back({corners + a, corners + c, corners + b});
  }
  for (int a = 0; a < corners; ++a) {
    const int b = (a + 1) % corners;
    soup.triangles.push_back({corners + a, corners + b, b});
    soup.triangles.push_back({corners + a, b, a});
  }
  return soup;
}

bool isConverged(const CurveSample& sample) { return sample.status == SampleStatus::kConverged; }

double largestDistance(const Curve& one, const Curve& other) {
  double largest = 0;
  for (int j = 0; j < one.segmentCount(); ++j) {
    const auto samples = one.samples(j);
    const auto others = other.samples(j);
    EXPECT_EQ(samples.size(), others.size());
    EXPECT_TRUE(std::ranges::all_of(samples, isConverged)) << "segment " << j;
    for (size_t i = 0; i < std::min(samples.size(), others.size()); ++i) {
      const Vec3 place = position(one.surface().mesh(), samples[i].point);
      const Vec3 there = position(other.surface().mesh(), others[i].point);
      largest = std::max(largest, (place - there).norm());
    }
  }
  return largest;
}

void expectCurvesOfThePlane(const Array<Vec2>& outline, const Triangles& triangles) {
  Surface solid(meshOf(prismOf(outline, triangles)));
  Surface side(meshOf(topOf(outline, triangles)));
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Array<SurfacePoint> points;
    // The points go around, at even distances, so that no curve leaves the square up to (1, 1).
    for (int i = 0; i < 6; ++i) {
      const Vec2 arm = random.uniform(0.15, 0.25) * unitVector(kPi / 3 * (i + random.uniform()));
      points.push_back(nearestPoint(side.mesh(), Vec3(0.5 + arm.x(), 0.5 + arm.y(), 1)));
    }
    for (const CurveShape& shape : everyShape(points.count())) {
      if (!takesLevels(shape.kind)) continue;
      SCOPED_TRACE(describe(shape));
      CurveOptions options = ofLevelZero(shape, 17, {});
      const Curve expected(side, options, points);
      for (const int levels : {1, 3, kAutomaticLevels}) {
        options.levels = levels;
        const Curve curve(solid, options, points);
        EXPECT_LE(largestDistance(curve, expected), 1e-12) << levels;
      }
    }
  }
}

TEST(StraightFields, OnASideOfACubeGiveTheCurvesOfThePlane) {
  expectCurvesOfThePlane({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(StraightFields, AtAReentrantCornerGiveTheCurvesOfThePlane) {
  // At (1, 1) the angles sum to 450 degrees. The points lie where they see every corner.
  expectCurvesOfThePlane({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
                         {{3, 4, 5}, {3, 5, 0}, {3, 0, 1}, {3, 1, 2}});
}

}  // namespace
}  // namespace karcher

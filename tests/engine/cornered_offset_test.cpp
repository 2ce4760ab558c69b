#include "curves/cornered_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "cases.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "regions/region.h"
#include "support.h"

/// Offsets with mitred and bevelled corners.
namespace karcher {
namespace {

constexpr OffsetCorners kMitred{CornerShape::kMiter, 4};
constexpr OffsetCorners kBevelled{CornerShape::kBevel, 4};

/// The area that closed lines enclose on a plane; holes have the opposite orientation.
double areaOf(const TriangleMesh& mesh, const Array<Isoline>& lines) {
  double twice = 0;
  for (const Isoline& line : lines) {
    for (int i = 1; i < line.points.count(); ++i) {
      const Vec3 a = position(mesh, line.points[i - 1]);
      const Vec3 b = position(mesh, line.points[i]);
      twice += a.x() * b.y() - a.y() * b.x();
    }
  }
  return twice / 2;
}

TEST(CorneredOffset, OfARectangle) {
  const Sheet sheet(planeGrid(10, 10));
  const SurfacePath path =
      polygonOn(sheet.geometry, {{2.3, 2.2}, {7.4, 2.2}, {7.4, 6.5}, {2.3, 6.5}});
  const double width = 5.1;
  const double height = 4.3;
  const auto lines = [&](OffsetSide side, const OffsetCorners& corners) {
    return offsetLines(sheet.geometry, std::span(&path, 1), 0.7, side, corners);
  };
  const auto expectArea = [&](const Array<Isoline>& got, double expected) {
    ASSERT_EQ(got.count(), 1);
    EXPECT_TRUE(got[0].closed);
    EXPECT_NEAR(areaOf(sheet.mesh, got), expected, 1e-10);
  };
  expectArea(lines(OffsetSide::kRight, kMitred), (width + 1.4) * (height + 1.4));
  expectArea(lines(OffsetSide::kRight, kBevelled),
             (width + 1.4) * (height + 1.4) - 4 * 0.7 * 0.7 / 2);
  for (const OffsetCorners& corners : {kMitred, kBevelled}) {
    expectArea(lines(OffsetSide::kLeft, corners), (width - 1.4) * (height - 1.4));
    EXPECT_EQ(lines(OffsetSide::kBoth, corners).count(), 2);
  }
  // Right angles have mitres of the square root of 2.
  expectArea(lines(OffsetSide::kRight, {CornerShape::kMiter, 1.41}),
             (width + 1.4) * (height + 1.4) - 4 * 0.7 * 0.7 / 2);
}

TEST(CorneredOffset, OfAnOpenPathItsEndsAreRound) {
  const Sheet sheet(planeGrid(10, 10));
  const SurfacePath path = polygonOn(sheet.geometry, {{3.2, 3.1}, {6.3, 3.1}, {6.3, 6.4}}, false);
  const double distance = 0.8;
  const double strips = 2 * distance * (3.1 + 3.3) - distance * distance;
  const double ends = kPi * distance * distance;
  const auto area = [&](const OffsetCorners& corners) {
    const Array<Isoline> lines =
        offsetLines(sheet.geometry, std::span(&path, 1), distance, OffsetSide::kBoth, corners);
    EXPECT_EQ(lines.count(), 1);
    return areaOf(sheet.mesh, lines);
  };
  EXPECT_NEAR(area(kMitred), strips + distance * distance + ends, 1e-3);
  EXPECT_NEAR(area(kBevelled), strips + distance * distance / 2 + ends, 1e-3);
  const auto lengthOn = [&](OffsetSide side) {
    const Array<Isoline> lines =
        offsetLines(sheet.geometry, std::span(&path, 1), distance, side, kMitred);
    EXPECT_EQ(lines.count(), 1);
    EXPECT_FALSE(lines[0].closed);
    return lines[0].length;
  };
  EXPECT_NEAR(lengthOn(OffsetSide::kLeft), 6.4 - 2 * distance, 1e-3);
  EXPECT_NEAR(lengthOn(OffsetSide::kRight), 6.4 + 2 * distance, 1e-3);
}

TEST(CorneredOffset, OfASmoothPathIsTheRoundOne) {
  const Sheet sheet(planeGrid(10, 10));
  Array<Vec2> corners;
  for (int i = 0; i < 120; ++i)
    corners.push_back(Vec2(5.03, 5.02) + 2 * unitVector(2 * kPi * i / 120));
  const SurfacePath path = polygonOn(sheet.geometry, corners);
  for (const OffsetSide side : {OffsetSide::kLeft, OffsetSide::kRight, OffsetSide::kBoth}) {
    const auto length = [&](const OffsetCorners& how) {
      double sum = 0;
      for (const Isoline& line : offsetLines(sheet.geometry, std::span(&path, 1), 0.5, side, how)) {
        sum += line.length;
      }
      return sum;
    };
    EXPECT_NEAR(length(kMitred), length({}), 1e-6);
  }
}

TEST(CorneredOffset, OfAnOctantOfTheSphereHasTheMitresOfGeodesics) {
  const Sheet sphere(meshOf(icosphere(32)));
  Array<SurfacePoint> corners;
  for (int k = 0; k < 3; ++k) corners.push_back(nearestPoint(sphere.mesh, Vec3::Unit(k)));
  const SurfacePath path = chain(sphere.geometry, corners, true);
  const double distance = 0.2;
  const auto offset = [&](const OffsetCorners& how) {
    return offsetLines(sphere.geometry, std::span(&path, 1), distance, OffsetSide::kRight, how);
  };
  const Array<Isoline> lines = offset(kMitred);
  ASSERT_EQ(lines.count(), 1);
  EXPECT_TRUE(lines[0].closed);
  // A triangle with a right angle at the start of the side, and half of one at the corner.
  const double reach = std::atan(std::tan(distance) * std::sqrt(2));
  for (int k = 0; k < 3; ++k) {
    const Vec3 outwards = -(Vec3::Ones() - Vec3::Unit(k)) / std::sqrt(2);
    double farthest = 0;
    for (const SurfacePoint& point : lines[0].points) {
      const Vec3 place = position(sphere.mesh, point).normalized();
      if (place[k] > 0.8) farthest = std::max(farthest, place.dot(outwards));
    }
    EXPECT_NEAR(farthest, std::sin(reach), 2e-3);
  }
  EXPECT_LT(offset(kBevelled)[0].length, offset({})[0].length);
  EXPECT_LT(offset({})[0].length, lines[0].length);
}

TEST(CorneredOffset, AMitreHoldsTheRoundOneAndThatHoldsTheBevel) {
  const std::pair<const char*, TriangleMesh> meshes[] = {
      {"random sphere", meshOf(randomSphere(2000, 2))},
      {"irregular torus", meshOf(irregularTorus(1500, 1, 4))},
      {"genus 3", meshOf(makeShape(Shape::kGenus3, 2000))}};
  const auto seeds = static_cast<uint64_t>(longRun() ? 60 : casesOf(4, 2));
  for (const auto& entry : meshes) {
    const TriangleMesh& mesh = entry.second;
    const Geometry geometry = buildGeometry(mesh);
    const double surface = surfaceArea(geometry);
    for (uint64_t seed = 1; seed <= seeds; ++seed) {
      SCOPED_TRACE(std::string(entry.first) + ", seed " + std::to_string(seed));
      Random random(seed);
      const SurfacePoint middle = randomPoint(mesh, random);
      Array<SurfacePoint> corners;
      for (int i = 0; i < 6; ++i) {
        const double radius = random.uniform(0.08, 0.1) * geometry.diagonal;
        corners.push_back(
            traceStraightest(geometry, middle, radius * unitVector(kPi * i / 3)).path.end());
      }
      const SurfacePath path = chain(geometry, corners, true);
      const double distance = random.uniform(0.005, 0.03) * geometry.diagonal;
      const auto area = [&](const OffsetCorners& how) {
        Array<SurfacePath> lines;
        for (Isoline& line :
             offsetLines(geometry, std::span(&path, 1), distance, OffsetSide::kBoth, how)) {
          EXPECT_TRUE(line.closed);
          lines.push_back(pathThrough(mesh, std::move(line.points)));
        }
        const Arrangement all = arrange(geometry, lines);
        const int inside = all.cellOfPiece[pieceHolding(mesh, all, path.points[0])];
        return areaOf(all, enclosed(all, {0, lines.count()}, FillRule::kEvenOdd, inside));
      };
      const double round = area({});
      // Chords of round corners are off by up to kOffsetTolerance.
      const double slack = 3 * kOffsetTolerance * distance * path.length();
      EXPECT_GT(area(kMitred), round - slack);
      EXPECT_LT(area(kBevelled), round + slack);
      EXPECT_LT(area(kMitred), surface);
    }
  }
}

TEST(CorneredOffset, RefusesALimitOfMitresBelow1) {
  const Sheet sheet(planeGrid(4, 4));
  const SurfacePath path = polygonOn(sheet.geometry, {{1.2, 1.1}, {2.6, 1.1}, {1.9, 2.3}});
  EXPECT_THROW(offsetLines(sheet.geometry, std::span(&path, 1), 0.2, OffsetSide::kBoth,
                           {CornerShape::kMiter, 0.5}),
               Error);
}

}  // namespace
}  // namespace karcher

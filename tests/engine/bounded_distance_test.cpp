#include "distance/bounded_distance.h"

#include <gtest/gtest.h>

#include <string>

#include "generators/gallery.h"
#include "generators/random_points.h"
#include "generators/renumbered.h"
#include "support.h"

namespace karcher {
namespace {

/// Holds a field to exact distances: all within the tolerance, no tested path shorter than the
/// distance, and the mean error a tenth of the tolerance.
void expectWithinTolerance(const TriangleMesh& mesh, const SurfacePoint& source) {
  const Geometry geometry = buildGeometry(mesh);
  BoundedDistance bounded(geometry);
  ExactDistance exact(geometry);
  bounded.setSource(source);
  bounded.grow(kInfinity);
  exact.setSource(source);
  exact.grow(kInfinity);
  double sum = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double truth = exact.distance(v);
    EXPECT_TRUE(bounded.isFinal(v));
    EXPECT_NEAR(bounded.distance(v), truth, BoundedDistance::kTolerance * truth) << v;
    EXPECT_GE(bounded.pathLength(v), truth * (1 - 1e-9)) << v;
    EXPECT_NEAR(bounded.logVector(v).norm(), 2 * bounded.distance(v), 1e-9 * geometry.diagonal);
    if (truth > 0) sum += std::abs(bounded.distance(v) / truth - 1);
  }
  EXPECT_LE(sum / mesh.vertexCount(), BoundedDistance::kTolerance / 10);
}

TriangleMesh tube(double radius, int around, int along) {
  const TriangleSoup soup = ringTube(radius, around, along);
  return buildMesh(soup.positions, soup.triangles);
}

TEST(BoundedDistance, HoldsOnRingTubesOfAnyProportion) {
  const uint64_t seed = 71;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int i = 0; i < 60; ++i) {
    const double radius = std::exp(random.uniform(std::log(0.004), std::log(0.6)));
    const int around = 4 + random.index(20);
    const int along = 20 + random.index(60);
    SCOPED_TRACE(std::to_string(radius) + ", " + std::to_string(along) + " x " +
                 std::to_string(around));
    const TriangleMesh mesh = tube(radius, around, along);
    expectWithinTolerance(mesh, randomPlace(mesh, random));
  }
}

TEST(BoundedDistance, HoldsOnTubesWhereVirtualSourcesAreFarOff) {
  for (const auto& [radius, around, along] :
       {std::tuple{0.02, 12, 60}, {0.03, 12, 60}, {0.015, 9, 90}}) {
    const TriangleMesh mesh = tube(radius, around, along);
    for (const int source : {0, 100, 333}) expectWithinTolerance(mesh, vertexPoint(mesh, source));
  }
}

TEST(BoundedDistance, HoldsOnTheGallery) {
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const char* const name :
       {"ring tube, r = 0.1, quads 20:1", "ring tube, r = 0.03, quads 33:1", "torus",
        "torus, stretched 8:1", "rough sheet", "rough sheet, sheared 10", "very rough sheet",
        "crumpled sheet, 6 folds", "plate with 50 holes", "sphere, random"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    for (int i = 0; i < 3; ++i) expectWithinTolerance(mesh, randomPlace(mesh, random));
  }
}

TEST(BoundedDistance, IsThatOfVirtualSourcesWhereTheySuit) {
  const TriangleMesh mesh = galleryMesh("fans, q = 5, jittered");
  const Geometry geometry = buildGeometry(mesh);
  BoundedDistance bounded(geometry);
  FastDistance fast(geometry);
  const SurfacePoint source{20, {0.2, 0.3, 0.5}};
  bounded.setSource(source);
  bounded.grow(kInfinity);
  fast.setSource(source);
  fast.grow(kInfinity);
  EXPECT_EQ(bounded.trusted(), kInfinity);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(bounded.distance(v), fast.distance(v));
    EXPECT_EQ(bounded.logVector(v), fast.logVector(v));
    EXPECT_NEAR(bounded.pathLength(v), fast.distance(v), 0.01 * fast.distance(v));
  }
}

TEST(BoundedDistance, ResumedIsTheSame) {
  const uint64_t seed = 9;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const TriangleMesh& mesh : {bunnyMesh(), tube(0.02, 12, 60)}) {
    const Geometry geometry = buildGeometry(mesh);
    BoundedDistance whole(geometry);
    BoundedDistance resumed(geometry);
    resumed.setSource(vertexPoint(mesh, 1));
    resumed.grow(geometry.diagonal / 3);
    for (int i = 0; i < 4; ++i) {
      const SurfacePoint source = randomPlace(mesh, random);
      whole.setSource(source);
      whole.grow(kInfinity);
      resumed.setSource(source);
      const auto expectSame = [&](int v) {
        EXPECT_EQ(resumed.distance(v), whole.distance(v));
        EXPECT_EQ(resumed.logVector(v), whole.logVector(v));
      };
      for (int k = 0; k < 20; ++k) {
        const int v = random.index(mesh.vertexCount());
        EXPECT_EQ(resumed.growTo(v), whole.distance(v));
        EXPECT_TRUE(resumed.isFinal(v));
        expectSame(v);
      }
      for (const double part : {0.3, 0.6, 2.0}) {
        resumed.grow(part * geometry.diagonal);
        EXPECT_GE(resumed.reached(), part * geometry.diagonal);
        for (int v = 0; v < mesh.vertexCount(); ++v) {
          const bool isNear = whole.distance(v) <= part * geometry.diagonal;
          EXPECT_TRUE(!isNear || resumed.isFinal(v));
          if (resumed.isFinal(v)) expectSame(v);
        }
      }
    }
  }
}

TEST(BoundedDistance, UnreachableVerticesAreFinal) {
  TriangleSoup two = ringTube(0.3, 8, 30);
  const int count = two.positions.count();
  const int faces = two.triangles.count();
  for (int i = 0; i < count; ++i) two.positions.push_back(two.positions[i] + Vec3(5, 0, 0));
  for (int f = 0; f < faces; ++f) {
    Triangle face = two.triangles[f];
    for (int& corner : face) corner += count;
    two.triangles.push_back(face);
  }
  const TriangleMesh mesh = buildMesh(two.positions, two.triangles);
  const Geometry geometry = buildGeometry(mesh);
  BoundedDistance bounded(geometry);
  bounded.setSource(vertexPoint(mesh, 3));
  EXPECT_EQ(bounded.growTo(count + 3), kInfinity);
  EXPECT_EQ(bounded.reached(), kInfinity);
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "distance/exact_distance.h"
#include "generators/gallery.h"
#include "generators/random_points.h"
#include "support.h"

namespace karcher {
namespace {

constexpr double kTolerance = 0.0075;

/// Holds distances of merged windows to exact ones: each within 1 %, in the mean .1 %.
void expectNearExact(const TriangleMesh& mesh, const SurfacePoint& source) {
  const Geometry geometry = buildGeometry(mesh);
  ExactDistance merged(geometry, kTolerance);
  ExactDistance exact(geometry);
  merged.setSource(source);
  merged.grow(kInfinity);
  exact.setSource(source);
  exact.grow(kInfinity);
  double sum = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double truth = exact.distance(v);
    EXPECT_TRUE(merged.isFinal(v));
    EXPECT_NEAR(merged.distance(v), truth, 0.01 * truth) << v;
    EXPECT_NEAR(merged.logVector(v).norm(), 2 * merged.distance(v), 1e-9 * geometry.diagonal);
    if (truth > 0) sum += std::abs(merged.distance(v) / truth - 1);
  }
  EXPECT_LE(sum / mesh.vertexCount(), 0.001);
}

TriangleMesh tube(double radius, int around, int along) {
  const TriangleSoup soup = ringTube(radius, around, along);
  return buildMesh(soup.positions, soup.triangles);
}

TEST(MergedWindows, AreNearExactOnRingTubesOfAnyProportion) {
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
    expectNearExact(mesh, randomPlace(mesh, random));
  }
}

TEST(MergedWindows, AreNearExactWhereVirtualSourcesAreFarOff) {
  for (const auto& [radius, around, along] :
       {std::tuple{0.02, 12, 60}, {0.03, 12, 60}, {0.015, 9, 90}}) {
    const TriangleMesh mesh = tube(radius, around, along);
    for (const int source : {0, 100, 333}) expectNearExact(mesh, vertexPoint(mesh, source));
  }
}

TEST(MergedWindows, AreNearExactOnTheGallery) {
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const char* const name :
       {"ring tube, r = 0.1, quads 20:1", "ring tube, r = 0.03, quads 33:1", "torus",
        "torus, stretched 8:1", "rough sheet", "rough sheet, sheared 10", "very rough sheet",
        "crumpled sheet, 6 folds", "plate with 50 holes", "sphere, random"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    for (int i = 0; i < 3; ++i) expectNearExact(mesh, randomPlace(mesh, random));
  }
}

TEST(MergedWindows, LoseNothingWhereTheyAreEqual) {
  const TriangleMesh mesh = galleryMesh("plate with 50 holes");
  const Geometry geometry = buildGeometry(mesh);
  ExactDistance merged(geometry, 1e-300);
  ExactDistance exact(geometry);
  const SurfacePoint source{20, {0.2, 0.3, 0.5}};
  for (ExactDistance* const solver : {&merged, &exact}) {
    solver->setSource(source);
    solver->grow(kInfinity);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_NEAR(merged.distance(v), exact.distance(v), 1e-12 * geometry.diagonal) << v;
  }
}

}  // namespace
}  // namespace karcher

#include "distance/sight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <utility>

#include "distance/window_distance.h"
#include "distance_meshes.h"
#include "generators/gallery.h"
#include "generators/random_points.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

constexpr double kRounding = 1e-10;

/// Statistics of vertices within some mean edges of random points.
struct Sights {
  int asked = 0;
  int found = 0;
  int longer = 0;    // paths longer than the shortest by a thousandth
  double worst = 1;  // the largest ratio to the shortest path's length
  double least = kInfinity;
  int turned = 0;  // paths as long as the shortest, but with another log vector
};

/// A point inside a face, in the middle of an edge, anywhere on an edge, or near a vertex.
SurfacePoint anyPoint(const TriangleMesh& mesh, Random& random, int kind) {
  SurfacePoint point = randomPoint(mesh, random);
  const double part = kind == 1 ? 0.5 : random.uniform(0.05, 0.95);
  if (kind == 1 || kind == 2) point.bary = Vec3(part, 1 - part, 0);
  if (kind == 3) point.bary = Vec3(1 - 3e-8, 1e-8, 2e-8);
  return point;
}

SightSources sourcesOf(const Geometry& geometry, const SurfacePoint& point) {
  SightSources sources;
  findSightSources(geometry, point, sources);
  return sources;
}

Sights sightsWithin(double edges, const Geometry& geometry, uint64_t seed) {
  const TriangleMesh& mesh = *geometry.mesh;
  WindowDistance exact(geometry);
  Random random(seed);
  Sights all;
  for (int i = 0; i < 80; ++i) {
    const SurfacePoint point = anyPoint(mesh, random, i % 4);
    const SightSources source = sourcesOf(geometry, point);
    exact.setSource(point);
    exact.grow(edges * geometry.meanEdge);
    exact.forEachMet([&](int v) {
      const double distance = exact.distance(v);
      if (distance > exact.reached() || distance > edges * geometry.meanEdge) return;
      ++all.asked;
      const std::optional<Sight> sight = sightFrom(geometry, source, v);
      if (!sight) return;
      ++all.found;
      const double ratio = sight->distance / distance;
      all.worst = std::max(all.worst, ratio);
      all.least = std::min(all.least, ratio);
      if (ratio > 1.001) ++all.longer;
      const double turn = (sight->logVector - exact.logVector(v)).norm() / (2 * distance);
      if (ratio < 1 + kRounding && turn > 1e-6) ++all.turned;
    });
  }
  return all;
}

TEST(Sight, IsTheShortestPathOfAPlane) {
  const std::pair<const char*, double> planes[] = {
      {"plane, Delaunay of random points", 0.9},
      {"fans, q = 8, jittered", 0.9},
      {"plane, 20:1 jittered grid, random diagonals", 0.4},
      {"plane, caps 1e-06", 0.9}};
  for (const auto& [name, found] : planes) {
    SCOPED_TRACE(name);
    const MeasuredMesh plane(galleryMesh(name));
    const Sights all = sightsWithin(6, plane.geometry, 3);
    EXPECT_GT(all.found, found * all.asked) << "the rest lie across many faces";
    EXPECT_NEAR(all.worst, 1, 1e-7);
    EXPECT_NEAR(all.least, 1, 1e-7);
    EXPECT_LT(all.turned, 1e-3 * all.found);
  }
}

TEST(Sight, IsUsuallyTheShortestPathOnCurvedSurfaces) {
  const auto check = [](const std::string& name, const MeasuredMesh& m, double longer,
                        double worst) {
    const uint64_t seed = 7;
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    const Sights all = sightsWithin(6, m.geometry, seed);
    EXPECT_GT(all.found, 0.9 * all.asked);
    EXPECT_GT(all.least, 1 - 1e-7);
    EXPECT_LE(all.longer, longer * all.found) << "of " << all.found;
    EXPECT_LE(all.worst, worst);
    // Two paths of equal length may exist.
    EXPECT_LT(all.turned, 2e-3 * all.found);
  };
  check("torus", MeasuredMesh(meshOf(makeShape(Shape::kTorus, 5000))), 0, 1.0001);
  check("sphere", MeasuredMesh(galleryMesh("sphere, jittered UV")), 0, 1.0001);
  check("knot", MeasuredMesh(galleryMesh("knot")), 0.001, 1.1);
  check("bunny", MeasuredMesh(bunnyMesh()), 0.002, 1.06);
  check("box", MeasuredMesh(galleryMesh("box")), 0.001, 1.1);
  check("rough sheet", MeasuredMesh(galleryMesh("rough sheet")), 0.001, 1.01);
  check("sheet with folds", MeasuredMesh(galleryMesh("crumpled sheet, 6 folds")), 0.002, 1.1);
}

/// A move of the mesh changes only rounding for a path along flat faces past their vertices.
TEST(Sight, IsTheSameOfAMovedMesh) {
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  for (const char* name : {"fans, q = 8", "sphere, jittered UV", "cylinder of 12 sides"}) {
    SCOPED_TRACE(name);
    const MeasuredMesh still(galleryMesh(name));
    Array<Vec3> positions = still.mesh.positions;
    for (Vec3& p : positions) p = turn * p + Vec3(3, -2, 5);
    const MeasuredMesh moved(buildMesh(positions, still.mesh.faces));
    Random random(9);
    int found = 0;
    int lost = 0;
    for (int i = 0; i < 20; ++i) {
      const SurfacePoint point = anyPoint(still.mesh, random, i % 3);
      const SightSources source = sourcesOf(still.geometry, point);
      const SightSources other = sourcesOf(moved.geometry, point);
      for (int v = 0; v < still.mesh.vertexCount(); ++v) {
        const std::optional<Sight> there = sightFrom(still.geometry, source, v);
        const std::optional<Sight> here = sightFrom(moved.geometry, other, v);
        lost += there.has_value() != here.has_value();
        if (!there || !here) continue;
        ++found;
        ASSERT_NEAR(there->distance, here->distance, 1e-9) << v;
        ASSERT_LT((there->logVector - here->logVector).norm(), 1e-9) << v;
      }
    }
    EXPECT_GT(found, 500);
    EXPECT_LT(lost, 0.02 * found);
  }
}

TEST(Sight, IsEmptyIfThePathIsNotFound) {
  const TriangleMesh mesh = gridWithCorner();
  const Geometry geometry = buildGeometry(mesh);
  const auto sight = [&](const Vec3& from, const Vec3& to) {
    const SurfacePoint end = nearestPoint(mesh, to);
    int corner = 0;
    end.bary.maxCoeff(&corner);
    return sightFrom(geometry, sourcesOf(geometry, nearestPoint(mesh, from)),
                     mesh.corner(end.face, corner));
  };
  const std::optional<Sight> seen = sight({1.2, 1.1, 0}, {3, 6, 0});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->distance, std::hypot(1.8, 4.9), 1e-12);
  EXPECT_FALSE(sight({3.5, 8.2, 0}, {8, 3, 0})) << "across the corner outside";
  const std::optional<Sight> fromVertex = sight({2, 2, 0}, {3, 7, 0});
  ASSERT_TRUE(fromVertex);
  EXPECT_NEAR(fromVertex->distance, std::hypot(1.0, 5.0), 1e-12);
}

/// The surface has a saddle, behind which no straight path leads.
TEST(Sight, BendsAtASaddle) {
  const TriangleSoup hat = [] {
    // Eight equilateral triangles around a vertex, alternately up and down.
    TriangleSoup soup;
    soup.positions.push_back(Vec3::Zero());
    const double height = 0.3;
    const double radius = std::sqrt(1 - height * height);
    for (int k = 0; k < 8; ++k) {
      const double angle = kPi / 4 * k;
      soup.positions.push_back(
          {radius * std::cos(angle), radius * std::sin(angle), k % 2 ? height : -height});
    }
    for (int k = 0; k < 8; ++k) soup.triangles.push_back({0, 1 + k, 1 + (k + 1) % 8});
    return soup;
  }();
  const MeasuredMesh saddle(hat);
  ASSERT_GT(saddle.geometry.totalAngle[0], 2 * kPi + 0.5);
  const SurfacePoint point{0, {0.5, 0.25, 0.25}};
  const SightSources source = sourcesOf(saddle.geometry, point);
  WindowDistance exact(saddle.geometry);
  exact.setSource(point);
  exact.grow(kInfinity);
  int bent = 0;
  for (int v = 1; v <= 8; ++v) {
    const double round = position(saddle.mesh, point).norm() + 1;
    if (exact.distance(v) < round - kRounding) continue;
    ++bent;
    const std::optional<Sight> sight = sightFrom(saddle.geometry, source, v);
    ASSERT_TRUE(sight) << v;
    EXPECT_NEAR(sight->distance, round, 1e-12);
    EXPECT_LT((sight->logVector - exact.logVector(v)).norm(), 1e-12);
  }
  EXPECT_GT(bent, 0);
}

}  // namespace
}  // namespace karcher

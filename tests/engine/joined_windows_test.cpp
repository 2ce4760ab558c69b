#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <string>
#include <tuple>

#include "cases.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "rcm/field_options.h"
#include "rcm/surface.h"
#include "support.h"

namespace karcher {
namespace {

/// Compares distances of merged windows with exact ones: each is within 1 %, and the mean error is
/// below .1 %.
void expectNearExact(const TriangleMesh& mesh, const SurfacePoint& source) {
  const Geometry geometry = buildGeometry(mesh);
  WindowDistance merged(geometry, kFastTolerance);
  WindowDistance exact(geometry);
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

/// A round plate with a hole that has a deep wall, triangulated as CAD programs do it: by slivers
/// that lead from few vertices of one rim to many of the other.
TriangleMesh plateWithHole(Random& random) {
  const int inner = 20 + random.index(180);
  const int outer = 200 + random.index(800);
  const double radius = random.uniform(3, 8);
  const double depth = random.uniform(0.5, 5);
  Array<Vec3> positions;
  const auto addRing = [&](int count, double at, double z) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      positions.push_back({at * std::cos(angle), at * std::sin(angle), z});
    }
  };
  addRing(inner, 1, 0);
  addRing(inner, 1, -depth);
  addRing(outer, radius, 0);
  Array<Triangle> faces;
  for (int i = 0; i < inner; ++i) {
    const int j = (i + 1) % inner;
    faces.push_back({i, j, inner + j});
    faces.push_back({i, inner + j, inner + i});
  }
  const auto innerAt = [&](int i) { return i % inner; };
  const auto outerAt = [&](int j) { return 2 * inner + j % outer; };
  const auto isSeen = [&](int i, int j) {
    return positions[outerAt(j)].dot(positions[innerAt(i)]) >= 1;
  };
  for (int i = 0, j = 0; i < inner || j < outer;) {
    const bool isInner = random.uniform() < 0.5;
    for (int left = 1 + random.index(20); left > 0 && (i < inner || j < outer); --left) {
      const bool canStepInside = i < inner && isSeen(i + 1, j);
      const bool canStepOutside = j < outer && isSeen(i, j + 1);
      if (isInner ? canStepInside : !canStepOutside) {
        faces.push_back({innerAt(i), outerAt(j), innerAt(i + 1)});
        ++i;
      } else {
        faces.push_back({innerAt(i), outerAt(j), outerAt(j + 1)});
        ++j;
      }
    }
  }
  return buildMesh(positions, faces);
}

/// A rectangle of cells with random inner vertices, each cut by a random diagonal, then stretched
/// and sheared along x. Its outline stays convex.
TriangleMesh randomCells(int side, double stretch, double shear, Random& random) {
  Array<Vec3> positions;
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      const bool inside = i > 0 && j > 0 && i < side && j < side;
      const double reach = inside ? 0.2 : 0;
      const double x = i + random.uniform(-reach, reach);
      const double y = j + random.uniform(-reach, reach);
      positions.push_back({stretch * x + shear * y, y, 0});
    }
  }
  Array<Triangle> faces;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const int a = j * (side + 1) + i;
      const int b = a + 1;
      const int c = b + side;
      const int d = c + 1;
      if (random.uniform(0, 1) < 0.5) {
        faces.push_back({a, b, d});
        faces.push_back({a, d, c});
      } else {
        faces.push_back({a, b, c});
        faces.push_back({b, d, c});
      }
    }
  }
  return buildMesh(positions, faces);
}

/// Compares distances to all vertices of a convex piece of the plane with straight lines.
void expectStraightDistances(const TriangleMesh& mesh, WindowDistance& distance, int source) {
  distance.setSource(vertexPoint(mesh, source));
  distance.grow(kInfinity);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double expected = (mesh.positions[v] - mesh.positions[source]).norm();
    EXPECT_NEAR(distance.distance(v), expected, 1e-9 * expected)
        << "from vertex " << source << " to " << v;
  }
}

TriangleMesh tube(double radius, int around, int along) {
  const TriangleSoup soup = ringTube(radius, around, along);
  return buildMesh(soup.positions, soup.triangles);
}

TEST(JoinedWindows, AreNearExactOnRingTubesOfAnyProportion) {
  const uint64_t seed = 71;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const int tubes = casesOf(60, 10);
  for (int i = 0; i < tubes; ++i) {
    const double radius = std::exp(random.uniform(std::log(0.004), std::log(0.6)));
    const int around = 4 + random.index(20);
    const int along = 20 + random.index(60);
    SCOPED_TRACE(std::to_string(radius) + ", " + std::to_string(along) + " x " +
                 std::to_string(around));
    const TriangleMesh mesh = tube(radius, around, along);
    expectNearExact(mesh, randomPlace(mesh, random));
  }
}

TEST(JoinedWindows, AreNearExactOnThinTubes) {
  for (const auto& [radius, around, along] :
       {std::tuple{0.02, 12, 60}, {0.03, 12, 60}, {0.015, 9, 90}}) {
    const TriangleMesh mesh = tube(radius, around, along);
    for (const int source : {0, 100, 333}) expectNearExact(mesh, vertexPoint(mesh, source));
  }
}

TEST(JoinedWindows, AreNearExactOnTheGallery) {
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const char* const names[] = {"ring tube, r = 0.1, quads 20:1",
                               "ring tube, r = 0.03, quads 33:1",
                               "torus",
                               "torus, stretched 8:1",
                               "rough sheet",
                               "rough sheet, sheared 10",
                               "very rough sheet",
                               "crumpled sheet, 6 folds",
                               "plate with 50 holes",
                               "sphere, random"};
  for (const char* const name : casesOf(names, 3)) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    for (int i = 0; i < 3; ++i) expectNearExact(mesh, randomPlace(mesh, random));
  }
}

/// A flange with a tube on it, as a CAD program meshes them. Slivers from rim to rim divide each
/// face, and each rim is turned against the previous one.
TriangleMesh flangedTube(int around, double height) {
  const Array<Vec2> profile{{1, 0}, {5, 0}, {5, 0.5}, {1.5, 0.5}, {1.5, height}, {1, height}};
  const int rims = profile.count();
  Array<Vec3> positions;
  Array<Triangle> faces;
  for (int r = 0; r < rims; ++r) {
    const int after = (r + 1) % rims * around;
    for (int i = 0; i < around; ++i) {
      const Vec2 turn = unitVector(2 * kPi * (i + 0.3 * r) / around);
      positions.push_back({profile[r].x() * turn.x(), profile[r].x() * turn.y(), profile[r].y()});
      const int a = r * around;
      const int j = (i + 1) % around;
      faces.push_back({a + i, after + i, after + j});
      faces.push_back({a + i, after + j, a + j});
    }
  }
  return buildMesh(positions, faces);
}

TEST(JoinedWindows, AreNearExactOnSliversFromRimToRim) {
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const int counts[] = {24, 48, 96};
  for (const double height : {1.0, 3.0}) {
    for (const int around : casesOf(counts, 1)) {
      SCOPED_TRACE(std::to_string(around) + " around, height " + std::to_string(height));
      const TriangleMesh mesh = flangedTube(around, height);
      Random random(seed);
      for (int i = 0; i < 8; ++i) {
        expectNearExact(mesh, i % 2 == 0 ? vertexPoint(mesh, random.index(mesh.vertexCount()))
                                         : randomPoint(mesh, random));
      }
    }
  }
}

TEST(JoinedWindows, AreNearExactAtTheTipsOfNeedles) {
  const uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const char* const name :
       {"rough sheet, needles 0.01", "rough sheet, needles 0.0001", "rough sheet, needles 1e-06"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    for (int i = 0; i < 16; ++i) {
      const SurfacePoint place = randomPlace(mesh, random);
      expectNearExact(mesh,
                      i % 2 == 0 ? place : vertexPoint(mesh, random.index(mesh.vertexCount())));
    }
  }
}

TEST(JoinedWindows, LoseNothingOnTies) {
  const uint64_t seed = 6;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  // On the flat plate windows of one front are equal; where surfaces bend, few are.
  for (const char* const name : {"plate with 50 holes", "very rough sheet", "sphere, random",
                                 "ring tube, r = 0.1, quads 20:1", "torus, stretched 8:1"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    const Geometry geometry = buildGeometry(mesh);
    WindowDistance merged(geometry, 1e-300);
    WindowDistance exact(geometry);
    const SurfacePoint source = randomPlace(mesh, random);
    for (WindowDistance* const solver : {&merged, &exact}) {
      solver->setSource(source);
      solver->grow(kInfinity);
    }
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_NEAR(merged.distance(v), exact.distance(v), 1e-12 * geometry.diagonal) << v;
    }
  }
}

TEST(JoinedWindows, AreNearExactOnPlatesWithHoles) {
  // Paths turn round the rim of the hole and leave it close to the tip of many slivers.
  Array<uint64_t> seeds{3950, 5256, 5865};
  for (uint64_t seed = 0; longRun() && seed < 1000; ++seed) seeds.push_back(seed);
  for (const uint64_t seed : seeds) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Surface surface(plateWithHole(random));
    const TriangleMesh& mesh = surface.mesh();
    for (int i = 0; i < 6; ++i) {
      expectNearExact(mesh, i % 2 == 0 ? vertexPoint(mesh, random.index(mesh.vertexCount()))
                                       : randomPoint(mesh, random));
    }
  }
}

TEST(JoinedWindows, AreStraightOnStretchedAndShearedPlanes) {
  const uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double stretch : {1.0, 2.5, 10.0, 20.0}) {
    for (const double shear : {0.0, 0.7 * stretch}) {
      for (int mesh = 0; mesh < (longRun() ? 60 : casesOf(4, 1)); ++mesh) {
        SCOPED_TRACE("stretch " + std::to_string(stretch) + ", shear " + std::to_string(shear));
        constexpr int kSide = 20;
        const TriangleMesh cells = randomCells(kSide, stretch, shear, random);
        const Geometry geometry = buildGeometry(cells);
        WindowDistance distance(geometry, kFastTolerance);
        // The sources are a corner, a vertex of the boundary, and two arbitrary vertices.
        const int count = cells.vertexCount();
        for (const int source : {0, 7, random.index(count), random.index(count)}) {
          expectStraightDistances(cells, distance, source);
        }
      }
    }
  }
}

TEST(JoinedWindows, AreStraightAcrossVerticesOfManyEdges) {
  // The mesh is a disk: rings of 100 vertices, evenly spaced, around one vertex.
  constexpr int kRound = 100;
  Array<Vec3> positions{Vec3::Zero()};
  for (const int radius : {1, 2, 3}) {
    for (int i = 0; i < kRound; ++i) {
      const double angle = 2 * std::numbers::pi * i / kRound;
      positions.push_back(radius * Vec3(std::cos(angle), std::sin(angle), 0));
    }
  }
  Array<Triangle> faces;
  for (int i = 0; i < kRound; ++i) {
    const int j = (i + 1) % kRound;
    faces.push_back({0, 1 + i, 1 + j});
    for (const int ring : {0, kRound}) {
      faces.push_back({1 + ring + i, 1 + ring + kRound + i, 1 + ring + kRound + j});
      faces.push_back({1 + ring + i, 1 + ring + kRound + j, 1 + ring + j});
    }
  }
  const TriangleMesh mesh = buildMesh(positions, faces);
  const Geometry geometry = buildGeometry(mesh);
  WindowDistance distance(geometry, kFastTolerance);
  for (const int source : {0, 1, 17, 130, 201, 266}) {
    expectStraightDistances(mesh, distance, source);
  }
}

TEST(JoinedWindows, AreStraightAcrossFansOfAcuteTriangles) {
  for (const int q : {3, 5, 8, 16}) {
    for (const double jitter : {0.0, 0.4}) {
      SCOPED_TRACE("q = " + std::to_string(q) + ", jitter " + std::to_string(jitter));
      const TriangleSoup soup = fanSquares(3, q, jitter, 3);
      const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
      const Geometry geometry = buildGeometry(mesh);
      WindowDistance distance(geometry, kFastTolerance);
      for (int source = 0; source < mesh.vertexCount(); source += 5) {
        expectStraightDistances(mesh, distance, source);
      }
    }
  }
}

TEST(JoinedWindows, AreNotFarBelowTheStraightLine) {
  for (const char* const name : {"ring tube, r = 0.1, quads 20:1", "rough sheet, sheared 10",
                                 "rough sheet, needles 1e-08", "rough sheet, needles 1e-10"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    const Geometry geometry = buildGeometry(mesh);
    WindowDistance distance(geometry, kFastTolerance);
    const int source = mesh.vertexCount() / 3;
    distance.setSource(vertexPoint(mesh, source));
    distance.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double straight = (mesh.positions[v] - mesh.positions[source]).norm();
      EXPECT_GE(distance.distance(v), straight - 1e-12 * geometry.diagonal);
    }
  }
}

TEST(JoinedWindows, ResumedAreTheSame) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint source{1000, {0.1, 0.2, 0.7}};
  WindowDistance whole(geometry, kFastTolerance);
  whole.setSource(source);
  whole.grow(kInfinity);
  WindowDistance resumed(geometry, kFastTolerance);
  resumed.setSource({3, {1, 0, 0}});
  resumed.grow(4);
  resumed.setSource(source);
  for (const double radius : {0.3, 1.0, 2.5, 6.0, kInfinity}) {
    resumed.grow(radius);
    EXPECT_GE(resumed.reached(), radius);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      if (resumed.distance(v) == kInfinity || !resumed.isFinal(v)) continue;
      EXPECT_EQ(resumed.distance(v), whole.distance(v));
      EXPECT_EQ(resumed.logVector(v), whole.logVector(v));
    }
  }
}

TEST(JoinedWindows, GrownToAVertexAreTheSame) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  WindowDistance whole(geometry, kFastTolerance);
  WindowDistance grown(geometry, kFastTolerance);
  for (int i = 0; i < 20; ++i) {
    const SurfacePoint source{random.index(mesh.faceCount()), {0.1, 0.2, 0.7}};
    whole.setSource(source);
    whole.grow(kInfinity);
    grown.setSource(source);
    for (int k = 0; k < 40; ++k) {
      const int v = random.index(mesh.vertexCount());
      ASSERT_LT(grown.growTo(v), kInfinity);
      EXPECT_TRUE(grown.isFinal(v));
      EXPECT_EQ(grown.distance(v), whole.distance(v));
      EXPECT_EQ(grown.logVector(v), whole.logVector(v));
    }
  }
}

TEST(JoinedWindows, ChooseAmongPathsOfEqualLengthByNumbers) {
  // On a regular cone two paths of equal length lead to the vertices across the tip. A rotated cone
  // differs only by rounding.
  const TriangleMesh cone = galleryMesh("cone of 36 degrees");
  Array<Vec3> positions = cone.positions;
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  for (Vec3& p : positions) p = turn * p + Vec3(2, -1, 1.5);
  const TriangleMesh turned = buildMesh(positions, cone.faces);
  const Geometry geometry = buildGeometry(cone);
  const Geometry turnedGeometry = buildGeometry(turned);
  WindowDistance solver(geometry, kFastTolerance);
  WindowDistance other(turnedGeometry, kFastTolerance);
  for (int source = 0; source < cone.vertexCount(); source += 7) {
    for (WindowDistance* distance : {&solver, &other}) {
      distance->setSource(vertexPoint(cone, source));
      distance->grow(kInfinity);
    }
    for (int v = 0; v < cone.vertexCount(); ++v) {
      ASSERT_LT((solver.logVector(v) - other.logVector(v)).norm(), 1e-9) << source << " to " << v;
    }
  }
}

TEST(JoinedWindows, GrowToNoVertexOfAnotherComponent) {
  const TriangleMesh mesh = buildMesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const Geometry geometry = buildGeometry(mesh);
  WindowDistance distance(geometry, kFastTolerance);
  distance.setSource({0, {0.2, 0.3, 0.5}});
  EXPECT_EQ(distance.growTo(4), kInfinity);
  EXPECT_LT(distance.growTo(2), kInfinity);
}

}  // namespace
}  // namespace karcher

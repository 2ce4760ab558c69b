#include "distance/fast_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <string>

#include "distance/exact_distance.h"
#include "distance/fast_trial.h"
#include "distance/ordered_queue.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "generators/renumbered.h"
#include "rcm/point_field.h"
#include "support.h"

namespace karcher {
namespace {

/// A rectangle of cells, their inner vertices moved at random and each cut by a random diagonal;
/// then stretched and sheared along x. Its outline stays convex.
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

/// Straight distances to all vertices of a convex piece of the plane.
void expectStraightDistances(const TriangleMesh& mesh, FastDistance& distance, int source) {
  distance.setSource(vertexPoint(mesh, source));
  distance.grow(kInfinity);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double expected = (mesh.positions[v] - mesh.positions[source]).norm();
    EXPECT_NEAR(distance.distance(v), expected, 1e-9 * expected)
        << "from vertex " << source << " to " << v;
  }
}

TEST(FastDistance, IsStraightOnStretchedAndShearedPlanes) {
  const uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const double stretch : {1.0, 2.5, 10.0, 20.0}) {
    for (const double shear : {0.0, 0.7 * stretch}) {
      for (int mesh = 0; mesh < (longRun() ? 60 : 4); ++mesh) {
        SCOPED_TRACE("stretch " + std::to_string(stretch) + ", shear " + std::to_string(shear));
        constexpr int kSide = 20;
        const TriangleMesh cells = randomCells(kSide, stretch, shear, random);
        const Geometry geometry = buildGeometry(cells);
        FastDistance distance(geometry);
        // A corner, a vertex of the boundary, and two anywhere.
        const int count = cells.vertexCount();
        for (const int source : {0, 7, random.index(count), random.index(count)}) {
          expectStraightDistances(cells, distance, source);
        }
      }
    }
  }
}

TEST(FastDistance, IsStraightAcrossVerticesOfManyEdges) {
  // A disk: rings of 100 vertices, equally far apart, around one.
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
  FastDistance distance(geometry);
  for (const int source : {0, 1, 17, 130, 201, 266}) {
    expectStraightDistances(mesh, distance, source);
  }
}

TEST(FastDistance, IsStraightAcrossFansOfAcuteTriangles) {
  for (const int q : {3, 5, 8, 16}) {
    for (const double jitter : {0.0, 0.4}) {
      SCOPED_TRACE("q = " + std::to_string(q) + ", jitter " + std::to_string(jitter));
      const TriangleSoup soup = fanSquares(3, q, jitter, 3);
      const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
      const Geometry geometry = buildGeometry(mesh);
      FastDistance distance(geometry);
      for (int source = 0; source < mesh.vertexCount(); source += 5) {
        expectStraightDistances(mesh, distance, source);
      }
    }
  }
}

TEST(FastDistance, IsNowhereBelowTheStraightLine) {
  for (const char* const name : {"ring tube, r = 0.1, quads 20:1", "rough sheet, sheared 10",
                                 "rough sheet, needles 1e-08", "rough sheet, needles 1e-10"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    const Geometry geometry = buildGeometry(mesh);
    FastDistance distance(geometry);
    const int source = mesh.vertexCount() / 3;
    distance.setSource(vertexPoint(mesh, source));
    distance.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double straight = (mesh.positions[v] - mesh.positions[source]).norm();
      EXPECT_GE(distance.distance(v), straight - 1e-12 * geometry.diagonal);
    }
  }
}

TEST(FastDistance, IsNearExactAlongTheOtherSideOfATube) {
  // Two fronts meet there, and edges seven times as long as the tube's sides reach into both.
  const TriangleMesh mesh = galleryMesh("ring tube, r = 0.1, quads 7:1");
  const Geometry geometry = buildGeometry(mesh);
  FastDistance fast(geometry);
  ExactDistance exact(geometry);
  for (const int source : {5, 1000, 2020}) {
    fast.setSource(vertexPoint(mesh, source));
    fast.grow(kInfinity);
    exact.setSource(vertexPoint(mesh, source));
    exact.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      EXPECT_NEAR(fast.distance(v), exact.distance(v), 0.02 * exact.distance(v));
    }
  }
}

TEST(FastDistance, GoesThroughEdgesWhoseEndsOtherFrontsReachedFirst) {
  // On the tube a front passes an end whose own lies far beside; on the other surface an end of a
  // long edge is reached later than straight from the source that the front comes from.
  for (const char* const name : {"ring tube, r = 0.1, quads 1:1", "genus 3"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = galleryMesh(name);
    const Geometry geometry = buildGeometry(mesh);
    FastDistance fast(geometry);
    ExactDistance exact(geometry);
    Random random(21);
    random.index(mesh.vertexCount());
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint source = randomPoint(mesh, random);
      fast.setSource(source);
      fast.grow(kInfinity);
      exact.setSource(source);
      exact.grow(kInfinity);
      for (int v = 0; v < mesh.vertexCount(); ++v) {
        EXPECT_NEAR(fast.distance(v), exact.distance(v), 0.02 * exact.distance(v));
      }
    }
  }
}

FastTrial trialOf(const TriangleMesh& mesh) {
  const Geometry geometry = buildGeometry(mesh);
  return tryFastDistance(geometry, std::make_shared<const VertexFans>(buildVertexFans(geometry)));
}

TEST(FastTrial, IsOfTheShapeAlone) {
  const uint64_t seed = 31;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Eigen::AngleAxisd turn(0.8, Vec3(2, -1, 0.6).normalized());
  Array<GalleryMesh> meshes;
  for (uint64_t i = 0; i < 12; ++i) meshes.push_back(randomSheet(seed + i));
  // Many of its vertices are equally bad.
  TriangleSoup bumps = tessellatedPlane(PlaneTessellation::kRegularGrid, 1800, seed);
  for (Vec3& p : bumps.positions) {
    p.z() = 0.02 * std::sin(20 * kPi * p.x()) * std::sin(20 * kPi * p.y());
  }
  meshes.push_back({"bumps", bumps, false});
  for (const GalleryMesh& sheet : meshes) {
    SCOPED_TRACE(sheet.name);
    const TriangleMesh mesh = meshOf(sheet.soup);
    Array<Vec3> positions = mesh.positions;
    for (Vec3& p : positions) p = turn * p + Vec3(3, 1, -2);
    const FastTrial trial = trialOf(mesh);
    for (const FastTrial& other :
         {trialOf(buildMesh(positions, mesh.faces)), trialOf(renumbered(mesh, seed).mesh)}) {
      EXPECT_EQ(other.bad, trial.bad);
      EXPECT_EQ(other.pairs, trial.pairs);
      // Rounding changes which of two fronts the solver takes first, at a few vertices.
      EXPECT_NEAR(other.meanError, trial.meanError, 0.02 * trial.meanError);
      EXPECT_EQ(other.isPassed(), trial.isPassed());
    }
  }
}

TEST(FastTrial, TellsMeshesThatTheFastSolverDoesNotSuit) {
  const auto passes = [](const TriangleMesh& mesh) { return trialOf(mesh).isPassed(); };
  EXPECT_TRUE(passes(bunnyMesh()));
  for (const char* const name :
       {"fans, q = 16, jittered", "plane, stretched 100:1", "torus", "sphere, random",
        "rough sheet", "ring tube, r = 0.1, quads 7:1"}) {
    EXPECT_TRUE(passes(galleryMesh(name))) << name;
  }
  for (const char* const name :
       {"ring tube, r = 0.1, quads 20:1", "ring tube, r = 0.03, quads 33:1", "torus, stretched 8:1",
        "rough sheet, sheared 10", "crumpled sheet, 6 folds", "crumpled sheet, 20 folds",
        "plate with 50 holes", "very rough sheet", "rough sheet, needles 0.01",
        "rough sheet, needles 1e-10"}) {
    EXPECT_FALSE(passes(galleryMesh(name))) << name;
  }
}

TEST(FastTrial, WhereItFailsFieldsAreExact) {
  const FieldOptions fast{Method::kKarcher, Solver::kFast, 6};
  Surface plate(galleryMesh("plate with 50 holes"));
  EXPECT_EQ(solverOn(plate, Solver::kFast), Solver::kExact);
  EXPECT_EQ(solverOn(plate, Solver::kGraph), Solver::kGraph);
  PointField field(plate, fast);
  PointField exact(plate, {Method::kKarcher, Solver::kExact, 6});
  const SurfacePoint point{7, {0.2, 0.3, 0.5}};
  field.setPoint(point);
  exact.setPoint(point);
  for (int v = 0; v < plate.mesh().vertexCount(); v += 9) {
    EXPECT_EQ(field.field().at(v).gradient, exact.field().at(v).gradient);
    EXPECT_EQ(field.field().at(v).squaredDistance, exact.field().at(v).squaredDistance);
  }
  Surface sphere(galleryMesh("sphere, relaxed"));
  EXPECT_EQ(solverOn(sphere, Solver::kFast), Solver::kFast);
}

TEST(FastDistance, ResumedIsTheSame) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint source{1000, {0.1, 0.2, 0.7}};
  FastDistance whole(geometry);
  whole.setSource(source);
  whole.grow(kInfinity);
  FastDistance resumed(geometry);
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

TEST(FastDistance, GrownToAVertexItIsTheSame) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  FastDistance whole(geometry);
  FastDistance grown(geometry);
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

TEST(FastDistance, ChoosesBetweenPathsOfOneLengthByNumbers) {
  // On a regular cone two paths of one length lead to the vertices across the tip. A turned one is
  // the same but for rounding.
  const TriangleMesh cone = galleryMesh("cone of 36 degrees");
  Array<Vec3> positions = cone.positions;
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  for (Vec3& p : positions) p = turn * p + Vec3(2, -1, 1.5);
  const TriangleMesh turned = buildMesh(positions, cone.faces);
  const Geometry geometry = buildGeometry(cone);
  const Geometry turnedGeometry = buildGeometry(turned);
  FastDistance solver(geometry);
  FastDistance other(turnedGeometry);
  for (int source = 0; source < cone.vertexCount(); source += 7) {
    for (FastDistance* distance : {&solver, &other}) {
      distance->setSource(vertexPoint(cone, source));
      distance->grow(kInfinity);
    }
    for (int v = 0; v < cone.vertexCount(); ++v) {
      ASSERT_LT((solver.logVector(v) - other.logVector(v)).norm(), 1e-9) << source << " to " << v;
    }
  }
}

TEST(FastDistance, GrowsToNoVertexOfAnotherComponent) {
  const TriangleMesh mesh = buildMesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const Geometry geometry = buildGeometry(mesh);
  FastDistance distance(geometry);
  distance.setSource({0, {0.2, 0.3, 0.5}});
  EXPECT_EQ(distance.growTo(4), kInfinity);
  EXPECT_LT(distance.growTo(2), kInfinity);
}

TEST(OrderedQueue, GivesItemsInOrderOfTheirKeys) {
  const uint64_t seed = 13;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  OrderedQueue queue(0.01);
  for (int round = 0; round < 20; ++round) {
    queue.clear();
    std::map<int, std::pair<float, int>> waiting;  // key and place by item
    int items = 0;
    double front = 0;
    for (int step = 0; step < 2000; ++step) {
      const double action = random.uniform(0, 1);
      if (action < 0.5 || waiting.empty()) {
        // Now and then far beyond the ring of buckets, and below what came out.
        const double ahead = action < 0.02 ? random.uniform(0, 100) : random.uniform(-0.05, 2);
        const double key = std::max(0.0, front + ahead);
        waiting[items] = {static_cast<float>(key), queue.push(key, items)};
        ++items;
      } else if (action < 0.7) {
        auto& [key, place] =
            std::next(waiting.begin(), random.index(static_cast<int>(waiting.size())))->second;
        const double lower = static_cast<double>(key) * random.uniform(0.9, 1);
        key = static_cast<float>(lower);
        queue.lower(place, lower);
      } else {
        auto least = waiting.begin();
        for (auto i = waiting.begin(); i != waiting.end(); ++i) {
          if (i->second.first < least->second.first) least = i;
        }
        ASSERT_FALSE(queue.empty());
        ASSERT_EQ(queue.pop(), least->first);
        front = std::max(front, static_cast<double>(least->second.first));
        waiting.erase(least);
      }
    }
    EXPECT_EQ(queue.empty(), waiting.empty());
  }
}

}  // namespace
}  // namespace karcher

#include "distance/window_distance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>
#include <string>

#include "distance_meshes.h"
#include "generators/flat.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "support.h"

namespace karcher {
namespace {

TEST(WindowDistance, IsRightForEdgesFrom1To1E12) {
  // The sources and targets are all pairs of the grid's vertices: distances are straight.
  const TriangleSoup soup = wideGrid(24, 6);
  const TriangleMesh mesh = buildMesh(soup.positions, soup.triangles);
  const Geometry geometry = buildGeometry(mesh);
  WindowDistance distance(geometry);
  for (int source = 0; source < mesh.vertexCount(); ++source) {
    distance.setSource(vertexPoint(mesh, source));
    distance.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double straight = (mesh.positions[v] - mesh.positions[source]).norm();
      EXPECT_NEAR(distance.distance(v), straight, 1e-11 * straight)
          << "from vertex " << source << " to " << v;
    }
  }
}

TEST(WindowDistance, NamesARangeOfEdgesThatIsTooWide) {
  const TriangleSoup soup = wideGrid(24, 6);
  Array<Vec3> positions = soup.positions;
  for (Vec3& p : positions)
    p.x() = std::max(p.x(), 3.0);  // the first column is moved to the second
  const TriangleMesh mesh = buildMesh(positions, soup.triangles);
  const Geometry geometry = buildGeometry(mesh);
  try {
    WindowDistance distance(geometry);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too wide a range"), std::string::npos);
  }
}

/// The vector of length d from a vertex along the shortest path towards the source, in space, for
/// surfaces in the plane z = 0.
Vec3 stepToSource(const MeasuredMesh& surface, const WindowDistance& solver, int v) {
  const CornerDirection corner = cornerOfDirection(surface.geometry, v, solver.direction(v));
  const Vec2 edge = halfedgeInFace(surface.geometry, corner.halfedge).normalized();
  return solver.distance(v) *
         toSpace(surface.geometry, faceOf(corner.halfedge), rotate(unitVector(corner.angle), edge));
}

TEST(WindowDistance, IsEuclideanInThePlane) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const MeasuredMesh surface(tessellatedPlane(tessellation, 1500, 3));
    WindowDistance solver(surface.geometry);
    Random random(17);
    for (int i = 0; i < (longRun() ? 100 : 5); ++i) {
      const SurfacePoint source = randomPlace(surface.mesh, random);
      const Vec3 p = position(surface.mesh, source);
      solver.setSource(source);
      solver.grow(kInfinity);
      for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        const Vec3 step = p - surface.mesh.positions[v];
        ASSERT_NEAR(solver.distance(v), step.norm(), 1e-12);
        ASSERT_LE((stepToSource(surface, solver, v) - step).norm(), 1e-11);
      }
    }
  }
}

TEST(WindowDistance, KeepsItsAccuracyOnNeedles) {
  TriangleSoup soup = tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 1500, 4);
  for (Vec3& p : soup.positions) p.x() *= 1e5;
  const MeasuredMesh surface(soup);
  WindowDistance solver(surface.geometry);
  Random random(18);
  for (int i = 0; i < (longRun() ? 200 : 4); ++i) {
    const SurfacePoint source = randomPlace(surface.mesh, random);
    const Vec3 p = position(surface.mesh, source);
    solver.setSource(source);
    solver.grow(kInfinity);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
      const double truth = (p - surface.mesh.positions[v]).norm();
      ASSERT_NEAR(solver.distance(v), truth, 1e-11 * truth + 1e-12);
    }
  }
}

TEST(WindowDistance, IsNoShorterThanStraightAtTheEndOfANeedle) {
  // The mesh is two needles on an edge of 1e-10, and the triangle between them. The sources are all
  // corners of each needle.
  const Array<Vec3> positions{{0, 0, 0}, {1e-10, 0, 0}, {0, 8, 0}, {9, 14, 0}};
  for (int turn = 0; turn < 9; ++turn) {
    SCOPED_TRACE("turned " + std::to_string(turn));
    Triangle needles[2] = {{0, 1, 2}, {0, 3, 1}};
    std::rotate(needles[0].data(), needles[0].data() + turn % 3, needles[0].data() + 3);
    std::rotate(needles[1].data(), needles[1].data() + turn / 3, needles[1].data() + 3);
    const TriangleMesh mesh = buildMesh(positions, {needles[0], {3, 0, 2}, needles[1]});
    const Geometry geometry = buildGeometry(mesh);
    WindowDistance distance(geometry);
    for (int source = 0; source < 4; ++source) {
      distance.setSource(vertexPoint(mesh, source));
      distance.grow(kInfinity);
      for (int v = 0; v < 4; ++v) {
        const double straight = (positions[v] - positions[source]).norm();
        EXPECT_GE(distance.distance(v), (1 - 1e-14) * straight) << source << " to " << v;
        EXPECT_LE(distance.distance(v), straight + 1e-9) << source << " to " << v;
      }
    }
  }
}

TEST(WindowDistance, LosesNoRegionOfARegularGrid) {
  // Every vertex lies exactly behind others, and every path has equally long ones.
  const MeasuredMesh surface(planeGrid(30, 30));
  WindowDistance solver(surface.geometry);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(15, 15, 0), Vec3(7.5, 7.5, 0), Vec3(10.5, 3, 0)}) {
    solver.setSource(nearestPoint(surface.mesh, p));
    solver.grow(kInfinity);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
      ASSERT_NEAR(solver.distance(v), (p - surface.mesh.positions[v]).norm(), 1e-12);
    }
  }
}

TEST(WindowDistance, AgreesWithAnotherLibrary) {
  const MeasuredMesh surface(bunnyMesh());
  WindowDistance solver(surface.geometry);
  std::ifstream in = testData("bunny_exact_distances.txt");
  std::string line;
  int sources = 0;
  while (std::getline(in, line)) {
    if (line[0] == '#') continue;
    std::istringstream header(line);
    int face = 0;
    int count = 0;
    Vec3 bary;
    header >> face >> bary[0] >> bary[1] >> bary[2] >> count;
    solver.setSource(checkedPoint(surface.mesh, face, bary));
    solver.grow(kInfinity);
    ++sources;
    for (int i = 0; i < count; ++i) {
      int v = 0;
      double expected = 0;
      in >> v >> expected;
      // The file has twelve decimals.
      EXPECT_NEAR(solver.distance(v), expected, 1e-10 * expected + 1e-12) << "vertex " << v;
    }
    std::getline(in, line);
  }
  EXPECT_EQ(sources, 6);
}

TEST(WindowDistance, UnrollsTheCylinder) {
  const FlatCylinder cylinder = flatCylinder(40, 3, 6);
  const MeasuredMesh surface(cylinder.soup);
  WindowDistance solver(surface.geometry);
  for (int source = 0; source < surface.mesh.vertexCount(); source += 97) {
    solver.setSource(vertexPoint(surface.mesh, source));
    solver.grow(kInfinity);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
      const double truth =
          cylinderDistance(cylinder, cylinder.unrolled[source], cylinder.unrolled[v]);
      ASSERT_NEAR(solver.distance(v), truth, 1e-12);
    }
  }
}

TEST(WindowDistance, UnrollsTheCone) {
  for (const double angle : {2.0, 4.0, 6.0}) {
    const FlatCone cone = flatCone(30, angle, 6);
    const MeasuredMesh surface(cone.soup);
    WindowDistance solver(surface.geometry);
    for (int source = 0; source < surface.mesh.vertexCount(); source += 61) {
      solver.setSource(vertexPoint(surface.mesh, source));
      solver.grow(kInfinity);
      for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        // The chord of the bottom's polygon cuts into the unrolled disk, and paths follow it there;
        // so points near the rim do not count.
        if (cone.unrolled[v].x() > 0.5 || cone.unrolled[source].x() > 0.5) continue;
        const double truth = coneDistance(cone, cone.unrolled[source], cone.unrolled[v]);
        ASSERT_NEAR(solver.distance(v), truth, 1e-12);
      }
    }
  }
}

TEST(WindowDistance, TurnsAroundAReentrantCorner) {
  const MeasuredMesh surface(lShape(6));
  const Vec3 corner(6, 6, 0);
  WindowDistance solver(surface.geometry);
  for (const Vec3& p : {Vec3(10.3, 4.6, 0), Vec3(11, 6, 0), Vec3(8, 5.5, 0), Vec3(1, 1, 0)}) {
    solver.setSource(nearestPoint(surface.mesh, p));
    solver.grow(kInfinity);
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
      const Vec3& q = surface.mesh.positions[v];
      // The corner obstructs the path if it lies on the inner side of the straight line.
      const Vec3 toQ = q - p;
      const bool aroundCorner = q.y() > 6 && p.x() > 6 && toQ.cross(corner - p).z() > 0;
      const bool turns = aroundCorner && q.x() <= 6;
      const double truth = turns ? (corner - p).norm() + (q - corner).norm() : toQ.norm();
      ASSERT_NEAR(solver.distance(v), truth, 1e-12) << q.transpose();
      if (turns && (q - corner).norm() > 0 && toQ.cross(corner - p).z() > 1e-9) {
        EXPECT_NEAR(solver.arrival(v).pseudoSourceDistance, (corner - p).norm(), 1e-12);
        const Vec3 step = stepToSource(surface, solver, v).normalized();
        EXPECT_LE((step - (corner - q).normalized()).norm(), 1e-9);
      }
    }
  }
}

TEST(WindowDistance, ConvergesToTheSphere) {
  double previous = kInfinity;
  for (const int frequency : {4, 8, 16}) {
    const MeasuredMesh surface(icosphere(frequency));
    WindowDistance solver(surface.geometry);
    const SurfacePoint source{3, Vec3(0.2, 0.3, 0.5)};
    const Vec3 p = position(surface.mesh, source).normalized();
    solver.setSource(source);
    solver.grow(kInfinity);
    double worst = 0;
    for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
      const Vec3& q = surface.mesh.positions[v];
      const double arc = std::atan2(p.cross(q).norm(), p.dot(q));
      worst = std::max(worst, std::abs(solver.distance(v) - arc));
    }
    EXPECT_LT(worst, previous / 3) << "the inscribed surface is off by O(h^2)";
    previous = worst;
  }
  EXPECT_LT(previous, 3e-3);
}

TEST(WindowDistance, IsSymmetric) {
  const MeasuredMesh surface(bunnyMesh());
  WindowDistance from(surface.geometry);
  WindowDistance back(surface.geometry);
  Random random(23);
  for (int i = 0; i < (longRun() ? 500 : 12); ++i) {
    const int v = random.index(surface.mesh.vertexCount());
    const SurfacePoint p = randomPlace(surface.mesh, random);
    from.setSource(vertexPoint(surface.mesh, v));
    from.grow(kInfinity);
    back.setSource(p);
    back.grow(kInfinity);
    const PointLocation location = locate(surface.mesh, p);
    if (location.simplex == Simplex::kVertex) {
      EXPECT_NEAR(from.distance(location.vertex), back.distance(v), 1e-12 * back.distance(v));
    } else if (!liesInFace(surface.mesh, locate(surface.mesh, vertexPoint(surface.mesh, v)),
                           p.face)) {
      from.setSource(vertexPoint(surface.mesh, v));
      from.setTarget(p);
      from.grow(kInfinity);
      EXPECT_NEAR(from.targetArrival().arrival.distance, back.distance(v),
                  1e-12 * back.distance(v));
    }
  }
}

TEST(WindowDistance, ResumedIsTheSameBitForBit) {
  const MeasuredMesh surface(bunnyMesh());
  WindowDistance whole(surface.geometry);
  WindowDistance resumed(surface.geometry);
  Random random(29);
  for (int i = 0; i < (longRun() ? 100 : 6); ++i) {
    const SurfacePoint source = randomPlace(surface.mesh, random);
    whole.setSource(source);
    whole.grow(kInfinity);
    resumed.setSource(source);
    for (double radius = 0; resumed.reached() < kInfinity; radius += random.uniform(0, 2)) {
      resumed.grow(radius);
      EXPECT_GT(resumed.reached(), radius);
      for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
        ASSERT_EQ(resumed.isFinal(v), whole.distance(v) <= resumed.reached());
        if (!resumed.isFinal(v)) continue;
        ASSERT_EQ(resumed.distance(v), whole.distance(v));
        ASSERT_EQ(resumed.direction(v), whole.direction(v));
      }
    }
  }
}

TEST(WindowDistance, StaysOnItsComponent) {
  const MeasuredMesh sphere(icosphere(2));
  const MeasuredMesh surface(together(sphere.mesh, sphere.mesh, Vec3(5, 0, 0)));
  WindowDistance solver(surface.geometry);
  solver.setSource({2, Vec3(0.3, 0.3, 0.4)});
  solver.grow(kInfinity);
  for (int v = 0; v < surface.mesh.vertexCount(); ++v) {
    EXPECT_EQ(solver.distance(v) == kInfinity, v >= sphere.mesh.vertexCount());
  }
}

TEST(WindowDistance, TouchesOnlyTheNeighbourhood) {
  const MeasuredMesh surface(planeGrid(100, 100));
  WindowDistance solver(surface.geometry);
  solver.setSource(nearestPoint(surface.mesh, Vec3(50.2, 49.9, 0)));
  solver.grow(5);
  int reached = 0;
  for (int v = 0; v < surface.mesh.vertexCount(); ++v) reached += solver.distance(v) < kInfinity;
  EXPECT_LT(reached, 200);
  EXPECT_GT(reached, 78);
}

TEST(WindowDistance, WindowsDoNotWindAroundATip) {
  // The cone is 1 wide and 1e5 high: paths once around it are so short that no vertex beats those
  // that wind ten thousand times.
  constexpr int kSides = 13;
  const TriangleSoup soup = wheel(kSides, 0, 1e5);
  const MeasuredMesh cone(buildMesh(soup.positions, soup.triangles));
  WindowDistance solver(cone.geometry);
  const double side = (cone.mesh.positions[1] - cone.mesh.positions[2]).norm();
  const double slant = (cone.mesh.positions[0] - cone.mesh.positions[1]).norm();
  solver.setSource(vertexPoint(cone.mesh, 1));
  solver.grow(kInfinity);
  EXPECT_NEAR(solver.distance(0), slant, 1e-12 * slant);
  for (int k = 1; k <= kSides / 2; ++k) {
    const double chord = 2 * slant * std::sin(k * std::asin(side / (2 * slant)));
    EXPECT_NEAR(solver.distance(1 + k), chord, 1e-6 * chord);
  }
  solver.setSource({3, Vec3(0.5, 0.2, 0.3)});
  solver.grow(kInfinity);
  EXPECT_EQ(solver.reached(), kInfinity);
}

TEST(WindowDistance, IsTheSameBothWaysPastNeedles) {
  // Everything that passes between the ends of a side of 1e-10 is narrower than the least window on
  // long sides. The sources include every needle's tip: these come last.
  const MeasuredMesh sheet(galleryMesh("rough sheet, needles 1e-10"));
  WindowDistance solver(sheet.geometry);
  const int count = sheet.mesh.vertexCount();
  Array<int> sources;
  for (int v = count - 1; v >= 0; v -= 7) sources.push_back(v);
  Array<Array<double>> from;
  for (const int v : sources)
    from.push_back(distancesFrom(solver, vertexPoint(sheet.mesh, v), count));
  double worst = 0;
  for (int i = 0; i < sources.count(); ++i) {
    for (int j = 0; j < i; ++j) {
      worst = std::max(worst, std::abs(from[i][sources[j]] - from[j][sources[i]]));
    }
  }
  EXPECT_LT(worst, 1e-12 * sheet.geometry.diagonal);
}

TEST(WindowDistance, IsStraightPastNeedlesOfAPlane) {
  const MeasuredMesh plane(galleryMesh("plane, needles 1e-10"));
  WindowDistance solver(plane.geometry);
  const int count = plane.mesh.vertexCount();
  for (int source = count - 1; source >= 0; source -= 31) {
    const Array<double> lengths = distancesFrom(solver, vertexPoint(plane.mesh, source), count);
    for (int v = 0; v < count; ++v) {
      const double straight = (plane.mesh.positions[v] - plane.mesh.positions[source]).norm();
      EXPECT_NEAR(lengths[v], straight, 1e-12 * plane.geometry.diagonal) << source << " to " << v;
    }
  }
}

/// The distance between two vertices, which must be the same both ways.
double bothWays(const MeasuredMesh& surface, int a, int b) {
  WindowDistance solver(surface.geometry);
  const int count = surface.mesh.vertexCount();
  const double there = distancesFrom(solver, vertexPoint(surface.mesh, a), count)[b];
  const double back = distancesFrom(solver, vertexPoint(surface.mesh, b), count)[a];
  EXPECT_NEAR(there, back, 1e-12) << a << " to " << b;
  return there;
}

TEST(WindowDistance, GoesStraightAlongABoundaryPastAShortEdge) {
  // The boundary runs up the z axis, its first edge 1e-11 long.
  const MeasuredMesh fan(
      buildMesh({{0, 0, 0}, {0, 0, 1e-11}, {0, 0, 1}, {0, 0, 1.0001}, {1, 0, 1.001}},
                {{0, 1, 4}, {1, 2, 4}, {4, 2, 3}}));
  EXPECT_NEAR(bothWays(fan, 0, 3), 1.0001, 1e-12);
  EXPECT_NEAR(bothWays(fan, 0, 2), 1, 1e-12);
}

TEST(WindowDistance, EntersASliverThroughItsTip) {
  // The sliver 0, 3, 1 is 1e-11 high. Seen from 4, on the line of its long side, the sliver and
  // everything behind it are in the shadow of 3, which is flat up to 3e-12.
  const MeasuredMesh strip(
      buildMesh({{0, 0, 0}, {1, 0, 1e-11}, {0.01, 0, 1}, {4, 0, 0}, {8, 0, 0}, {0.01, 0, 1}},
                {{1, 0, 3}, {0, 4, 5}, {5, 3, 0}, {1, 2, 0}, {5, 4, 3}}));
  EXPECT_NEAR(bothWays(strip, 4, 1), 7, 1e-10);
  // The path continues straight in the plane of the last triangle.
  EXPECT_NEAR(bothWays(strip, 4, 2), 7 + std::hypot(0.99, 1), 1e-10);
}

TEST(WindowDistance, ChoosesAmongPathsOfEqualLengthByNumbers) {
  // On a lattice many vertices have two shortest paths. A rotated lattice differs only by rounding.
  const MeasuredMesh plate(galleryMesh("plate with 50 holes"));
  const Eigen::AngleAxisd turn(1.234, Vec3(1, -2, 0.7).normalized());
  Array<Vec3> positions = plate.mesh.positions;
  for (Vec3& p : positions) p = turn * p + Vec3(200, -100, 150);
  const MeasuredMesh turned(buildMesh(positions, plate.mesh.faces));
  WindowDistance solver(plate.geometry);
  WindowDistance other(turned.geometry);
  solver.keepMidpoints();
  other.keepMidpoints();
  for (int source = 0; source < plate.mesh.vertexCount(); source += 19) {
    for (const auto& [distance, mesh] : {std::pair{&solver, &plate.mesh}, {&other, &turned.mesh}}) {
      distance->setSource(vertexPoint(*mesh, source));
      distance->grow(kInfinity);
    }
    for (int v = 0; v < plate.mesh.vertexCount(); ++v) {
      ASSERT_LT((solver.logVector(v) - other.logVector(v)).norm(), 1e-9) << source << " to " << v;
    }
    for (int h = 0; h < plate.mesh.halfedgeCount(); ++h) {
      if (h > plate.mesh.twin[h]) continue;
      const Vec2 difference = solver.midpointOf(h).toSource - other.midpointOf(h).toSource;
      ASSERT_LT(difference.norm(), 1e-9) << source << " to the middle of half-edge " << h;
    }
  }
}

TEST(WindowDistance, WindsAroundANeedleOnceAtMost) {
  // All faces around the tip are alike: unrolled they are a part of a disk, and paths are straight.
  for (const int faces : {300, 1000, 3000}) {
    const TriangleSoup soup = wheel(faces, 0, 1e4);
    const MeasuredMesh needle(buildMesh(soup.positions, soup.triangles));
    const double side = std::hypot(1e4, 1);
    const double angle = 2 * std::asin(std::sin(kPi / faces) / side);
    for (const double tolerance : {0.0, 0.0075}) {
      WindowDistance solver(needle.geometry, tolerance);
      for (const Vec2& place :
           {Vec2(0.15, 0.05), Vec2(0.27, 0.03), Vec2(0.17, 0.66), Vec2(0.1, 0.13)}) {
        const int face = faces / 3;
        SCOPED_TRACE(faces);
        solver.setSource({face, {1 - place.x() - place.y(), place.x(), place.y()}});
        solver.grow(kInfinity);
        const Vec2 source = place.x() * Vec2(side, 0) + place.y() * side * unitVector(angle);
        EXPECT_NEAR(solver.distance(0), source.norm(), 1e-9 * source.norm());
        for (int i = 0; i < faces; ++i) {
          const double turn = std::abs((i - face) * angle - angleOf(source));
          const double half = std::min(turn, faces * angle - turn) / 2;
          const double across = 2 * std::sqrt(source.norm() * side) * std::sin(half);
          const double expected = std::hypot(side - source.norm(), across);
          ASSERT_NEAR(solver.distance(1 + i), expected, 1e-9 * expected) << "to vertex " << 1 + i;
        }
      }
    }
  }
}

/// The long edges of spikes dominate the mean edge, but windows do not cross the short edges
/// between them again and again.
TEST(WindowDistance, CarriesFewUselessWindowsAmongSpikes) {
  Random random(20261127);
  TriangleSoup soup = makeShape(Shape::kSphere, 4000);
  for (Vec3& p : soup.positions) {
    if (random.uniform() < 0.3) p *= 1 + 20 * random.uniform();
  }
  const MeasuredMesh spiked(std::move(soup));
  WindowDistance distance(spiked.geometry);
  for (int i = 0; i < 4; ++i) {
    distance.setSource(randomPlace(spiked.mesh, random));
    distance.grow(kInfinity);
    EXPECT_LE(distance.windowsCarried(), 20 * spiked.mesh.faceCount());
  }
}

TEST(WindowDistance, RefusesATargetAtAVertex) {
  const MeasuredMesh surface(planeGrid(2, 2));
  WindowDistance solver(surface.geometry);
  solver.setSource(vertexPoint(surface.mesh, 0));
  EXPECT_THROW(solver.setTarget(vertexPoint(surface.mesh, 8)), Error);
}

}  // namespace
}  // namespace karcher

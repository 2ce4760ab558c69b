#include "rcm/voronoi.h"

#include <gtest/gtest.h>

#include <numeric>

#include "distance/graph_distance.h"
#include "distance/window_distance.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/region_drawings.h"
#include "measures/gauss_bonnet.h"
#include "mesh/shapes.h"
#include "random_surfaces.h"
#include "rcm/centroid.h"
#include "support.h"

/// Voronoi diagrams and centroids against half-planes and closed forms. Those of
/// `karcher/statistics` are the same (tests/wasm/voronoi.test.mjs).
namespace karcher {
namespace {

using Sites = Array<Array<SurfacePoint>>;

VoronoiDiagram exactDiagram(const Geometry& geometry, const Sites& sites) {
  WindowDistance solver(geometry);
  return voronoi(geometry, solver, sites);
}

/// The area and the centroid of a plane polygon.
struct PlanePart {
  double area = 0;
  Vec2 centroid = Vec2::Zero();
};

/// The part of a rectangle nearest to one of several places: the rectangle, clipped by bisectors.
PlanePart nearestPart(const Vec2& size, const Array<Vec2>& places, int own) {
  Array<Vec2> polygon = {{0, 0}, {size.x(), 0}, size, {0, size.y()}};
  for (int other = 0; other < places.count(); ++other) {
    if (other == own) continue;
    const auto beyond = [&](const Vec2& p) {
      return (p - places[own]).squaredNorm() - (p - places[other]).squaredNorm();
    };
    Array<Vec2> kept;
    for (int k = 0; k < polygon.count(); ++k) {
      const Vec2 p = polygon[k];
      const Vec2 q = polygon[(k + 1) % polygon.count()];
      if (beyond(p) <= 0) kept.push_back(p);
      if ((beyond(p) <= 0) != (beyond(q) <= 0)) {
        kept.push_back(p + beyond(p) / (beyond(p) - beyond(q)) * (q - p));
      }
    }
    polygon = kept;
  }
  PlanePart part;
  for (int k = 0; k < polygon.count(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2& b = polygon[(k + 1) % polygon.count()];
    part.area += cross(a, b) / 2;
    part.centroid += cross(a, b) / 6 * (a + b);
  }
  part.centroid /= part.area;
  return part;
}

Vec2 planePlace(const TriangleMesh& mesh, const SurfacePoint& point) {
  return position(mesh, point).head<2>();
}

/// Sites in the plane mesh from the origin to `size` against half-planes.
void expectHalfPlanes(const TriangleMesh& mesh, const Vec2& size, Random& random, int count) {
  Surface surface(mesh);
  const Geometry& geometry = surface.geometry();
  Array<Vec2> places;
  Sites sites;
  while (places.count() < count) {
    const SurfacePoint site = randomPlace(mesh, random);
    const Vec2 place = planePlace(mesh, site);
    if (std::find(places.begin(), places.end(), place) != places.end()) continue;
    sites.push_back({site});
    places.push_back(place);
  }
  const VoronoiDiagram diagram = exactDiagram(geometry, sites);
  const double rounding = 1e-9 * size.squaredNorm();
  for (int i = 0; i < count; ++i) {
    const PlanePart part = nearestPart(size, places, i);
    EXPECT_NEAR(diagram.areas[i], part.area, rounding);
    const Region cell = cellOfSite(diagram, i);
    EXPECT_NEAR(areaOf(diagram.arrangement, cell), diagram.areas[i], rounding);
    EXPECT_EQ(boundaryOf(diagram.arrangement, cell).count(), 1);
    if (i >= 5) continue;
    const Mean mean = centroid(surface, diagram.arrangement, cell);
    EXPECT_LT((planePlace(mesh, mean.point) - part.centroid).norm(), 1e-6 * size.norm());
  }
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Vec2 place = mesh.positions[v].head<2>();
    double least = kInfinity;
    for (const Vec2& site : places) least = std::min(least, (place - site).norm());
    EXPECT_NEAR((place - places[diagram.nearest[v]]).norm(), least, rounding);
  }
}

TEST(Voronoi, OfRandomPointsOfAPlaneHasHalfPlanesAsCells) {
  for (int i = 0; i < 4; ++i) {
    const uint64_t seed = seedOf(4100, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expectHalfPlanes(planeGrid(8, 5), Vec2(8, 5), random, 12);
    const TriangleSoup soup = tessellatedPlane(PlaneTessellation::kRandomDelaunay, 300, seed);
    expectHalfPlanes(meshOf(soup), Vec2(1, 1), random, 30);
  }
}

TEST(Voronoi, HoldsWhereManySitesShareATriangle) {
  const uint64_t seed = seedOf(4200, 0);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  expectHalfPlanes(planeGrid(1, 1), Vec2(1, 1), random, 150);
}

TEST(Voronoi, OfPointsAtVerticesHasBordersAlongEdges) {
  Surface surface(planeGrid(8, 8));
  const TriangleMesh& mesh = surface.mesh();
  Sites sites;
  for (const int v : {2 + 9 * 2, 6 + 9 * 2, 2 + 9 * 6, 6 + 9 * 6}) {
    sites.push_back({vertexPoint(mesh, v)});
  }
  const VoronoiDiagram diagram = exactDiagram(surface.geometry(), sites);
  for (const double area : diagram.areas) EXPECT_NEAR(area, 16, 1e-9);
  const Region cell = cellOfSite(diagram, 3);
  const Array<Array<int>> loops = boundaryOf(diagram.arrangement, cell);
  ASSERT_EQ(loops.count(), 1);
  EXPECT_NEAR(pathOf(surface.geometry(), diagram.arrangement, loops[0]).length(), 16, 1e-9);
  const Mean mean = centroid(surface, diagram.arrangement, cell);
  EXPECT_LT((planePlace(mesh, mean.point) - Vec2(6, 6)).norm(), 1e-6);
}

TEST(Voronoi, OfTwoOppositePointsOfASphereHasHalvesAsCells) {
  Surface surface(meshOf(icosphere(12)));
  const TriangleMesh& mesh = surface.mesh();
  // An icosahedron's vertices lie opposite to one another, and so do those of its divided faces.
  const SurfacePoint pole = vertexPoint(mesh, 0);
  const Vec3 axis = position(mesh, pole);
  const SurfacePoint other = nearestPoint(mesh, -axis);
  const VoronoiDiagram diagram = exactDiagram(surface.geometry(), {{pole}, {other}});
  const double whole = surfaceArea(surface.geometry());
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(diagram.areas[i], whole / 2, 1e-6 * whole);
    const Mean mean = centroid(surface, diagram.arrangement, cellOfSite(diagram, i));
    EXPECT_LT((position(mesh, mean.point) - (i == 0 ? axis : Vec3(-axis))).norm(), 5e-3);
  }
}

/// tests/wasm/voronoi.test.mjs has the same numbers.
TEST(Voronoi, OfATorusIsThatOfJavaScript) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kTorus, 800));
  Sites sites;
  for (const Vec3& place :
       {Vec3(1.4, 0, 0), Vec3(0, 1.3, 0.2), Vec3(-0.9, -0.4, -0.3), Vec3(0.2, -1, 0.4)}) {
    sites.push_back({nearestPoint(mesh, place)});
  }
  const double areas[] = {3.385178194343, 4.176408647218, 4.360231414790, 3.558260310662};
  const VoronoiDiagram diagram = exactDiagram(buildGeometry(mesh), sites);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(diagram.areas[i], areas[i], 1e-9);
}

TEST(Voronoi, AreasOfRandomSurfacesAddUpAndSitesLieInTheirCells) {
  const int count = longRun() ? 100 : 12;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(4300, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const TriangleMesh mesh = meshOf(randomSurface(random));
    const Geometry geometry = buildGeometry(mesh);
    Sites sites;
    for (int k = 0; k < 8; ++k) sites.push_back({randomPlace(mesh, random)});
    for (int k = 0; k < 8; ++k)
      sites.push_back({vertexPoint(mesh, random.index(mesh.vertexCount()))});
    const VoronoiDiagram diagram = exactDiagram(geometry, sites);
    double sum = 0;
    for (int site = 0; site < sites.count(); ++site) {
      sum += diagram.areas[site];
      // A piece of each cell has a vertex or a part of a face: Gauss and Bonnet hold for its
      // border.
      const GaussBonnet both =
          gaussBonnet(geometry, diagram.arrangement, cellOfSite(diagram, site));
      EXPECT_NEAR(both.curvature, 2 * kPi * both.euler, 1e-6);
    }
    for (int c = 0; c < diagram.arrangement.cellCount(); ++c) {
      if (diagram.siteOfCell[c] < 0) sum += diagram.arrangement.cellArea[c];
    }
    EXPECT_NEAR(sum, surfaceArea(geometry), 1e-9 * surfaceArea(geometry));
    // A site at a vertex is nearest there, or another one at that vertex.
    for (const Array<SurfacePoint>& site : sites) {
      const PointLocation at = locate(mesh, site[0]);
      if (at.simplex != Simplex::kVertex) continue;
      const Vec3 place = position(mesh, sites[diagram.nearest[at.vertex]][0]);
      EXPECT_EQ(place, mesh.positions[at.vertex]);
    }
  }
}

TEST(Voronoi, TakesSitesOfSeveralPointsEqualOnesAndSeparateParts) {
  const TriangleMesh mesh = twoGrids();
  const Geometry geometry = buildGeometry(mesh);
  const auto at = [&](double x, double y) { return nearestPoint(mesh, Vec3(x, y, 0)); };
  const VoronoiDiagram diagram =
      exactDiagram(geometry, {{at(0, 0), at(3, 3)}, {at(1.5, 1.5)}, {at(1.5, 1.5)}});
  // Bisectors cut off two triangles with legs of 1.5.
  EXPECT_NEAR(diagram.areas[0], 2 * 1.5 * 1.5 / 2, 1e-9);
  EXPECT_NEAR(diagram.areas[1], 9 - 2 * 1.5 * 1.5 / 2, 1e-9);
  EXPECT_EQ(diagram.areas[2], 0);
  EXPECT_EQ(cellOfSite(diagram, 2), Region(diagram.siteOfCell.size(), 0));
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(diagram.nearest[v]<0, mesh.positions[v].x()> 5);
  }
  EXPECT_EQ(codeOf([&] { cellOfSite(diagram, 3); }), ErrorCode::kBadIndex);
  EXPECT_EQ(codeOf([&] { exactDiagram(geometry, {}); }), ErrorCode::kTooFewPoints);
  EXPECT_EQ(codeOf([&] { exactDiagram(geometry, {{at(0, 0)}, {}}); }), ErrorCode::kTooFewPoints);
}

TEST(Voronoi, OfNearlyEqualSitesDividesAllOfTheSurface) {
  const TriangleMesh mesh = planeGrid(4, 4);
  const Geometry geometry = buildGeometry(mesh);
  for (const double apart : {1e-7, 1e-10, 1e-13, 1e-15}) {
    Sites sites;
    for (int k = 0; k < 5; ++k) {
      sites.push_back({nearestPoint(mesh, Vec3(1.3 + k * apart, 2.2, 0))});
      sites.push_back({nearestPoint(mesh, Vec3(2.7, 1.1 - k * apart, 0))});
    }
    const VoronoiDiagram diagram = exactDiagram(geometry, sites);
    EXPECT_NEAR(std::accumulate(diagram.areas.begin(), diagram.areas.end(), 0.0), 16, 1e-8);
    double left = 0;
    for (int k = 0; k < 10; k += 2) left += diagram.areas[k];
    EXPECT_NEAR(left, nearestPart(Vec2(4, 4), {{1.3, 2.2}, {2.7, 1.1}}, 0).area, 1e-5);
  }
}

TEST(Centroid, OfADensityOnAPlaneIsItsCenterOfMass) {
  Surface surface(planeGrid(6, 6));
  const TriangleMesh& mesh = surface.mesh();
  Array<double> density;
  for (const Vec3& place : mesh.positions) density.push_back(place.x());
  // The integral of x is 6^3 / 2, that of x^2 is 6^4 / 3.
  const Mean all = centroid(surface, density);
  EXPECT_LT((planePlace(mesh, all.point) - Vec2(4, 3)).norm(), 1e-6);
  const auto at = [&](double x, double y) { return nearestPoint(mesh, Vec3(x, y, 0)); };
  const VoronoiDiagram diagram = exactDiagram(surface.geometry(), {{at(2, 3)}, {at(3, 3)}});
  // To the left of x = 2.5 the centroid is at 2/3 of that.
  const Mean left = centroid(surface, diagram.arrangement, cellOfSite(diagram, 0), density);
  EXPECT_LT((planePlace(mesh, left.point) - Vec2(5.0 / 3, 3)).norm(), 1e-6);
  // The mean squared distance of a square to its middle is 2 * 6^2 / 12; the faces' own centroids
  // are nearer by their moments, 1/36 of the two legs squared each.
  EXPECT_NEAR(centroid(surface).energy, 6 - 2.0 / 18, 1e-6);
}

TEST(Centroid, OfACapIsItsPole) {
  Surface surface(meshOf(makeShape(Shape::kSphere, 5000)));
  const TriangleMesh& mesh = surface.mesh();
  const Vec3 pole = Vec3(1, 2, 3).normalized();
  Array<double> density;
  for (const Vec3& place : mesh.positions) density.push_back(std::max(0.0, place.dot(pole)));
  const Mean mean = centroid(surface, density);
  EXPECT_LT((position(mesh, mean.point) - pole).norm(), 5e-3);
}

TEST(Centroid, RefusesBadDensitiesAndEmptyRegions) {
  Surface surface(planeGrid(3, 3));
  const auto codeFor = [&](const Array<double>& density) {
    return codeOf([&] { centroid(surface, density); });
  };
  Array<double> density(16, 0.0);
  EXPECT_EQ(codeFor(density), ErrorCode::kBadArgument);
  EXPECT_EQ(codeFor({1, 2}), ErrorCode::kBadArgument);
  density[15] = -1;
  EXPECT_EQ(codeFor(density), ErrorCode::kBadArgument);
  density[15] = std::nan("");
  EXPECT_EQ(codeFor(density), ErrorCode::kBadArgument);
  const Arrangement whole = arrange(surface.geometry(), {});
  EXPECT_EQ(codeOf([&] { centroid(surface, whole, Region(1, 0)); }), ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

#include "distance/shortest_path.h"

#include <gtest/gtest.h>

#include <string>

#include "distance_meshes.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "support.h"

namespace karcher {
namespace {

/// Checks that consecutive points share a face and differ, and pieces add up to the length.
void expectPathOnSurface(const TriangleMesh& mesh, const SurfacePath& path) {
  double length = 0;
  for (int i = 1; i < path.points.count(); ++i) {
    const SurfacePoint& a = path.points[i - 1];
    const SurfacePoint& b = path.points[i];
    EXPECT_TRUE(haveCommonFace(mesh, a, b)) << "points " << i - 1 << " and " << i;
    const double piece = (position(mesh, b) - position(mesh, a)).norm();
    if (path.length() > 0) {
      EXPECT_GT(piece, 0) << "point " << i << " is repeated";
    }
    length += piece;
  }
  EXPECT_NEAR(length, path.length(), 1e-9 * (1 + path.length()));
}

TEST(ShortestPath, InThePlaneIsTheStraightLine) {
  const TriangleMesh mesh = planeGrid(9, 7);
  const Geometry geometry = buildGeometry(mesh);
  const Array<Vec3> places{{0.3, 0.2, 0}, {8.4, 6.1, 0}, {4, 3, 0},
                           {4.5, 3, 0},   {0, 7, 0},     {9, 2.5, 0}};
  for (const Vec3& a : places) {
    for (const Vec3& b : places) {
      const SurfacePath path = shortestPath(geometry, nearestPoint(mesh, a), nearestPoint(mesh, b));
      EXPECT_NEAR(path.length(), (b - a).norm(), 1e-12);
      EXPECT_LT((position(mesh, path.points.front()) - a).norm(), 1e-12);
      EXPECT_LT((position(mesh, path.points.back()) - b).norm(), 1e-12);
      expectPathOnSurface(mesh, path);
    }
  }
}

TEST(ShortestPath, TurnsAroundTheCornerOfTheBoundary) {
  // The mesh is the square [0, 4]^2 without its upper right quarter, with a corner at (2, 2).
  const TriangleMesh square = planeGrid(4, 4);
  Array<Triangle> faces;
  for (const Triangle& f : square.faces) {
    const Vec3 c = (square.positions[f[0]] + square.positions[f[1]] + square.positions[f[2]]) / 3;
    if (c.x() < 2 || c.y() < 2) faces.push_back(f);
  }
  Array<Vec3> positions;
  Array<int> number(square.positions.size(), -1);
  for (Triangle& f : faces) {
    for (int k = 0; k < 3; ++k) {
      int& n = number[f[k]];
      if (n < 0) {
        n = positions.count();
        positions.push_back(square.positions[f[k]]);
      }
      f[k] = n;
    }
  }
  const TriangleMesh mesh = buildMesh(positions, faces);
  const Geometry geometry = buildGeometry(mesh);
  const Vec3 a(1.3, 3.6, 0);
  const Vec3 b(3.7, 1.2, 0);
  const SurfacePath path = shortestPath(geometry, nearestPoint(mesh, a), nearestPoint(mesh, b));
  const Vec3 corner(2, 2, 0);
  EXPECT_NEAR(path.length(), (corner - a).norm() + (b - corner).norm(), 1e-12);
  expectPathOnSurface(mesh, path);
}

TEST(ShortestPath, IsNoLongerThanLocallyShortestOnesOnTheBunny) {
  // Lengths by geometry-central's edge flips, which find a locally shortest path.
  struct Reference {
    int from, to;
    double length;
  };
  const Reference references[] = {
      {1151, 624, 15.798146815529}, {1284, 1193, 6.386033321309}, {126, 1181, 6.036919989023},
      {1199, 812, 5.308015668684},  {101, 452, 8.577243009890},   {95, 1140, 8.757386725514},
      {1758, 272, 1.852184906428},  {593, 858, 9.594397991102},   {295, 1107, 7.868908988918},
      {241, 1169, 8.507681017384},
  };
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  for (const Reference& r : references) {
    const SurfacePath path =
        shortestPath(geometry, vertexPoint(mesh, r.from), vertexPoint(mesh, r.to));
    EXPECT_LE(path.length(), r.length * (1 + 1e-10));
    EXPECT_GE(path.length(), (mesh.positions[r.from] - mesh.positions[r.to]).norm());
    expectPathOnSurface(mesh, path);
  }
}

TEST(ShortestPath, IsTheSameBothWaysAndObeysTheTriangleInequality) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 12;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const auto somewhere = [&] {
    const int face = random.index(mesh.faceCount());
    return random.index(3) == 0 ? edgePoint(3 * face, 0.37) : SurfacePoint{face, {0.2, 0.5, 0.3}};
  };
  for (int i = 0; i < (longRun() ? 500 : 12); ++i) {
    const SurfacePoint a = somewhere();
    const SurfacePoint b = somewhere();
    const SurfacePoint c = somewhere();
    const SurfacePath ab = shortestPath(geometry, a, b);
    EXPECT_NEAR(ab.length(), shortestPath(geometry, b, a).length(), 1e-10 * ab.length());
    EXPECT_LE(ab.length(),
              shortestPath(geometry, a, c).length() + shortestPath(geometry, c, b).length() + 1e-9);
    expectPathOnSurface(mesh, ab);
  }
}

TEST(ShortestPath, GoesStraightThroughTheSaddlesOfALattice) {
  // Straight lines meet vertices there, and the excess angle gives the path a choice of directions.
  const MeasuredMesh coarse(ringTube(0.4, 5, 16));
  const MeasuredMesh fine(ringTube(0.5, 8, 12));
  const MeasuredMesh plate(plateWithHoles(5, 5));
  for (const MeasuredMesh* surface : {&coarse, &fine, &plate}) {
    const TriangleMesh& mesh = surface->mesh;
    const uint64_t seed = 48;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    WindowDistance solver(surface->geometry);
    for (int i = 0; i < (longRun() ? 20'000 : 1000); ++i) {
      const SurfacePoint a = i % 2 == 0 ? vertexPoint(mesh, random.index(mesh.vertexCount()))
                                        : randomPlace(mesh, random);
      const int b = random.index(mesh.vertexCount());
      const SurfacePath path = shortestPath(surface->geometry, a, vertexPoint(mesh, b));
      expectPathOnSurface(mesh, path);
      const SurfacePath back = shortestPath(surface->geometry, vertexPoint(mesh, b), a);
      expectPathOnSurface(mesh, back);
      solver.setSource(a);
      solver.grow(kInfinity);
      EXPECT_NEAR(path.length(), solver.distance(b), 1e-11);
      EXPECT_NEAR(back.length(), solver.distance(b), 1e-11);
    }
  }
}

TEST(ShortestPath, IsContinuousOnNeedlesAndAlongTheBoundary) {
  TriangleSoup needles = tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 800, 2);
  for (Vec3& p : needles.positions) p.x() *= 1e4;
  const MeasuredMesh stretched(needles);
  const MeasuredMesh corner(lShape(5));
  for (const MeasuredMesh* surface : {&stretched, &corner}) {
    const TriangleMesh& mesh = surface->mesh;
    Array<int> boundary;
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      if (mesh.twin[h] < 0) boundary.push_back(h);
    }
    Random random(31);
    const auto onBoundary = [&] {
      const int h = boundary[random.index(boundary.count())];
      return edgePoint(h, random.index(2) == 0 ? 0 : random.uniform(0.01, 0.99));
    };
    WindowDistance solver(surface->geometry);
    for (int i = 0; i < (longRun() ? 5000 : 200); ++i) {
      const SurfacePoint a = i % 2 == 0 ? onBoundary() : randomPlace(mesh, random);
      const SurfacePoint b = onBoundary();
      const SurfacePath path = shortestPath(surface->geometry, a, b);
      expectPathOnSurface(mesh, path);
      const PointLocation end = locate(mesh, b);
      if (end.simplex != Simplex::kVertex) continue;
      solver.setSource(a);
      solver.grow(kInfinity);
      EXPECT_NEAR(path.length(), solver.distance(end.vertex), 1e-12 * (1 + path.length()));
    }
  }
}

TEST(ShortestPath, IsTheSameBothWaysInCapsAndNeedlesBesideItsStart) {
  struct Case {
    TriangleSoup soup;
    int vertex;
    int face;
  };
  // The first vertex lies much nearer to an end of an edge than the edge is long, and the path
  // leaves through that edge.
  const Case cases[] = {
      {{{{0, 0, 0},
         {1, 0, 0},
         {0.4199221320450306, 1, 0.429489100119099},
         {0.0804437161423266, -1, 0.3126797790173441},
         {0.4199227038254291, 0.9999950391829415, 0.4294869695022447},
         {0.000026904509156703366, 0.00006407020011530164, 0.000027517452591971493}},
        {{0, 4, 5}, {1, 0, 3}, {0, 1, 4}, {1, 2, 4}, {4, 2, 5}, {2, 0, 5}}},
       0,
       4},
      {{{{0, 0, 0},
         {1, 0, 0},
         {1.0890544475987554, 1, 0.163262631976977},
         {0.4685594504699111, -1, -0.34463859838433564},
         {0.000003477763026644095, 8.708325156488254e-7, 1.4217440851595922e-7},
         {1.0890457743110014, 0.9999920359326558, 0.16326133174238114},
         {0.01554350694199617, 0.014272474788097686, 0.0023301617987298755}},
        {{0, 1, 4}, {1, 0, 3}, {1, 2, 4}, {2, 0, 5}, {0, 4, 6}, {4, 2, 5}, {4, 5, 6}, {5, 0, 6}}},
       2,
       4},
      {{{{0, 0, 0},
         {1, 0, 0},
         {-0.4498168798163533, 1, 0.265129815088585},
         {0.9415282998234034, -1, 0.12933152331970632},
         {0.9992268115479519, 0.0005191269089788274, 0.00013763602138506525},
         {0.9397738513887852, 0.04152720752608423, 0.011010100852536007},
         {0.9991126822463846, 0.000597847846764822, 0.000158507289063866},
         {-0.44664083649298036, 0.9978093180422946, 0.26454899998622067}},
        {{4, 1, 5},
         {1, 0, 3},
         {2, 0, 4},
         {0, 1, 4},
         {1, 2, 5},
         {4, 5, 6},
         {2, 6, 7},
         {2, 4, 6},
         {6, 5, 7},
         {5, 2, 7}}},
       4,
       6}};
  for (const Case& each : cases) {
    const MeasuredMesh on(each.soup);
    const SurfacePoint from = vertexPoint(on.mesh, each.vertex);
    const SurfacePoint to{each.face, Vec3(0.2, 0.3, 0.5)};
    const SurfacePath path = shortestPath(on.geometry, from, to);
    const double back = shortestPath(on.geometry, to, from).length();
    EXPECT_NEAR(path.length(), back, 1e-9 * back);
    expectPathOnSurface(on.mesh, path);
  }
}

TEST(ShortestPath, WithoutRepetitionsStillLeadsFromFaceToFace) {
  // The edges 2 5 and 2 4 meet at the start. The path crosses both within rounding.
  const TriangleSoup soup{{{0, 0, 0},
                           {1, 0, 0},
                           {0.6075177621096373, 1, 0.23755574482493103},
                           {0.2122226911596954, -1, -0.288929435191676},
                           {0.9247899914971821, 0.1370455227153397, 0.03255595122356453},
                           {0.9018583033728542, 0.24437562600434476, 0.0580528338525209},
                           {0.02149210091693138, -0.00008080110263404357, -0.000023345816946918857},
                           {0.03590007797937639, -0.00959288533161729, -0.0027716669407226967}},
                          {{1, 2, 5},
                           {0, 3, 6},
                           {2, 0, 4},
                           {0, 1, 4},
                           {2, 4, 5},
                           {4, 1, 5},
                           {6, 3, 7},
                           {1, 0, 6},
                           {3, 1, 7},
                           {1, 6, 7}}};
  const MeasuredMesh on(soup);
  const SurfacePath path =
      shortestPath(on.geometry, vertexPoint(on.mesh, 2), vertexPoint(on.mesh, 6));
  const Array<int> kept = pointsWithoutRepetitions(on.mesh, path.points);
  for (int i = 1; i < kept.count(); ++i) {
    EXPECT_TRUE(haveCommonFace(on.mesh, path.points[kept[i - 1]], path.points[kept[i]])) << i;
  }
}

TEST(ShortestPath, RefusesPointsOnSeveralComponents) {
  const TriangleMesh mesh = twoGrids();
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint a = nearestPoint(mesh, Vec3(1, 1, 0));
  for (const Vec3& b : {Vec3(11, 1, 0), Vec3(11.3, 1.2, 0)}) {
    EXPECT_THROW(shortestPath(geometry, a, nearestPoint(mesh, b)), Error);
  }
}

}  // namespace
}  // namespace karcher

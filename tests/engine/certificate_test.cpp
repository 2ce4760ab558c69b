#include "rcm/certificate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "distance/shortest_path.h"
#include "distance_meshes.h"
#include "generators/random_points.h"
#include "intrinsic/tangent.h"
#include "mesh/positions.h"
#include "rcm/mean.h"
#include "support.h"

namespace karcher {
namespace {

/// Places inside faces, on edges, at vertices and just beside edges.
Array<SurfacePoint> placesOf(const TriangleMesh& mesh, Random& random) {
  Array<SurfacePoint> places;
  for (int i = 0; i < 5; ++i) {
    const SurfacePoint inside = randomPoint(mesh, random);
    places.push_back(inside);
    places.push_back({inside.face, Vec3(0, inside.bary[1] + inside.bary[0], inside.bary[2])});
    places.push_back({inside.face, Vec3(0, 1, 0)});
    places.push_back({inside.face, Vec3(1e-10, 0.5, 0.5 - 1e-10)});
  }
  return places;
}

bool isBeside(const SurfacePoint& place) {
  return place.bary.minCoeff() > 0 && place.bary.minCoeff() < 1e-9;
}

Array<SurfacePoint> randomPoints(const TriangleMesh& mesh, Random& random, int count) {
  Array<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(randomPoint(mesh, random));
  return points;
}

/// The certificate from the vertices' places in the plane, for a mesh that unrolls into it.
Certificate onPlane(const TriangleMesh& flat, const Array<SurfacePoint>& points,
                    const Array<double>& weights, const SurfacePoint& point) {
  Certificate result;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < points.count(); ++i) {
    const Vec3 way = position(flat, points[i]) - position(flat, point);
    result.energy += weights[i] * way.squaredNorm();
    sum += weights[i] * way;
  }
  result.residual = sum.norm();
  return result;
}

/// planeGrid(columns, rows) folded along its lines x = 1, 2, …: it unrolls into the plane.
TriangleMesh foldedGrid(int columns, int rows) {
  const TriangleMesh flat = planeGrid(columns, rows);
  TriangleSoup soup{flat.positions, {}};
  for (int f = 0; f < flat.faceCount(); ++f) {
    soup.triangles.push_back({flat.corner(f, 0), flat.corner(f, 1), flat.corner(f, 2)});
  }
  Array<Vec3> folds{Vec3::Zero()};
  for (int i = 0; i < columns; ++i) {
    const double angle = 0.2 * i;
    folds.push_back(folds.back() + Vec3(std::cos(angle), 0, std::sin(angle)));
  }
  for (Vec3& place : soup.positions) {
    const Vec3 fold = folds[static_cast<int>(std::lround(place.x()))];
    place = Vec3(fold.x(), place.y(), fold.z());
  }
  return meshOf(soup);
}

TEST(Certificate, IsTheClosedFormOnDevelopableSurfaces) {
  const TriangleMesh flat = planeGrid(9, 8);
  for (const TriangleMesh& shape : {planeGrid(9, 8), foldedGrid(9, 8)}) {
    const MeasuredMesh mesh(shape);
    Random random(51);
    SCOPED_TRACE("seed 51");
    const Array<double> weights{0.7, -0.4, 0.5, 0.2, 0};
    const Array<SurfacePoint> points = randomPoints(flat, random, weights.count());
    for (const SurfacePoint& place : placesOf(flat, random)) {
      const Certificate truth = onPlane(flat, points, weights, place);
      const Certificate found = certificateOf(mesh.geometry, points, weights, false, place);
      // Lengths up to 12 are exact up to a few units in the last place. Beside a side, a billionth
      // of a face moves the place by as much.
      EXPECT_NEAR(found.energy, truth.energy, isBeside(place) ? 1e-7 : 1e-11);
      EXPECT_NEAR(found.residual, truth.residual, isBeside(place) ? 1e-8 : 1e-11);
    }
  }
}

TEST(Certificate, DividesTheWeightsByTheirSumOnRequest) {
  const MeasuredMesh mesh(planeGrid(6, 6));
  Random random(52);
  SCOPED_TRACE("seed 52");
  const Array<SurfacePoint> points = randomPoints(mesh.mesh, random, 3);
  const SurfacePoint place = randomPoint(mesh.mesh, random);
  const Certificate one = certificateOf(mesh.geometry, points, {0.25, 0.25, 0.5}, false, place);
  const Certificate same = certificateOf(mesh.geometry, points, {1, 1, 2}, true, place);
  EXPECT_DOUBLE_EQ(one.energy, same.energy);
  EXPECT_DOUBLE_EQ(one.residual, same.residual);
}

TEST(Certificate, IsThatOfShortestPathsOnACurvedMesh) {
  const MeasuredMesh mesh(bunnyMesh());
  Random random(53);
  SCOPED_TRACE("seed 53");
  const Array<double> weights{0.3, 0.5, 0.4, -0.2};
  const Array<SurfacePoint> points = randomPoints(mesh.mesh, random, weights.count());
  for (const SurfacePoint& place : placesOf(mesh.mesh, random)) {
    double energy = 0;
    Vec2 sum = Vec2::Zero();
    for (int i = 0; i < points.count(); ++i) {
      const SurfacePath path = shortestPath(mesh.geometry, place, points[i]);
      energy += weights[i] * square(path.length());
      sum += weights[i] * logAlong(mesh.geometry, path);
    }
    const Certificate found = certificateOf(mesh.geometry, points, weights, false, place);
    EXPECT_NEAR(found.energy, energy, 1e-9 * square(mesh.geometry.diagonal));
    // Beside a side a path's first piece is 1e-10 of an edge long, so that rounding affects its
    // direction.
    EXPECT_NEAR(found.residual, sum.norm(),
                (isBeside(place) ? 1e-4 : 1e-8) * mesh.geometry.diagonal);
  }
}

TEST(Certificate, HasNoResidualAtTheCenterOfASymmetry) {
  // A regular octahedron, with points in the three faces beside one, each the others rotated.
  TriangleSoup soup;
  soup.positions = {Vec3(1, 0, 0),  Vec3(0, 1, 0),  Vec3(0, 0, 1),
                    Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)};
  soup.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                    {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  const MeasuredMesh mesh(meshOf(soup));
  const Array<SurfacePoint> points{nearestPoint(mesh.mesh, Vec3(-0.2, 0.5, 0.3)),
                                   nearestPoint(mesh.mesh, Vec3(0.3, -0.2, 0.5)),
                                   nearestPoint(mesh.mesh, Vec3(0.5, 0.3, -0.2))};
  const double third = 1.0 / 3;
  const SurfacePoint middle{0, Vec3::Constant(third)};
  const Certificate found =
      certificateOf(mesh.geometry, points, {third, third, third}, false, middle);
  EXPECT_LT(found.residual, 1e-12);
  const double length = shortestPath(mesh.geometry, middle, points[0]).length();
  EXPECT_NEAR(found.energy, square(length), 1e-12);
}

TEST(Certificate, OfCentersThatConvergedOnASphereIsSmallAndNoEstimate) {
  Surface surface(meshOf(makeShape(Shape::kSphere, 5000)));
  const double edge = surface.geometry().meanEdge;
  Random random(54);
  SCOPED_TRACE("seed 54");
  for (const FieldOptions field : {FieldOptions{Method::kKarcher, Solver::kExact, 6},
                                   FieldOptions{Method::kKarcher, Solver::kFast, 6},
                                   FieldOptions{Method::kPaper, Solver::kGraph, 4}}) {
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint middle = randomPoint(surface.mesh(), random);
      Array<SurfacePoint> points;
      for (int k = 0; k < 4; ++k) {
        const Vec2 way = 0.6 * unitVector(kPi / 2 * k + 0.3 * i);
        points.push_back(traceStraightest(surface.geometry(), middle, way).path.end());
      }
      const Array<double> weights{0.4, 0.3, 0.2, 0.1};
      MeanOptions options;
      options.field = field;
      const Mean mean = centerOfMass(surface, points, weights, options);
      ASSERT_EQ(mean.status, Status::kConverged);
      const Certificate found =
          certificateOf(surface.geometry(), points, weights, false, mean.point);
      double energy = 0;
      for (int k = 0; k < 4; ++k) {
        energy +=
            weights[k] * square(shortestPath(surface.geometry(), points[k], mean.point).length());
      }
      EXPECT_NEAR(found.energy, energy, 1e-12);
      // The exact solver's fields miss the mesh's own minimum by at most hundredths of an edge.
      const bool isGraph = field.solver == Solver::kGraph;
      EXPECT_LT(found.residual, (isGraph ? 0.3 : 0.05) * edge);
      if (isGraph) {
        EXPECT_GT(std::abs(mean.energy - found.energy), 1e-6);
      }
    }
  }
}

}  // namespace
}  // namespace karcher

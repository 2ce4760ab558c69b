#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/control_polygons.h"
#include "generators/flat.h"
#include "generators/random_points.h"
#include "measures/drag.h"
#include "measures/turning.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

constexpr double kDegrees = 180 / kPi;

/// A circle's arc of many pieces around `center`, in the plane of x and y.
Array<Vec3> arcAround(const Vec3& center, double radius, double angle, int pieces = 32 * 500) {
  Array<Vec3> points;
  for (int i = 0; i <= pieces; ++i) {
    const Vec2 direction = unitVector(angle * i / pieces);
    points.push_back(center + radius * Vec3(direction.x(), direction.y(), 0));
  }
  return points;
}

TEST(Turning, OfAnArcInThePlaneIsItsAngle) {
  const TriangleMesh mesh = planeGrid(8, 8);
  const TurningMeasure measure(mesh);
  // 32 pieces meet at 31 places.
  EXPECT_NEAR(turning(measure, arcAround({4, 4, 0}, 3, 2)), 2 * kDegrees * 31 / 32, 1e-9);
  EXPECT_NEAR(turning(measure, arcAround({4, 4, 0}, 3, 2), 8), 2 * kDegrees * 7 / 8, 1e-9);
  EXPECT_NEAR(turning(measure, {{1, 1, 0}, {2, 2, 0}, {7, 7, 0}}), 0, 1e-9);
}

TEST(Turning, OfASphereIsThatOfGeodesicCurvature) {
  const TriangleMesh mesh = meshOf(icosphere(60));
  const TurningMeasure measure(mesh);
  for (const double height : {0.0, 0.3, 0.8}) {
    const double angle = 3;
    // In the tangent plane, pieces of the arc a along the circle at this height make the angle
    // atan(height tan(a / 2)) with its tangent.
    const double exact = 31 * 2 * std::atan(height * std::tan(angle / 64)) * kDegrees;
    // The normals of the mesh are off by about the square of an edge, 1e-3 rad.
    EXPECT_NEAR(turning(measure, arcAround({0, 0, height}, std::sqrt(1 - height * height), angle)),
                exact, 0.05);
  }
}

TEST(Turning, DoesNotSeeTheSurfaceBend) {
  // The line runs once around a cylinder, along a circle that is a geodesic.
  const FlatCylinder cylinder = flatCylinder(90, 2, 1);
  const TriangleMesh mesh = meshOf(cylinder.soup);
  double middle = 0;
  for (const Vec3& p : mesh.positions) middle += p.z() / mesh.vertexCount();
  EXPECT_LT(turning(TurningMeasure(mesh), arcAround({0, 0, middle}, 1, 2)), 1);
}

TEST(NearestOnMesh, AgreesWithAllFaces) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kTorus, 2000));
  const NearestOnMesh nearest(mesh);
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 place(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1, 1));
    const double distance = (position(mesh, nearest.at(place)) - place).norm();
    EXPECT_NEAR(distance, (position(mesh, nearestPoint(mesh, place)) - place).norm(), 1e-14);
  }
}

TEST(EvenlySpaced, DividesTheLength) {
  const Array<Vec3> places = evenlySpaced({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 2, 0}}, 4);
  const Array<Vec3> expected = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 2, 0}};
  for (int i = 0; i < 4; ++i) EXPECT_LT((places[i] - expected[i]).norm(), 1e-14);
}

double distanceOf(const Array<Vec3>& a, const Array<Vec3>& b) {
  return hausdorffDistance(MeasuredPolyline(a), MeasuredPolyline(b), 1e-9);
}

TEST(HausdorffDistance, OfSimplePolylines) {
  const Array<Vec3> line = {{0, 0, 0}, {2, 0, 0}};
  EXPECT_NEAR(distanceOf(line, line), 0, 1e-15);
  EXPECT_NEAR(distanceOf(line, {{0, 0.5, 0}, {2, 0.5, 0}}), 0.5, 1e-9);
  // Only the longer line has a point far from the other.
  EXPECT_NEAR(distanceOf(line, {{0, 0, 0}, {5, 0, 0}}), 3, 1e-9);
  EXPECT_NEAR(distanceOf({{0, 0, 0}, {5, 0, 0}}, line), 3, 1e-9);
  // The second polyline has other points of the same line.
  EXPECT_NEAR(distanceOf(line, {{0, 0, 0}, {0.3, 0, 0}, {1.1, 0, 0}, {2, 0, 0}}), 0, 1e-15);
}

TEST(HausdorffDistance, IsFoundInsideAPiece) {
  // The ends of the lower side lie on the other polyline, its middle lies 1 from three sides.
  EXPECT_NEAR(distanceOf({{0, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {0, 1, 0}, {2, 1, 0}, {2, 0, 0}}), 1,
              1e-9);
}

TEST(HausdorffDistance, OfArcsAroundACenterIsTheDifferenceOfRadii) {
  // Chords of length 2e-3 lie 5e-7 inside the circle.
  const MeasuredPolyline inner(arcAround({0, 0, 0}, 1, 2, 1000));
  const MeasuredPolyline outer(arcAround({0, 0, 0}, 1.25, 2, 1000));
  EXPECT_NEAR(hausdorffDistance(inner, outer, 1e-6), 0.25, 2e-6);
}

TEST(HausdorffDistance, AgreesWithDenseSamples) {
  Random random(3);
  const auto walk = [&] {
    Array<Vec3> points = {Vec3::Zero()};
    for (int i = 0; i < 40; ++i) {
      points.push_back(points.back() + Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
    }
    return points;
  };
  const MeasuredPolyline a(walk());
  const MeasuredPolyline b(walk());
  double largest = 0;
  constexpr int kPlaces = 20'000;
  for (const Vec3& p : evenlySpaced(a.points(), kPlaces)) {
    largest = std::max(largest, std::sqrt(b.nearest(p).squaredDistance));
  }
  for (const Vec3& p : evenlySpaced(b.points(), kPlaces)) {
    largest = std::max(largest, std::sqrt(a.nearest(p).squaredDistance));
  }
  // The places are about 60 / 20,000 apart.
  EXPECT_NEAR(hausdorffDistance(a, b, 1e-9), largest, 2e-3);
  EXPECT_GE(hausdorffDistance(a, b, 1e-9), largest - 1e-9);
}

TEST(RandomControlPolygon, HasTheGivenLegsAndAngles) {
  const TriangleMesh mesh = planeGrid(20, 20);
  const Geometry geometry = buildGeometry(mesh);
  Random random(17);
  const ControlPolygonOptions options{.points = 5, .spacing = 0.1};
  for (int i = 0; i < 50; ++i) {
    const Array<SurfacePoint> polygon = randomControlPolygon(geometry, random, options);
    ASSERT_EQ(polygon.count(), 5);
    for (int k = 1; k < 5; ++k) {
      const Vec3 leg = position(mesh, polygon[k]) - position(mesh, polygon[k - 1]);
      const double part = leg.norm() / geometry.diagonal;
      EXPECT_GE(part, 0.08 - 1e-12);
      EXPECT_LE(part, 0.12 + 1e-12);
      if (k == 1) continue;
      const Vec3 last = position(mesh, polygon[k - 1]) - position(mesh, polygon[k - 2]);
      EXPECT_LE(std::atan2(last.cross(leg).norm(), last.dot(leg)), options.turning + 1e-9);
    }
  }
  EXPECT_THROW(randomControlPolygon(geometry, random, {.spacing = 5}), std::runtime_error);
}

TEST(DragPath, GoesStraightInEvenSteps) {
  const TriangleMesh mesh = planeGrid(20, 20);
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint start = nearestPoint(mesh, {3.2, 4.1, 0});
  const Vec2 direction = toFace(geometry, start.face, Vec3(3, 4, 0));
  const Array<SurfacePoint> path = dragPath(geometry, start, direction, 0.1, 100);
  ASSERT_EQ(path.count(), 101);
  for (int i = 0; i <= 100; ++i) {
    const Vec3 expected = Vec3(3.2, 4.1, 0) + 0.1 * i * Vec3(0.6, 0.8, 0);
    EXPECT_LT((position(mesh, path[i]) - expected).norm(), 1e-12);
  }
  EXPECT_TRUE(dragPath(geometry, start, direction, 1, 100).empty());
}

TEST(CountStep, DistinguishesShiversFromPassages) {
  const auto lineAt = [](double y) { return MeasuredPolyline({{0, y, 0}, {9, y, 0}}); };
  DragFigures figures;
  EXPECT_NEAR(countStep(figures, lineAt(0), lineAt(0.4), 0.1), 4, 2e-2);
  EXPECT_EQ(figures.shivers, 0);
  countStep(figures, lineAt(0), lineAt(0.6), 0.1);
  EXPECT_EQ(figures.shivers, 1);
  EXPECT_NEAR(figures.largestLeap, 6, 2e-2);
  // A passage allows 8 steps, and the leap is 7.2.
  countStep(figures, lineAt(0), lineAt(0.72), 0.1, 0.8);
  EXPECT_EQ(figures.steps, 2);
  EXPECT_EQ(figures.passing, 1);
  EXPECT_EQ(figures.beyond, 0);
  EXPECT_NEAR(figures.largestPassing, 0.9, 1e-2);
  countStep(figures, lineAt(0), lineAt(0.9), 0.1, 0.8);
  EXPECT_EQ(figures.beyond, 1);
  // The function adds another cause of a leap in the same step.
  DragFigures both;
  countStep(both, lineAt(0), lineAt(0.9), 0.1, 0.8, [] { return 0.2; });
  EXPECT_EQ(both.beyond, 0);
  EXPECT_NEAR(both.largestPassing, 0.9, 1e-2);
  // A passage that allows less than a shiver excuses no leap.
  countStep(figures, lineAt(0), lineAt(0.72), 0.1, 0.4);
  EXPECT_EQ(figures.shivers, 2);
  EXPECT_NEAR(figures.shiverShare(), 2.0 / 3, 1e-15);
  EXPECT_NEAR(figures.passingShare(), 2.0 / 5, 1e-15);
}

TEST(PassedVertices, AreThoseBetweenTwoPaths) {
  // A hexagon of triangles lies around vertex 0, which is higher: a point of positive curvature.
  Array<Vec3> positions = {{0, 0, 0.3}};
  Array<Triangle> faces;
  for (int k = 0; k < 6; ++k) {
    const Vec2 corner = unitVector(k * kPi / 3);
    positions.emplace_back(corner.x(), corner.y(), 0);
    faces.emplace_back(0, 1 + k, 1 + (k + 1) % 6);
  }
  const TriangleMesh mesh = buildMesh(positions, faces);
  const Geometry geometry = buildGeometry(mesh);
  // Paths from face 5 to the opposite face, over the edges to corners 1 and 2 or 6 and 5.
  const auto over = [&](std::initializer_list<int> edges) {
    Array<SurfacePoint> path = {{5, Vec3(0.2, 0.4, 0.4)}};
    for (const int face : edges) path.push_back(edgePoint(3 * face, 0.5));
    path.push_back({2, Vec3(0.2, 0.4, 0.4)});
    return path;
  };
  // Half-edge 3 k runs from vertex 0 to corner 1 + k.
  const Array<SurfacePoint> left = over({0, 1, 2});
  const Array<SurfacePoint> right = over({5, 4, 3});
  const Array<VertexPassage> passages = passedVertices(geometry, left, right);
  ASSERT_EQ(passages.count(), 1);
  EXPECT_EQ(passages[0].vertex, 0);
  EXPECT_NEAR(passages[0].curvature, 2 * kPi - geometry.totalAngle[0], 1e-15);
  EXPECT_EQ(passedVertices(geometry, right, left).count(), 1);
  EXPECT_TRUE(passedVertices(geometry, left, left).empty());
}

TEST(AnglesBetween, AreTheCurvatureBetweenGeodesics) {
  // A cube's corner, of curvature pi / 2, lies between two geodesics from one of its faces to the
  // next: straight over the edge between, and through the third face.
  Array<Vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const TriangleMesh mesh = buildMesh(positions, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}});
  const double x = 0.2;
  const double y = 0.3;
  const SurfacePoint from{0, {1 - x - y, y, x}};
  const SurfacePoint to{2, {1 - x - y, x, y}};
  const SurfacePoint middle{0, {1 - x, 0, x}};
  const Array<SurfacePoint> straight = {from, middle, to};
  // Both points are equally far from the corner, so that unfolded around it the other path is the
  // base of an isosceles triangle.
  const double turn = 3 * kPi / 2 - 2 * std::atan2(y, x);
  const double toEdge = kPi / 2 - std::atan2(y, x);
  const double crossing = std::hypot(x, y) * std::cos(turn / 2) / std::cos(turn / 2 - toEdge);
  const SurfacePoint over02{0, {1 - crossing, crossing, 0}};
  const SurfacePoint over03{2, {1 - crossing, 0, crossing}};
  const Array<SurfacePoint> around = {from, over02, over03, to};
  EXPECT_NEAR(anglesBetween(mesh, straight, around), kPi / 2, 1e-12);
  EXPECT_NEAR(anglesBetween(mesh, around, around), 0, 1e-12);
}

}  // namespace
}  // namespace karcher

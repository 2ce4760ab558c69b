#include "curves/circle.h"

#include <gtest/gtest.h>

#include <functional>

#include "cases.h"
#include "curve_support.h"
#include "curves/curve_value.h"
#include "distance/shortest_path.h"
#include "generators/rough.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

TEST(Circle, OnARegularGridIsTheCircleOfThePlane) {
  Surface surface(planeGrid(24, 20));
  // Centers in a face, on an edge and at a vertex.
  for (const Vec3& center : {Vec3(11.3, 9.8, 0), Vec3(11.5, 9, 0), Vec3(12, 10, 0)}) {
    const SurfacePoint point = nearestPoint(surface.mesh(), center);
    for (const int arcs : {3, 4, 7}) {
      const double radius = 2.6;
      const GeodesicCircle circle = traceCircle(surface, point, radius, {arcs, 20, kPaperExact});
      ASSERT_EQ(circle.samples.count(), arcs);
      EXPECT_TRUE(circle.notShortest.empty());
      for (const Array<CurveSample>& arc : circle.samples) {
        for (const CurveSample& sample : arc) {
          const Vec3 p = position(surface.mesh(), sample.point);
          EXPECT_EQ(sample.status, SampleStatus::kConverged);
          EXPECT_NEAR((p - center).norm(), radius, 1e-12);
        }
      }
    }
  }
}

TEST(Circle, OnTheSphereComesNearerToEquidistanceWithMoreArcs) {
  Surface surface(importMesh(icosphere(14)).mesh);
  const Vec3 pole = Vec3(0.3, -0.2, 1).normalized();
  const SurfacePoint center = nearestPoint(surface.mesh(), pole);
  const Vec3 truth = position(surface.mesh(), center).normalized();
  const double radius = 0.5;
  double before = kInfinity;
  for (const int arcs : {3, 6, 12}) {
    const GeodesicCircle circle = traceCircle(surface, center, radius, {arcs, 24, kPaperExact});
    double worst = 0;
    for (const Array<CurveSample>& arc : circle.samples) {
      for (const CurveSample& sample : arc) {
        const Vec3 p = position(surface.mesh(), sample.point).normalized();
        worst = std::max(worst, std::abs(std::acos(p.dot(truth)) - radius));
      }
    }
    std::printf("circle of radius 0.5 on the sphere, %d arcs: %.2e from equidistance\n", arcs,
                worst);
    EXPECT_LT(worst, before);
    before = worst;
  }
}

TEST(Circle, OfATinyRadiusIsACircle) {
  // Circles on a curved surface, around centers in a face, on an edge, at a vertex and near one.
  Surface surface(importMesh(makeShape(Shape::kTorus, 500)).mesh);
  const TriangleMesh& mesh = surface.mesh();
  const Geometry& geometry = surface.geometry();
  for (const SurfacePoint& center :
       {SurfacePoint{7, Vec3(0.3, 0.3, 0.4)}, edgePoint(15, 0.4), vertexPoint(mesh, 0),
        SurfacePoint{7, Vec3(1 - 0.02, 0.01, 0.01)}}) {
    const PointLocation location = locate(mesh, center);
    const double turn =
        location.simplex == Simplex::kVertex ? geometry.totalAngle[location.vertex] : 2 * kPi;
    for (double part = 1e-2; part > 2e-9; part /= 10) {
      const double radius = part * geometry.meanEdge;
      Array<GeodesicCircle> circles{traceCircle(surface, center, radius, {7, 32, {}})};
      // About a vertex that is not flat an ellipse of equal radii is no circle.
      if (location.simplex != Simplex::kVertex) {
        circles.push_back(
            traceEllipse(surface, center, radius, radius, Vec2(0.3, 0.1), {7, 32, {}}));
      }
      // Points nearer to an edge than a tolerance lie on it.
      const double tolerance = 1e-9 + 1e-11 / part;
      for (const GeodesicCircle& circle : circles) {
        double length = 0;
        for (int j = 0; j < 7; ++j) {
          length += circle.paths[j].line.length();
          for (const CurveSample& sample : circle.samples[j]) {
            EXPECT_EQ(sample.status, SampleStatus::kConverged);
            const SurfacePath path = shortestPath(geometry, center, sample.point);
            EXPECT_NEAR(path.length() / radius, 1, tolerance) << part;
          }
        }
        // A polygon has 217 sides, or more where they cross edges.
        EXPECT_NEAR(length / radius, turn, 2e-3 + 50 * tolerance) << part;
      }
    }
    EXPECT_EQ(codeOf([&] { traceCircle(surface, center, 1e-200, {}); }), ErrorCode::kBadArgument);
    EXPECT_EQ(codeOf([&] { traceCircle(surface, center, 1e-12, {}); }), ErrorCode::kBadArgument);
    EXPECT_EQ(codeOf([&] { traceEllipse(surface, center, 0.1, 1e-17, Vec2(0.3, 0.1), {}); }),
              ErrorCode::kBadArgument);
  }
}

TEST(Circle, OnThePlaneIsTheSameAtEveryLevel) {
  Surface surface(planeGrid(24, 20));
  const Vec3 center(11.3, 9.8, 0);
  const SurfacePoint point = nearestPoint(surface.mesh(), center);
  for (const int levels : {1, 2, 5, kAutomaticLevels, kLimitLevels}) {
    for (const int arcs : {3, 7}) {
      const CircleOptions options{arcs, 20, {Method::kKarcher, Solver::kExact, 6}, levels};
      const GeodesicCircle circle = traceCircle(surface, point, 2.6, options);
      ASSERT_EQ(circle.samples.count(), arcs);
      for (const Array<CurveSample>& arc : circle.samples) {
        ASSERT_EQ(arc.count(), 20);
        for (const CurveSample& sample : arc) {
          const Vec3 p = position(surface.mesh(), sample.point);
          EXPECT_NEAR((p - center).norm(), 2.6, 1e-12) << levels << " levels";
        }
      }
    }
  }
}

TEST(Circle, IsContinuousOnARoughSurface) {
  const TriangleMesh smooth = importMesh(icosphere(10)).mesh;
  const TriangleSoup rough = roughened(smooth, 3, 3, 0.25);
  Surface surface(buildMesh(rough.positions, rough.triangles));
  const SurfacePoint center = nearestPoint(surface.mesh(), Vec3(0.3, -0.2, 1));
  const auto breaks = [&](int levels) {
    int count = 0;
    const CircleOptions options{3, 32, {}, levels};
    const GeodesicCircle circle = traceCircle(surface, center, 1.2, options);
    if (levels == kAutomaticLevels) {
      EXPECT_GT(circle.levels, 0);
    }
    for (const Array<Bridge>& bridges : circle.bridges) count += bridges.count();
    return count;
  };
  EXPECT_GT(breaks(0), 0);
  EXPECT_EQ(breaks(kAutomaticLevels), 0);
}

/// The largest difference of distance and radius along a circle's joined path, as a part of the
/// radius. Each distance has its own search.
double worstAlong(Surface& surface, const SurfacePoint& center, double radius,
                  const GeodesicCircle& circle, int points) {
  double worst = 0;
  for (const JoinedPath& path : circle.paths) {
    const SurfacePath whole = pathThrough(surface.mesh(), path.line.points);
    for (int i = 0; i < points; ++i) {
      const SurfacePoint point =
          pointAlong(surface.mesh(), whole, whole.length() * (i + 0.4) / points);
      const double length = shortestPath(surface.geometry(), center, point).length();
      worst = std::max(worst, std::abs(length / radius - 1));
    }
  }
  return worst;
}

TEST(Circle, OfFittingArcsKeepsItsDistance) {
  Surface sphere(importMesh(icosphere(20)).mesh);
  Surface torus(importMesh(makeShape(Shape::kTorus, 6000)).mesh);
  Surface plane(planeGrid(24, 20));
  for (Surface* surface : {&sphere, &torus, &plane}) {
    const int face = nearestPoint(surface->mesh(), Vec3(11.3, 9.8, 0)).face;
    for (const SurfacePoint& center :
         {SurfacePoint{face, Vec3(0.2, 0.3, 0.5)}, vertexPoint(surface->mesh(), 10 * 25 + 12)}) {
      const double radius = 0.12 * surface->geometry().diagonal;
      const GeodesicCircle seven = traceCircle(*surface, center, radius, {7, 32, {}});
      EXPECT_EQ(seven.samples.count(), 7);
      const GeodesicCircle circle = traceCircle(*surface, center, radius, {});
      EXPECT_LE(*circle.deviation, 1e-3);
      if (surface == &plane) {
        EXPECT_EQ(circle.samples.count(), 7);
        EXPECT_LT(*circle.deviation, 1e-12);
      } else {
        EXPECT_GT(*seven.deviation, 3e-3);
      }
      // Between samples chords fall short by the square of the angle that they span.
      EXPECT_LE(worstAlong(*surface, center, radius, circle, 9), *circle.deviation + 5e-4);
      EXPECT_NEAR(worstAlong(*surface, center, radius, seven, 99), *seven.deviation, 5e-4);
      CircleOptions fine;
      fine.tolerance = 2e-4;
      fine.samples = 128;
      EXPECT_LE(*traceCircle(*surface, center, radius, fine).deviation, 2e-4);
    }
  }
}

TEST(Circle, OfFittingArcsOnTheSphereIsTheParallel) {
  Surface surface(importMesh(icosphere(40)).mesh);
  const SurfacePoint center = nearestPoint(surface.mesh(), Vec3(0.3, -0.2, 1).normalized());
  const Vec3 pole = position(surface.mesh(), center).normalized();
  const double radius = 0.8;
  const GeodesicCircle circle = traceCircle(surface, center, radius, {});
  for (const Array<CurveSample>& arc : circle.samples) {
    for (const CurveSample& sample : arc) {
      const Vec3 p = position(surface.mesh(), sample.point).normalized();
      // The polyhedron inside the sphere is smaller by a few ten-thousandths.
      EXPECT_NEAR(std::acos(p.dot(pole)) / radius, 1, 1e-3 + 4e-4);
    }
  }
}

TEST(Circle, OfSevenEqualArcsAroundACornerHasTheSamplesOfOneInThePlane) {
  // The total angle at a cube's corner is three quarters of a turn.
  Surface surface(
      buildMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}},
                {{0, 4, 1}, {0, 2, 4}, {0, 1, 5}, {0, 5, 3}, {0, 6, 2}, {0, 3, 6}}));
  for (const int samples : {32, 200}) {
    CircleOptions options;
    options.samples = samples;
    const GeodesicCircle circle =
        traceCircle(surface, vertexPoint(surface.mesh(), 0), 0.3, options);
    ASSERT_EQ(circle.samples.count(), 7);
    for (const Array<CurveSample>& arc : circle.samples) EXPECT_EQ(arc.count(), samples);
  }
}

TEST(Circle, ReportsItsDeviationFromTheRadius) {
  // The circle is rough and beyond the cut locus: no number of arcs keeps to the radius everywhere.
  const TriangleMesh smooth = importMesh(makeShape(Shape::kTorus, 2000)).mesh;
  const TriangleSoup rough = roughened(smooth, 2, 3, 0.15);
  Surface surface(buildMesh(rough.positions, rough.triangles));
  bool someAreFar = false;
  const int faces[] = {100, 3100, 6100};
  for (const int face : casesOf(faces, 1)) {
    const SurfacePoint center{face, Vec3(0.2, 0.3, 0.5)};
    for (const double part : {0.05, 0.2}) {
      const double radius = part * surface.geometry().diagonal;
      const GeodesicCircle seven = traceCircle(surface, center, radius, {7, 32, {}});
      const GeodesicCircle circle = traceCircle(surface, center, radius, {});
      EXPECT_LE(circle.samples.count(), kMostFittingArcs);
      EXPECT_LT(*circle.deviation, *seven.deviation / 2);
      someAreFar = someAreFar || *circle.deviation > 1e-3;
      double worst = 0;
      for (const Array<CurveSample>& arc : circle.samples) {
        for (int i = 0; i < arc.count(); i += 3) {
          const double length = shortestPath(surface.geometry(), center, arc[i].point).length();
          worst = std::max(worst, std::abs(length / radius - 1));
        }
      }
      EXPECT_LE(worst, *circle.deviation + 1e-9);
      EXPECT_GT(worst, *circle.deviation / 3);
    }
  }
  EXPECT_TRUE(someAreFar);
}

TEST(Circle, FitsAroundCusps) {
  // Around a vertex with more than two full turns of angle arcs must be narrower than in the plane.
  Array<Vec3> positions{Vec3::Zero()};
  Array<Triangle> triangles;
  const int count = 30;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / count;
    positions.push_back(Vec3(std::cos(angle), std::sin(angle), i % 2 == 0 ? 1.0 : -1.0));
    triangles.push_back(Triangle(0, i + 1, (i + 1) % count + 1));
  }
  Surface surface(buildMesh(positions, triangles));
  const SurfacePoint tip = vertexPoint(surface.mesh(), 0);
  const GeodesicCircle circle = traceCircle(surface, tip, 0.3, {});
  EXPECT_GT(circle.samples.count(), 7);
  EXPECT_LT(*circle.deviation, 1e-9);
  EXPECT_EQ(codeOf([&] { traceCircle(surface, tip, 0.3, {7, 8, {}}); }), ErrorCode::kBadArgument);
  CircleOptions options;
  options.tolerance = 0;
  EXPECT_EQ(codeOf([&] { traceCircle(surface, tip, 0.3, options); }), ErrorCode::kBadArgument);
}

TEST(Circle, MarksArcsWhoseGeodesicsAreNotShortest) {
  // Round the tube of a torus two geodesics meet at half its circumference, 0.4 pi.
  Surface surface(importMesh(makeShape(Shape::kTorus, 3000)).mesh);
  const SurfacePoint center = nearestPoint(surface.mesh(), Vec3(1.4, 0.01, 0.02));
  const GeodesicCircle near = traceCircle(surface, center, 0.5, {7, 8, kPaperExact});
  EXPECT_TRUE(near.notShortest.empty());
  const GeodesicCircle wide = traceCircle(surface, center, 1.5, {7, 8, kPaperExact});
  EXPECT_FALSE(wide.notShortest.empty());
}

TEST(Circle, MarksArcsThatOverlapAroundATubeWithoutVertices) {
  // A triangular prism of long faces: around it two geodesics meet at half the circumference, 1.5.
  Array<Vec3> positions;
  Array<Triangle> triangles;
  for (int i = 0; i < 3; ++i) {
    const Vec2 place = unitVector(2 * kPi * i / 3) / std::sqrt(3.0);
    positions.push_back(Vec3(place.x(), place.y(), 0));
    positions.push_back(Vec3(place.x(), place.y(), 20));
    const int next = 2 * ((i + 1) % 3);
    triangles.push_back(Triangle(2 * i, next, 2 * i + 1));
    triangles.push_back(Triangle(next, next + 1, 2 * i + 1));
  }
  triangles.push_back(Triangle(0, 4, 2));
  triangles.push_back(Triangle(1, 3, 5));
  Surface surface(buildMesh(positions, triangles));
  const SurfacePoint center =
      nearestPoint(surface.mesh(), (positions[0] + positions[2]) / 2 + Vec3(0, 0, 10));
  const GeodesicCircle narrow = traceCircle(surface, center, 1.2, {7, 8, kPaperExact});
  EXPECT_TRUE(narrow.notShortest.empty());
  const GeodesicCircle wide = traceCircle(surface, center, 3, {7, 8, kPaperExact});
  // An arc whose end, itself a control point, has a shorter path on the other side of the tube.
  int overlaps = 0;
  for (int j = 0; j < 7; ++j) {
    const auto isNearer = [&](const CurveSample& end) {
      return shortestPath(surface.geometry(), center, end.point).length() < 3 - 1e-6;
    };
    if (!isNearer(wide.samples[j].front()) && !isNearer(wide.samples[j].back())) continue;
    ++overlaps;
    EXPECT_TRUE(std::count(wide.notShortest.begin(), wide.notShortest.end(), j)) << "arc " << j;
  }
  EXPECT_GT(overlaps, 0);
}

TEST(Circle, RefusesInvalidRadiiArcsAndSamples) {
  Surface surface(planeGrid(10, 10));
  const SurfacePoint center = nearestPoint(surface.mesh(), Vec3(3.3, 5.2, 0));
  const auto trace = [&](double radius, int arcs) {
    traceCircle(surface, center, radius, {arcs, 8, kPaperExact});
  };
  EXPECT_EQ(codeOf([&] { trace(0, 7); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { trace(std::nan(""), 7); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { trace(1, 2); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { trace(4, 7); }), ErrorCode::kBoundary);
  EXPECT_EQ(codeOf([&] { trace(100, 7); }), ErrorCode::kRadiusTooLarge);

  Surface sphere(importMesh(icosphere(6)).mesh);
  const SurfacePoint pole = nearestPoint(sphere.mesh(), Vec3(0, 0, 1));
  EXPECT_EQ(codeOf([&] {
              traceCircle(sphere, pole, 3.3, {7, 8, kPaperExact});
            }),
            ErrorCode::kRadiusTooLarge);
}

TEST(Circle, HasNoCenterOnTheBoundary) {
  Surface surface(planeGrid(30, 30));
  const TriangleMesh& mesh = surface.mesh();
  // A corner, a vertex of a side, and the middle of an edge there.
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(15, 0, 0), Vec3(15.5, 0, 0)}) {
    const SurfacePoint center = nearestPoint(mesh, place);
    for (const int arcs : {3, 7}) {
      const CircleOptions options{arcs, 5, kPaperExact};
      EXPECT_EQ(codeOf([&] { traceCircle(surface, center, 3, options); }), ErrorCode::kBoundary);
      EXPECT_EQ(codeOf([&] { traceEllipse(surface, center, 3, 2, Vec2(1, 0), options); }),
                ErrorCode::kBoundary);
    }
  }
}

TEST(Ellipse, OnThePlaneIsTheEllipse) {
  Surface surface(planeGrid(24, 20));
  for (const Vec3& center : {Vec3(11.3, 9.8, 0), Vec3(11.5, 9, 0), Vec3(12, 10, 0)}) {
    const SurfacePoint point = nearestPoint(surface.mesh(), center);
    const Vec2 axis = unitVector(0.4);
    const Vec2 inFrame = toFace(surface.geometry(), point.face, Vec3(axis.x(), axis.y(), 0));
    for (const int arcs : {3, 4, 7}) {
      const GeodesicCircle ellipse =
          traceEllipse(surface, point, 3.1, 1.4, inFrame, {arcs, 20, kPaperExact});
      ASSERT_EQ(ellipse.samples.count(), arcs);
      for (const Array<CurveSample>& arc : ellipse.samples) {
        for (const CurveSample& sample : arc) {
          const Vec3 x = position(surface.mesh(), sample.point) - center;
          const Vec2 place(x.x(), x.y());
          const Vec2 scaled(axis.dot(place) / 3.1, cross(axis, place) / 1.4);
          EXPECT_EQ(sample.status, SampleStatus::kConverged);
          EXPECT_NEAR(scaled.norm(), 1, 1e-12);
        }
      }
    }
  }
}

TEST(Ellipse, WithEqualRadiiIsTheCircle) {
  Surface surface(importMesh(icosphere(10)).mesh);
  const SurfacePoint center{7, Vec3(0.2, 0.3, 0.5)};
  const CircleOptions options{5, 12, {Method::kKarcher, Solver::kExact, 6}};
  const GeodesicCircle circle = traceCircle(surface, center, 0.4, options);
  const GeodesicCircle ellipse = traceEllipse(surface, center, 0.4, 0.4, Vec2(2, 0), options);
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 12; ++i) {
      const Vec3 there = position(surface.mesh(), circle.samples[j][i].point);
      const Vec3 here = position(surface.mesh(), ellipse.samples[j][i].point);
      EXPECT_LT((here - there).norm(), 1e-9);
    }
  }
  EXPECT_EQ(codeOf([&] { traceEllipse(surface, center, 0.4, -1, Vec2(1, 0), options); }),
            ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { traceEllipse(surface, center, 0.4, 0.2, Vec2(0, 0), options); }),
            ErrorCode::kBadArgument);
}

TEST(Ellipse, AboutAConesTipIsSymmetricAndThatOfTheUnrolledCone) {
  // Tips with less and with more than a full turn.
  for (const double zigzag : {0.0, 1.0}) {
    Array<Vec3> positions{Vec3::Zero()};
    Array<Triangle> triangles;
    const int sides = 30;
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * kPi * i / sides;
      const double height = zigzag == 0 ? 1 : i % 2 == 0 ? zigzag : -zigzag;
      positions.push_back(Vec3(std::cos(angle), std::sin(angle), height));
      triangles.push_back(Triangle(0, i + 1, (i + 1) % sides + 1));
    }
    Surface surface(buildMesh(positions, triangles));
    const Geometry& geometry = surface.geometry();
    const SurfacePoint tip = vertexPoint(surface.mesh(), 0);
    const double scale = geometry.totalAngle[0] / (2 * kPi);
    const Vec2 direction =
        cornerInFace(geometry, tip.face, 1) - cornerInFace(geometry, tip.face, 0) +
        cornerInFace(geometry, tip.face, 2) - cornerInFace(geometry, tip.face, 0);
    const int arcs = zigzag == 0 ? 7 : 41;
    const int samples = 9;
    const double along = 0.4;
    const double across = 0.2;
    const GeodesicCircle ellipse =
        traceEllipse(surface, tip, along, across, direction, {arcs, samples, kPaperExact});
    // A control point in the unrolled cone, by the number of half arcs from the first axis.
    const auto control = [&](int i) -> Vec2 {
      const double angle = i * kPi / arcs;
      const double reach = i % 2 == 0 ? 1 : 1 / std::cos(kPi / arcs);
      const Vec2 place(reach * along * std::cos(angle), reach * across * std::sin(angle));
      // The angle in the plane from the axis, in the same quadrant as `angle`.
      const double off = std::remainder(angleOf(place) - angle, 2 * kPi);
      return place.norm() * unitVector(scale * (angle + off));
    };
    for (int j = 0; j < arcs; ++j) {
      for (int k = 0; k < samples; ++k) {
        const double t = k / (samples - 1.0);
        const double middle = 2 * t * (1 - t) * std::cos(kPi / arcs);
        const double sum = (1 - t) * (1 - t) + middle + t * t;
        const Vec2 place = ((1 - t) * (1 - t) * control(2 * j) + middle * control(2 * j + 1) +
                            t * t * control(2 * j + 2)) /
                           sum;
        const double length = shortestPath(geometry, tip, ellipse.samples[j][k].point).length();
        EXPECT_NEAR(length, place.norm(), 1e-9) << "arc " << j << ", sample " << k;
        const SurfacePoint& mirrored = ellipse.samples[arcs - 1 - j][samples - 1 - k].point;
        EXPECT_NEAR(length, shortestPath(geometry, tip, mirrored).length(), 1e-9);
      }
    }
    // The ends of a flat ellipse turn by more than half a turn at once.
    if (zigzag != 0) {
      EXPECT_THROW(traceEllipse(surface, tip, along, 0.02, direction, {arcs, samples, kPaperExact}),
                   Error);
    }
  }
}

}  // namespace
}  // namespace karcher

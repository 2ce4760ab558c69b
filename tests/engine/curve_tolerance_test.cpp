#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "curve_support.h"
#include "curves/query/evaluate.h"
#include "generators/curve_shapes.h"
#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

double distanceToPolyline(const Vec3& p, const Array<Vec3>& line, double enough) {
  double least = kInfinity;
  for (int i = 1; i < line.count() && least > enough; ++i) {
    const Vec3 along = line[i] - line[i - 1];
    const double squared = along.squaredNorm();
    const double s = squared > 0 ? std::clamp((p - line[i - 1]).dot(along) / squared, 0.0, 1.0) : 0;
    least = std::min(least, (line[i - 1] + s * along - p).norm());
  }
  return least;
}

struct Deviation {
  double most = 0;  ///< the largest deviation, as a part of the diagonal
  double at = 0;
};

/// The largest deviation of the curve, at `count` parameters, from its drawn line.
Deviation deviationOf(Curve& curve, int count) {
  const TriangleMesh& mesh = curve.surface().mesh();
  const double diagonal = curve.surface().geometry().diagonal;
  Deviation deviation;
  const int looks = count / curve.segmentCount();
  for (int j = 0; j < curve.segmentCount(); ++j) {
    Array<Vec3> line;
    for (const SurfacePoint& point : curve.path(j).line.points)
      line.push_back(position(mesh, point));
    for (int i = 0; i <= looks; ++i) {
      const CurvePoint point = pointAt(curve, {j, static_cast<double>(i) / looks});
      if (point.status != SampleStatus::kConverged) continue;
      const double off =
          distanceToPolyline(position(mesh, point.point), line, deviation.most * diagonal) /
          diagonal;
      if (off > deviation.most) deviation = {off, point.parameter};
    }
  }
  return deviation;
}

/// Points of the mesh within `reach` of a random one, as a part of the diagonal.
Array<SurfacePoint> pointsWithin(const Surface& surface, double reach, int count, Random& random) {
  const Vec3 center = position(surface.mesh(), randomPoint(surface.mesh(), random));
  Array<SurfacePoint> points;
  constexpr int kMostTries = 1'000'000;
  for (int i = 0; points.count() < count && i < kMostTries; ++i) {
    const SurfacePoint point = randomPoint(surface.mesh(), random);
    const double distance = (position(surface.mesh(), point) - center).norm();
    if (distance < reach * surface.geometry().diagonal) points.push_back(point);
  }
  return points;
}

Curve adaptiveCurve(Surface& surface, const CurveShape& shape, const Array<SurfacePoint>& points,
                    double tolerance) {
  CurveOptions options = ofLevelZero(shape, 2, kFast);
  options.tolerance = tolerance;
  Curve curve(surface, options, points);
  return curve;
}

TEST(CurveTolerance, TheCurveStaysNearItsDrawnLine) {
  SKIP_WHERE_SANITIZED();
  Surface bunny(bunnyMesh());
  Surface torus(importMesh(makeShape(Shape::kTorus, 3000)).mesh);
  Surface grid(planeGrid(30, 30));
  const uint64_t seed = 77;
  Random random(seed);
  constexpr int kControlPoints = 6;
  for (Surface* surface : {&bunny, &torus, &grid}) {
    for (const double tolerance : {1e-3, 1e-4}) {
      Deviation worst;
      int samples = 0;
      double reach = 0.5;
      for (const CurveShape& shape : everyShape(kControlPoints)) {
        reach = reach == 0.25 ? 0.5 : 0.25;
        const Array<SurfacePoint> points = pointsWithin(*surface, reach, kControlPoints, random);
        Curve curve = adaptiveCurve(*surface, shape, points, tolerance);
        const Deviation deviation = deviationOf(curve, longRun() ? 2000 : 350);
        EXPECT_LE(deviation.most, tolerance)
            << describe(shape) << ", " << surface->mesh().faceCount() << " faces, seed " << seed
            << ", t " << deviation.at;
        if (deviation.most > worst.most) worst = deviation;
        for (int j = 0; j < curve.segmentCount(); ++j) samples += curve.samples(j).count();
      }
      std::printf("%5d triangles, tolerance %.0e: curves at most %.1e off, %d samples\n",
                  surface->mesh().faceCount(), tolerance, worst.most, samples);
    }
  }
}

TEST(CurveTolerance, FindsABendBetweenTheQuartersOfAnInterval) {
  Surface bunny(bunnyMesh());
  // Between t = 1.75 and 1.875 this curve bends away from a geodesic that it meets in the middle.
  const Array<SurfacePoint> points{{428, {0.742, 0.228, 0.03}},
                                   {1137, {0.82, 0.018, 0.162}},
                                   {1144, {0.684, 0.218, 0.098}},
                                   {1659, {0.668, 0.31, 0.022}},
                                   {2002, {0.321, 0.408, 0.271}}};
  Curve curve = adaptiveCurve(bunny, {CurveKind::kBSpline}, points, 1e-4);
  EXPECT_LE(deviationOf(curve, 8000).most, 1e-4);
}

TEST(CurveTolerance, CurvesThroughPointsPassThemHoweverTheirBetasDiffer) {
  Surface grid(planeGrid(30, 30));
  const Array<SurfacePoint> points = pointsNear(
      grid.mesh(), {{8, 14, 0}, {10, 17, 0}, {13, 14, 0}, {16, 17, 0}, {19, 14, 0}, {21, 17, 0}});
  for (const bool closed : {false, true}) {
    for (const double beta : {1.0, 16.0, 100.0, 1e4}) {
      CurveShape shape{CurveKind::kBarycentric, closed};
      shape.betas = {beta, 1, beta, 1, beta, beta};
      Curve curve = adaptiveCurve(grid, shape, points, 1e-4);
      Array<Vec3> line;
      for (const SurfacePoint& point : curve.path(0).line.points) {
        line.push_back(position(grid.mesh(), point));
      }
      for (const SurfacePoint& point : points) {
        EXPECT_LT(distanceToPolyline(position(grid.mesh(), point), line, 0), 1e-9)
            << "beta " << beta << ", face " << point.face;
      }
    }
  }
}

}  // namespace
}  // namespace karcher

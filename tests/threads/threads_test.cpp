#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "curves/circle.h"
#include "curves/curve.h"
#include "curves/isoline.h"
#include "distance/distance_fields.h"
#include "distance/exact_lengths.h"
#include "distance/shortest_path.h"
#include "distance/window_distance.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/field_options.h"
#include "rcm/mean.h"

/// The promises of docs/cpp.md about threads. `npm run check:long` runs the test under
/// ThreadSanitizer.
namespace karcher {
namespace {

constexpr int kThreads = 4;

/// Runs work(0), work(1), … at the same time, each in a thread of its own.
void inThreads(const std::function<void(int)>& work) {
  Array<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
}

TriangleMesh torus() { return importMesh(makeShape(Shape::kTorus, 800)).mesh; }

SurfacePoint pointOf(const TriangleMesh& mesh, int i) {
  return {i * 97 % mesh.faceCount(), Vec3(0.2, 0.3, 0.5)};
}

TEST(Threads, ShareAMeshAndItsGeometry) {
  const TriangleMesh mesh = torus();
  const Geometry geometry = buildGeometry(mesh);
  const auto measure = [&](int i) {
    const SurfacePoint from = pointOf(mesh, 3 * i);
    const SurfacePoint to = pointOf(mesh, 3 * i + 1);
    Array<double> result;
    WindowDistance exact(geometry);
    exact.setSource(from);
    exact.grow(kInfinity);
    WindowDistance fast(geometry, kFastTolerance);
    fast.setSource(from);
    fast.grow(kInfinity);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      result.push_back(exact.distance(v));
      result.push_back(fast.distance(v));
    }
    result.push_back(shortestPath(geometry, from, to).length());
    result.push_back(exactLengths(geometry, from, {to}, 1)[0]);
    for (const Isoline& line : exactIsolines(geometry, from, 0.5)) result.push_back(line.length);
    result.push_back(traceStraightest(geometry, from, Vec2(1, 0.3)).path.length());
    return result;
  };
  Array<Array<double>> parallel;
  parallel.assign(kThreads, {});
  inThreads([&](int i) { parallel[i] = measure(i); });
  for (int i = 0; i < kThreads; ++i) EXPECT_EQ(parallel[i], measure(i));
}

TEST(Threads, ComputeTheFieldsOfSeveralPoints) {
  const TriangleMesh mesh = torus();
  const Geometry geometry = buildGeometry(mesh);
  Array<SurfacePoint> points;
  for (int i = 0; i < 10; ++i) points.push_back(pointOf(mesh, i));
  for (const double tolerance : {0.0, kFastTolerance}) {
    const Array<Array<double>> one = distanceFields(geometry, points, tolerance);
    EXPECT_EQ(distanceFields(geometry, points, tolerance, kThreads), one);
    EXPECT_EQ(distanceFields(geometry, points, tolerance, 100), one);
    for (int i = 0; i < points.count(); ++i) {
      WindowDistance alone(geometry, tolerance);
      alone.setSource(points[i]);
      alone.grow(kInfinity);
      for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(one[i][v], alone.distance(v));
    }
  }
  EXPECT_TRUE(distanceFields(geometry, {}, 0, kThreads).empty());
  EXPECT_THROW(distanceFields(geometry, points, 0, 0), Error);
}

TEST(Threads, HaveSurfacesOfTheirOwn) {
  const TriangleMesh mesh = torus();
  const auto measure = [&](int i) {
    Surface surface(mesh);
    Array<SurfacePoint> points;
    for (int k = 0; k < 4; ++k) points.push_back(pointOf(mesh, i + k));
    Array<double> result;
    for (const Solver solver : {Solver::kFast, Solver::kExact, Solver::kGraph}) {
      MeanOptions options;
      options.field = {Method::kKarcher, solver, 3};
      const Mean mean = centerOfMass(surface, points, {0.1, 0.4, 0.4, 0.1}, options);
      const Vec3 place = position(surface.mesh(), mean.point);
      result.insert(result.end(), {place.x(), place.y(), place.z()});
    }
    CurveOptions options;
    options.samples = 16;
    Curve curve(surface, options, points);
    result.push_back(curve.path(0).line.length());
    curve.movePoint(1, pointOf(mesh, i + 7));
    result.push_back(curve.path(0).line.length());
    result.push_back(*traceCircle(surface, points[0], 0.3, {}).deviation);
    return result;
  };
  Array<Array<double>> parallel;
  parallel.assign(kThreads, {});
  inThreads([&](int i) { parallel[i] = measure(i); });
  for (int i = 0; i < kThreads; ++i) EXPECT_EQ(parallel[i], measure(i));
}

}  // namespace
}  // namespace karcher

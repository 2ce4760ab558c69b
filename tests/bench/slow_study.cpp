#include <cmath>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "rcm/mean.h"

/// The time of single calls that meshes of less than 20,000 triangles make slow: a B-spline round a
/// vertex of many faces, of needles too, and among spikes, welding where many corners lie at one
/// place, and the center of mass of many points on a rough surface.
///
///   slow_study
namespace karcher {
namespace {

Array<SurfacePoint> randomPoints(const TriangleMesh& mesh, int count, Random& random) {
  Array<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(randomPoint(mesh, random));
  return points;
}

void tell(const std::string& what, double ms) {
  std::printf("%-60s %8.2f s\n", what.c_str(), ms / 1000);
  std::fflush(stdout);
}

void studyFan(int faces) {
  Random random(3);
  TriangleSoup soup = wheel(faces, 0, 0.5);
  for (int i = 1; i <= faces; ++i) soup.positions[i].z() = 0.2 * std::cos(100 * kPi * i / faces);
  Surface surface(importMesh(std::move(soup)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 4, random);
  for (const int levels : {0, kAutomaticLevels}) {
    CurveOptions options{{CurveKind::kBSpline}, 32, {}};
    options.levels = levels;
    const double ms = timed([&] { Curve(surface, options, points); });
    tell(std::to_string(faces) + " faces round a vertex, " +
             (levels == 0 ? "level 0" : "automatic levels"),
         ms);
  }
}

void studyCluster(int triangles) {
  Random random(4);
  TriangleSoup soup;
  for (int i = 0; i < triangles; ++i) {
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      const Vec3 jitter(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      soup.positions.push_back(place + 1e-8 * jitter);
    }
    soup.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  tell(std::to_string(triangles) + " triangles at three places, read",
       timed([&] { importMesh(std::move(soup)); }));
}

void studyRoughGrid(int n, int count) {
  Random random(9);
  TriangleSoup soup;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      soup.positions.emplace_back(x + random.uniform(0, 0.7), y + random.uniform(0, 0.7),
                                  random.uniform(0, 12));
    }
  }
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const int a = y * (n + 1) + x;
      soup.triangles.emplace_back(a, a + 1, a + n + 2);
      soup.triangles.emplace_back(a, a + n + 2, a + n + 1);
    }
  }
  Surface surface(importMesh(std::move(soup)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), count, random);
  const Array<double> weights(static_cast<size_t>(count), 1.0);
  MeanOptions options;
  options.normalize = true;
  tell(std::to_string(count) + " points on a rough grid of " + std::to_string(2 * n * n) +
           " triangles, their center",
       timed([&] { centerOfMass(surface, points, weights, options); }));
}

/// A cone of this height over a circle of radius 1: needles round its tip.
void studyNeedle(int faces) {
  Random random(5);
  Surface surface(importMesh(wheel(faces, 0, 1e4)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 4, random);
  tell(std::to_string(faces) + " needles round a vertex, a B-spline", timed([&] {
         Curve(surface, {{CurveKind::kBSpline}, 32, {}}, points);
       }));
  tell(std::to_string(faces) + " needles round a vertex, exact distances", timed([&] {
         WindowDistance exact(surface.geometry());
         exact.setSource(points[0]);
         exact.grow(kInfinity);
       }));
}

/// A sphere of which three vertices in ten stand out by up to 20 of its radii.
void studySpikes(int around, int along) {
  Random random(13);
  TriangleSoup soup;
  const auto add = [&](double polar, double angle) {
    const double radius = random.uniform(0, 1) < 0.3 ? 1 + random.uniform(0, 20) : 1;
    const Vec2 u = std::sin(polar) * unitVector(angle);
    soup.positions.push_back(radius * Vec3(u.x(), u.y(), std::cos(polar)));
  };
  add(0, 0);
  add(kPi, 0);
  for (int i = 1; i < along; ++i) {
    for (int j = 0; j < around; ++j) add(kPi * i / along, 2 * kPi * j / around);
  }
  const auto at = [&](int i, int j) { return 2 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) {
    soup.triangles.emplace_back(0, at(1, j), at(1, j + 1));
    soup.triangles.emplace_back(1, at(along - 1, j + 1), at(along - 1, j));
    for (int i = 1; i < along - 1; ++i) {
      soup.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      soup.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  Surface surface(importMesh(std::move(soup)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 40, random);
  tell("a B-spline of 40 points on a spiked sphere of " +
           std::to_string(surface.mesh().faceCount()) + " triangles",
       timed([&] {
         Curve(surface, {{CurveKind::kBSpline}, 16, {}}, points);
       }));
}

}  // namespace
}  // namespace karcher

int main() {
  karcher::studyCluster(20'000);
  karcher::studyRoughGrid(95, 200);
  for (const int faces : {1000, 2000, 5000}) karcher::studyFan(faces);
  karcher::studySpikes(100, 80);
  for (const int faces : {300, 1000, 3000}) karcher::studyNeedle(faces);
  return 0;
}

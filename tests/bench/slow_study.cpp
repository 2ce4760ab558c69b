#include <cmath>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "rcm/mean.h"

/// The time of single calls that meshes of less than 20,000 triangles make slow: a B-spline round a
/// vertex of many faces, welding where many corners lie at one place, and the center of mass of
/// many points on a rough surface.
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

}  // namespace
}  // namespace karcher

int main() {
  karcher::studyCluster(20'000);
  karcher::studyRoughGrid(95, 200);
  for (const int faces : {1000, 2000, 5000}) karcher::studyFan(faces);
  return 0;
}

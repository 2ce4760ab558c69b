#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "bench_support.h"
#include "curves/curve.h"
#include "curves/isoline.h"
#include "distance/window_distance.h"
#include "generators/gallery.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"

/// The processor time of single calls that meshes of up to 20,000 triangles make slow: a B-spline
/// and a center of mass round a vertex of many faces, of needles too, and among spikes, isolines on
/// needles, welding where many corners lie at one place, and centers of mass of many points.
///
///   slow_study [PART_OF_A_NAME]
namespace karcher {
namespace {

Array<SurfacePoint> randomPoints(const TriangleMesh& mesh, int count, Random& random) {
  Array<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(randomPoint(mesh, random));
  return points;
}

/// The rows of the table; only those whose names contain a given text run.
class Rows {
 public:
  explicit Rows(std::string wanted) : wanted_(std::move(wanted)) {
    std::printf("| call | s |\n| --- | --- |\n");
  }

  bool wants(const std::string& name) const { return name.find(wanted_) != std::string::npos; }

  template <class Call>
  void measure(const std::string& name, const Call& call) const {
    if (!wants(name)) return;
    const double begun = processorMilliseconds();
    call();
    std::printf("| %s | %.2f |\n", name.c_str(), (processorMilliseconds() - begun) / 1000);
    std::fflush(stdout);
  }

 private:
  std::string wanted_;
};

void drawSpline(Surface& surface, const Array<SurfacePoint>& points, int levels) {
  CurveOptions options{{CurveKind::kBSpline}, 32, {}};
  options.levels = levels;
  Curve(surface, options, points);
}

MeanOptions forWeights() {
  MeanOptions options;
  options.normalize = true;
  return options;
}

void findCenter(Surface& surface, const Array<SurfacePoint>& points, const MeanOptions& options) {
  centerOfMass(surface, points, Array<double>(points.size(), 1.0), options);
}

void studyFan(const Rows& rows, int faces) {
  Random random(3);
  TriangleSoup soup = wheel(faces, 0, 0.5);
  for (int i = 1; i <= faces; ++i) soup.positions[i].z() = 0.2 * std::cos(100 * kPi * i / faces);
  Surface surface(importMesh(std::move(soup)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 4, random);
  const std::string name = std::to_string(faces) + " faces round a vertex, ";
  rows.measure(name + "B-spline of 4 points, level 0", [&] { drawSpline(surface, points, 0); });
  rows.measure(name + "B-spline of 4 points",
               [&] { drawSpline(surface, points, kAutomaticLevels); });
  MeanOptions options = forWeights();
  rows.measure(name + "center of 4 points", [&] { findCenter(surface, points, options); });
  options.looksForOthers = true;
  rows.measure(name + "center of 4 points, uniqueness",
               [&] { findCenter(surface, points, options); });
}

void studyNeedle(const Rows& rows, int faces) {
  Random random(5);
  Surface surface(importMesh(wheel(faces, 0, 1e4)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 4, random);
  const std::string name = std::to_string(faces) + " needles round a vertex, ";
  rows.measure(name + "B-spline of 4 points",
               [&] { drawSpline(surface, points, kAutomaticLevels); });
  rows.measure(name + "exact distances", [&] {
    WindowDistance exact(surface.geometry());
    exact.setSource(points[0]);
    exact.grow(kInfinity);
  });
  rows.measure(name + "isolines at a fifth of the diagonal", [&] {
    exactIsolines(surface.geometry(), points[0], 0.2 * surface.geometry().diagonal);
  });
}

void studyCluster(const Rows& rows, int triangles) {
  Random random(4);
  TriangleSoup soup;
  for (int i = 0; i < triangles; ++i) {
    for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      const Vec3 jitter(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      soup.positions.push_back(place + 1e-8 * jitter);
    }
    soup.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  rows.measure(std::to_string(triangles) + " triangles at three places, import",
               [&] { importMesh(std::move(soup)); });
}

TriangleSoup roughGrid(int n) {
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
  return soup;
}

void studyMany(const Rows& rows, const std::string& surfaceName, TriangleMesh mesh, int count) {
  Random random(10);
  Surface surface(std::move(mesh));
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), count, random);
  MeanOptions options = forWeights();
  const std::string name = std::to_string(count) + " points on a " + surfaceName + " of " +
                           std::to_string(surface.mesh().faceCount()) + " triangles, center";
  rows.measure(name, [&] { findCenter(surface, points, options); });
  options.field.solver = Solver::kExact;
  rows.measure(name + ", exact distances", [&] { findCenter(surface, points, options); });
}

/// A sphere with three in ten vertices raised by up to 20 of its radii.
TriangleSoup spikedSphere(int around, int along, Random& random) {
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
  return soup;
}

void studySpikes(const Rows& rows) {
  Random random(13);
  Surface surface(importMesh(spikedSphere(100, 80, random)).mesh);
  const Array<SurfacePoint> points = randomPoints(surface.mesh(), 40, random);
  const std::string name =
      "spiked sphere of " + std::to_string(surface.mesh().faceCount()) + " triangles, ";
  rows.measure(name + "B-spline of 40 points",
               [&] { drawSpline(surface, points, kAutomaticLevels); });
  rows.measure(name + "exact distances", [&] {
    WindowDistance exact(surface.geometry());
    exact.setSource(points[0]);
    exact.grow(kInfinity);
  });
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  const Rows rows(argc > 1 ? argv[1] : "");
  studyCluster(rows, 20'000);
  for (const int faces : {1000, 5000, 10'000}) studyFan(rows, faces);
  for (const int faces : {300, 1000, 3000, 5000}) studyNeedle(rows, faces);
  studySpikes(rows);
  studyMany(rows, "rough grid", importMesh(roughGrid(95)).mesh, 200);
  studyMany(rows, "torus", importMesh(makeShape(Shape::kTorus, 20'000)).mesh, 200);
  return 0;
}

#include <cmath>
#include <cstdio>

#include "bench_support.h"
#include "generators/smooth_surface.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"

/// The center of mass of four points in a cap of the sphere against the closed form, under
/// refinement: the mean over caps and weights of the distance, as a part of the radius.
///
///   sphere_study
namespace karcher {
namespace {

constexpr uint64_t kSeed = 8;
constexpr int kCases = 10;
constexpr double kCap = 0.6;  ///< radians from the cap's middle

struct Case {
  Array<Vec3> points;
  Array<double> weights;
};

Array<Case> chooseCases(const SmoothSurface& sphere) {
  Random random(kSeed);
  Array<Case> cases;
  for (int i = 0; i < kCases; ++i) {
    const auto coordinate = [&] { return 2 * random.uniform() - 1; };
    const Vec3 middle = sphere.project(Vec3(coordinate(), coordinate(), coordinate()));
    Case example;
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      Vec3 step(coordinate(), coordinate(), coordinate());
      step -= step.dot(middle) * middle;
      example.points.push_back(sphere.exp(middle, kCap * random.uniform() * step.normalized()));
      example.weights.push_back(0.1 + random.uniform());
      sum += example.weights.back();
    }
    for (double& weight : example.weights) weight /= sum;
    cases.push_back(example);
  }
  return cases;
}

struct Row {
  double meanEdge = 0;
  double error = 0;
  int lost = 0;
};

Row measure(Surface& surface, const SmoothSurface& sphere, const Array<Case>& cases,
            const FieldOptions& field) {
  Row row;
  row.meanEdge = surface.geometry().meanEdge;
  for (const Case& example : cases) {
    Array<SurfacePoint> points;
    Array<Vec3> onSphere;
    for (const Vec3& p : example.points) {
      points.push_back(nearestPoint(surface.mesh(), p));
      onSphere.push_back(sphere.project(position(surface.mesh(), points.back())));
    }
    MeanOptions options;
    options.field = field;
    const Mean mean = centerOfMass(surface, points, example.weights, options);
    row.lost += mean.status != Status::kConverged;
    const Vec3 truth = smoothCenter(sphere, onSphere, example.weights, onSphere[0]);
    row.error += (sphere.project(position(surface.mesh(), mean.point)) - truth).norm() / kCases;
  }
  return row;
}

void study() {
  const SmoothSurface sphere = smoothSphere();
  const Array<Case> cases = chooseCases(sphere);
  const struct {
    const char* name;
    FieldOptions options;
  } methods[] = {
      {"paper, exact", {Method::kPaper, Solver::kExact, 6}},
      {"paper, graph", {Method::kPaper, Solver::kGraph, 6}},
      {"log, fast", {Method::kKarcher, Solver::kFast, 6}},
      {"log, exact", {Method::kKarcher, Solver::kExact, 6}},
  };
  std::printf(
      "Four points within %.1f of the middle of a cap of the unit icosphere, %d caps, seed "
      "%d: mean error\n\n",
      kCap, kCases, static_cast<int>(kSeed));
  std::printf("| fields | triangles | error | error / h | order | lost |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& method : methods) {
    Row coarser;
    for (const int frequency : {8, 16, 32, 64}) {
      Surface surface(importMesh(icosphere(frequency)).mesh);
      const Row row = measure(surface, sphere, cases, method.options);
      char order[16] = "";
      if (coarser.error > 0) {
        std::snprintf(
            order, sizeof order, "%.2f",
            std::log(coarser.error / row.error) / std::log(coarser.meanEdge / row.meanEdge));
      }
      std::printf("| %s | %d | %.2e | %.2e | %s | %d |\n", method.name, surface.mesh().faceCount(),
                  row.error, row.error / row.meanEdge, order, row.lost);
      std::fflush(stdout);
      coarser = row;
    }
  }
}

}  // namespace
}  // namespace karcher

int main() {
  try {
    karcher::study();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

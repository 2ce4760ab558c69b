#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "bench_support.h"
#include "curves/bases.h"
#include "curves/curve.h"
#include "generators/plane.h"
#include "generators/smooth_surface.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "mesh/mesh_import.h"
#include "plot.h"

/// How far a B-spline on a mesh of a smooth surface is from the true one on the surface, at three
/// sizes, for the paper's fields and for log vectors. Prints Markdown; with a folder as argument
/// writes accuracy.md and a plot a surface there.
///
///   accuracy_study [FOLDER] [SCALE]      SCALE multiplies the triangle counts; 1 by default
namespace karcher {
namespace {

constexpr uint64_t kSeed = 5;
constexpr int kSamples = 128;
constexpr double kNegligible = 1e-11;

struct FieldMethod {
  const char* name;
  FieldOptions options;
};

const FieldMethod kMethods[] = {
    {"paper, exact", {Method::kPaper, Solver::kExact, 6}},
    {"paper, graph", {Method::kPaper, Solver::kGraph, 6}},
    {"log, fast", {Method::kKarcher, Solver::kFast, 6}},
    {"log, exact", {Method::kKarcher, Solver::kExact, 6}},
};

/// A family of meshes of one smooth surface, and control points on it.
struct Family {
  std::string name;
  std::function<TriangleSoup(int triangles)> mesh;
  SmoothSurface surface;
  Array<Vec3> points;
};

struct Measure {
  double rms = 0;
  double maximum = 0;
  double turningNoise = 0;
  int lost = 0;
  double meanEdge = 0;
  double diagonal = 0;
};

/// The turning angles of a sampled curve, positive to the left seen from outside.
Array<double> turningAngles(const SmoothSurface& surface, const Array<Vec3>& points) {
  Array<double> angles;
  for (int i = 1; i + 1 < points.count(); ++i) {
    const Vec3 before = points[i] - points[i - 1];
    const Vec3 after = points[i + 1] - points[i];
    angles.push_back(
        std::atan2(surface.normal(points[i]).dot(before.cross(after)), before.dot(after)));
  }
  return angles;
}

/// The true curve at the samples of each segment.
Array<Vec3> trueCurve(const SmoothSurface& surface, const Array<Vec3>& points) {
  Array<Vec3> curve;
  Vec3 start = points[1];
  for (int j = 0; j + 4 <= points.count(); ++j) {
    const Array<Vec3> four(points.begin() + j, points.begin() + j + 4);
    for (int i = 0; i < kSamples; ++i) {
      start = smoothCenter(surface, four,
                           uniformCubicBasis(static_cast<double>(i) / (kSamples - 1)), start);
      curve.push_back(start);
    }
  }
  return curve;
}

Measure measure(Surface& mesh, const SmoothSurface& surface, const Array<SurfacePoint>& points,
                const Array<Vec3>& truth, const FieldOptions& options) {
  Curve curve(mesh, {{CurveKind::kBSpline}, kSamples, options}, points);
  curve.updateFields();
  curve.trace();
  Measure result;
  result.meanEdge = mesh.geometry().meanEdge;
  result.diagonal = mesh.geometry().diagonal;
  double squares = 0;
  double noise = 0;
  int turns = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    Array<Vec3> found;
    for (const CurveSample& sample : curve.samples(j)) {
      result.lost += sample.status != Status::kConverged;
      found.push_back(surface.project(position(mesh.mesh(), sample.point)));
    }
    const Array<Vec3> expected(truth.begin() + j * kSamples, truth.begin() + (j + 1) * kSamples);
    for (int i = 0; i < kSamples; ++i) {
      const double error = (found[i] - expected[i]).norm();
      squares += error * error;
      result.maximum = std::max(result.maximum, error);
    }
    const Array<double> foundTurns = turningAngles(surface, found);
    const Array<double> trueTurns = turningAngles(surface, expected);
    for (int i = 0; i < foundTurns.count(); ++i) {
      noise += std::pow(foundTurns[i] - trueTurns[i], 2);
      ++turns;
    }
  }
  result.rms = std::sqrt(squares / (curve.segmentCount() * kSamples));
  result.turningNoise = std::sqrt(noise / turns);
  return result;
}

SmoothSurface smoothPlane() {
  return {[](const Vec3& x) { return Vec3(x.x(), x.y(), 0); },
          [](const Vec3&) { return Vec3(0, 0, 1); },
          [](const Vec3& p, const Vec3& v) { return Vec3(p + v); },
          [](const Vec3& p, const Vec3& q) { return Vec3(q - p); }};
}

Array<Family> families() {
  Array<Family> result;
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
    Array<Vec3> points;
    for (const Vec2& p : {Vec2(0.3, 0.35), Vec2(0.4, 0.62), Vec2(0.48, 0.4), Vec2(0.6, 0.66),
                          Vec2(0.68, 0.38), Vec2(0.74, 0.55)}) {
      points.emplace_back(p.x() + shear * p.y(), p.y(), 0);
    }
    result.push_back({std::string("plane: ") + tessellationName(tessellation),
                      [tessellation](int n) { return tessellatedPlane(tessellation, n, kSeed); },
                      smoothPlane(), points});
  }
  const SmoothSurface sphere = smoothSphere();
  Array<Vec3> onSphere;
  for (int i = 0; i < 6; ++i) {
    onSphere.push_back(sphere.project(Vec3(-0.6 + 0.25 * i, i % 2 ? 0.2 : -0.25, 0.9)));
  }
  result.push_back({"sphere: relaxed random points", [](int n) { return relaxedSphere(n, kSeed); },
                    sphere, onSphere});
  result.push_back({"sphere: random points, convex hull",
                    [](int n) { return randomSphere(n, kSeed); }, sphere, onSphere});
  result.push_back(
      {"sphere: jittered UV", [](int n) { return jitteredUvSphere(n, kSeed); }, sphere, onSphere});
  const SmoothSurface torus = smoothTorus(kTorusMajor, kTorusMinor);
  Array<Vec3> onTorus;
  for (int i = 0; i < 6; ++i) {
    const double u = 0.2 * i;
    const double v = i % 2 ? 0.35 : -0.3;
    const double ring = kTorusMajor + kTorusMinor * std::cos(v);
    onTorus.emplace_back(ring * std::cos(u), ring * std::sin(u), kTorusMinor * std::sin(v));
  }
  result.push_back({"torus: isotropic irregular", [](int n) { return irregularTorus(n, 1, kSeed); },
                    torus, onTorus});
  result.push_back(
      {"torus: stretched 8:1", [](int n) { return irregularTorus(n, 8, kSeed); }, torus, onTorus});
  return result;
}

std::string row(const Family& family, int triangles, const FieldMethod& method, const Measure& m,
                const Measure* coarser) {
  char order[32] = "";
  if (coarser && m.rms > kNegligible * m.diagonal) {
    std::snprintf(order, sizeof order, "%.2f",
                  std::log(coarser->rms / m.rms) / std::log(coarser->meanEdge / m.meanEdge));
  }
  char line[400];
  std::snprintf(
      line, sizeof line, "| %s | %d | %s | %.2e | %.2e | %.2e | %.2e | %.2e | %s | %d |\n",
      family.name.c_str(), triangles, method.name, m.rms / m.meanEdge, m.maximum / m.meanEdge,
      m.rms / m.diagonal, m.maximum / m.diagonal, m.turningNoise, order, m.lost);
  return line;
}

void study(const std::string& folder, double scale) {
  std::string table =
      "| surface | triangles | fields | RMS / h | maximum / h | RMS / box | maximum / box | "
      "turning noise, rad | order | lost |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  std::printf("%s", table.c_str());
  int plotNumber = 0;
  for (const Family& family : families()) {
    Array<Series> series;
    for (const FieldMethod& method : kMethods) series.push_back({method.name, {}, {}});
    Measure coarser[std::size(kMethods)];
    for (int size = 0; size < 3; ++size) {
      const int triangles = static_cast<int>(scale * 2000 * std::pow(3.2, size));
      Surface mesh(importMesh(family.mesh(triangles)).mesh);
      Array<SurfacePoint> points;
      Array<Vec3> onSurface;
      for (const Vec3& p : family.points) {
        points.push_back(nearestPoint(mesh.mesh(), p));
        onSurface.push_back(family.surface.project(position(mesh.mesh(), points.back())));
      }
      const Array<Vec3> truth = trueCurve(family.surface, onSurface);
      for (int i = 0; i < static_cast<int>(std::size(kMethods)); ++i) {
        const Measure m = measure(mesh, family.surface, points, truth, kMethods[i].options);
        const std::string line =
            row(family, mesh.mesh().faceCount(), kMethods[i], m, size > 0 ? &coarser[i] : nullptr);
        std::printf("%s", line.c_str());
        std::fflush(stdout);
        table += line;
        series[i].x.push_back(m.meanEdge / m.diagonal);
        series[i].y.push_back(m.rms / m.diagonal);
        coarser[i] = m;
      }
    }
    if (!folder.empty()) {
      std::ofstream(folder + "/accuracy-" + std::to_string(++plotNumber) + ".svg") << logLogPlot(
          family.name, "mean edge / bounding box", "RMS error / bounding box", series);
    }
  }
  if (!folder.empty()) std::ofstream(folder + "/accuracy.md") << table;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  try {
    karcher::study(argc > 1 ? argv[1] : "", argc > 2 ? std::atof(argv[2]) : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

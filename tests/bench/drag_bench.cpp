#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "mesh/mesh_import.h"

/// Steps of a drag in native code: the twin of drag_bench.mjs, which does the same in WebAssembly.
///
///   drag_bench plan MESH.obj SPACING|POINTS.txt    prints a drag: control points and places
///   drag_bench run MESH.obj PLAN LEVELS            prints its times as a JSON object
///
/// A plan has the number of control points, then these and the places of the second of them, as
/// lines `face b1 b2` in the file's own numbers.
namespace karcher {
namespace {

constexpr int kDragged = 1;
constexpr int kPlaces = 20;
/// The step from place to place, in mean edges.
constexpr double kStep = 0.2;

struct Plan {
  Array<SurfacePoint> polygon;
  Array<SurfacePoint> places;
};

void print(const Numbering& numbering, const Array<SurfacePoint>& points) {
  for (const SurfacePoint& point : points) {
    const SurfacePoint p = toInput(numbering, point);
    std::printf("%d %.17g %.17g\n", p.face, p.bary[1], p.bary[2]);
  }
}

void printPlan(const ImportedMesh& imported, const std::string& meshPath, const std::string& of) {
  Surface surface(TriangleMesh(imported.mesh));
  const Geometry& geometry = surface.geometry();
  char* end = nullptr;
  const double spacing = std::strtod(of.c_str(), &end);
  const bool isSpacing = *end == '\0';
  Random random(1);
  Array<SurfacePoint> polygon;
  Array<SurfacePoint> places;
  while (places.empty()) {
    polygon = isSpacing ? randomControlPolygon(geometry, random, {.spacing = spacing})
                        : loadBenchMesh(meshPath, of).points;
    const Vec2 direction = Eigen::Rotation2Dd(random.uniform(-kPi, kPi)) * Vec2::UnitX();
    places =
        dragPath(geometry, polygon.at(kDragged), direction, kStep * geometry.meanEdge, kPlaces);
  }
  std::printf("%d\n", polygon.count());
  print(imported.numbering, polygon);
  print(imported.numbering, places);
}

Plan readPlan(const ImportedMesh& imported, const std::string& path) {
  std::istringstream lines(readFile(path));
  Plan plan;
  int polygon = 0;
  int face = 0;
  double b1 = 0;
  double b2 = 0;
  lines >> polygon;
  while (lines >> face >> b1 >> b2) {
    Array<SurfacePoint>& points = plan.polygon.count() < polygon ? plan.polygon : plan.places;
    points.push_back(toEngine(imported.numbering, imported.mesh, face, {1 - b1 - b2, b1, b2}));
  }
  return plan;
}

void runPlan(ImportedMesh imported, const std::string& planPath, int levels) {
  const Plan plan = readPlan(imported, planPath);
  Surface surface(std::move(imported.mesh));
  CurveOptions options;
  options.shape.kind = plan.polygon.count() == 4 ? CurveKind::kBezier : CurveKind::kBSpline;
  options.samples = 128;
  options.levels = levels;
  options.levels = Curve(surface, options, plan.polygon).levels();
  Curve curve(surface, options, plan.polygon);

  Array<double> steps;
  double length = 0;
  const auto dragThere = [&](const SurfacePoint& place) {
    steps.push_back(processorTimed([&] { curve.dragPoint(kDragged, place); }));
  };
  // Drags there and back until `ms` have passed, and returns the first steps.
  const auto drag = [&](double ms) {
    steps.clear();
    const double start = processorMilliseconds();
    do {
      for (int i = 1; i < plan.places.count(); ++i) dragThere(plan.places[i]);
      length = 0;
      for (int j = 0; j < curve.segmentCount(); ++j) length += curve.path(j).line.length();
      for (int i = plan.places.count() - 2; i >= 0; --i) dragThere(plan.places[i]);
    } while (processorMilliseconds() - start < ms);
  };
  drag(1000);
  const Array<double> first(steps.begin(), steps.begin() + 5);
  drag(500);
  std::printf("{\"levels\":%d,\"stepMs\":%.4f,\"firstMs\":%.4f,\"length\":%.9g}\n", options.levels,
              median(steps), median(first), length);
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  try {
    if (name == "plan" && argc == 4) {
      karcher::printPlan(karcher::importObj(karcher::readFile(argv[2])), argv[2], argv[3]);
    } else if (name == "run" && argc == 5) {
      karcher::runPlan(karcher::importObj(karcher::readFile(argv[2])), argv[3], std::atoi(argv[4]));
    } else {
      std::fprintf(stderr,
                   "usage: drag_bench plan MESH.obj SPACING|POINTS.txt\n"
                   "       drag_bench run MESH.obj PLAN LEVELS\n");
      return 1;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

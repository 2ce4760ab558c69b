#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "generators/curve_shapes.h"
#include "rcm/exact_minimum.h"

/// The breaks of curves of level 0, by both solvers, and the breaks at which the energy by exact
/// distances breaks, too. The curves are random cubic Bezier curves with 128 samples.
///
///   breaks_study [--polygons N] [--seed S] MESH.obj [MESH.obj ...]
///
/// At the middle of a break the study looks for the energy's minimum from both of its ends, by
/// exact distances. If the two searches end apart, the mean has to jump whatever the solver.
/// Otherwise the break comes from the solver's fields.
namespace karcher {
namespace {

constexpr int kSamples = 128;
constexpr double kSpacings[] = {0.05, 0.1, 0.2};
/// The distance, in mean edges, below which two ends of searches are one minimum: the width of the
/// circles.
constexpr double kApart = 2 * kCheckedRadius;

struct Arguments {
  int polygons = 30;
  uint64_t seed = 1;
  Array<std::string> meshes;
};

struct Tally {
  int samples = 0;
  int bridged = 0;
  int breaks = 0;
  int ofEnergy = 0;    ///< breaks with two minima by exact distances
  double longest = 0;  // the longest other break, in mean edges
};

Curve trace(Surface& surface, const Array<SurfacePoint>& points, Solver solver) {
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, kSamples, {Method::kKarcher, solver, 6});
  return Curve(surface, options, points);
}

/// The ends of the searches for the exact minimum at a break, from both of its sides.
bool breaksByEnergy(Curve& curve, const Bridge& bridge) {
  const Geometry& geometry = curve.surface().geometry();
  const TriangleMesh& mesh = *geometry.mesh;
  const Array<double> weights = curve.weights(0, (bridge.t0 + bridge.t1) / 2);
  Vec3 ends[2];
  for (int side = 0; side < 2; ++side) {
    ExactEnergy energy(geometry, curve.points(), weights);
    const Array<SurfacePoint>& line = bridge.line.path.points;
    const SurfacePoint& start = side == 0 ? line.front() : line.back();
    ends[side] = position(mesh, exactMinimumNear(geometry, energy, start).point);
  }
  return (ends[0] - ends[1]).norm() > kApart * geometry.meanEdge;
}

void count(Curve& curve, Tally& tally) {
  const TriangleMesh& mesh = curve.surface().mesh();
  for (const CurveSample& sample : curve.samples(0)) {
    ++tally.samples;
    tally.bridged += sample.status != SampleStatus::kConverged;
  }
  for (const Bridge& bridge : curve.bridges(0)) {
    ++tally.breaks;
    if (breaksByEnergy(curve, bridge)) {
      ++tally.ofEnergy;
      continue;
    }
    const Array<SurfacePoint>& line = bridge.line.path.points;
    const double length = (position(mesh, line.front()) - position(mesh, line.back())).norm();
    tally.longest = std::max(tally.longest, length / curve.surface().geometry().meanEdge);
  }
}

void study(const std::string& path, const Arguments& arguments) {
  Surface surface(loadBenchMesh(path, "").mesh);
  for (const double spacing : kSpacings) {
    ControlPolygonOptions options;
    options.spacing = spacing;
    Random random(arguments.seed);
    Array<Array<SurfacePoint>> polygons;
    for (int i = 0; i < arguments.polygons; ++i) {
      polygons.push_back(randomControlPolygon(surface.geometry(), random, options));
    }
    for (const Solver solver : {Solver::kFast, Solver::kExact}) {
      Tally tally;
      for (const Array<SurfacePoint>& polygon : polygons) {
        Curve curve = trace(surface, polygon, solver);
        count(curve, tally);
      }
      std::printf("| %s | %.2f | %s | %.2f %% | %d | %d | %d | %.1f |\n",
                  path.substr(path.rfind('/') + 1).c_str(), spacing,
                  solver == Solver::kFast ? "fast" : "exact", 100.0 * tally.bridged / tally.samples,
                  tally.breaks, tally.ofEnergy, tally.breaks - tally.ofEnergy, tally.longest);
      std::fflush(stdout);
    }
  }
}

Arguments parse(int argc, char** argv) {
  Arguments result;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--polygons" && i + 1 < argc) {
      result.polygons = std::atoi(argv[++i]);
    } else if (argument == "--seed" && i + 1 < argc) {
      result.seed = std::strtoull(argv[++i], nullptr, 10);
    } else {
      result.meshes.push_back(argument);
    }
  }
  return result;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  const karcher::Arguments arguments = karcher::parse(argc, argv);
  if (arguments.meshes.empty()) {
    std::fprintf(stderr, "usage: breaks_study [--polygons N] [--seed S] MESH.obj ...\n");
    return 1;
  }
  try {
    std::printf(
        "| mesh | spacing | solver | bridged | breaks | two minima by exact distances | one | "
        "longest of these, mean edges |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const std::string& mesh : arguments.meshes) karcher::study(mesh, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

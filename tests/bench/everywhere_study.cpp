#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "bench_support.h"
#include "distance/sight.h"
#include "generators/curve_shapes.h"
#include "measures/allocations.h"
#include "steadiness.h"

/// The speed and the smoothness of the default curve on every mesh, beside those of the limit of
/// subdivision with a new search for every path. The curves are cubic Bezier curves of random
/// polygons at .05 to .3 of the bounding box's diagonal. Each mesh and spacing has a row.
///
///   everywhere_study [OPTIONS] MESH ...
///
/// A mesh is an OBJ file or the name of a built-in shape. The options:
///   --polygons 12     random control polygons a spacing, each dragged once
///   --steps 20        steps a drag, each a tenth of a mean edge
///   --spacing 0.1     this spacing alone
///   --seconds 0       time for the polygons and steps of a spacing; 0 for no end
///   --seed 1
///   --exact 20000     most triangles of meshes with curves of exact distances
///   --memory          memory of a curve at .3, in place of the table
namespace karcher {
namespace {

constexpr double kSpacings[] = {0.05, 0.1, 0.2, 0.3};
constexpr double kFarSpacing = 0.3;

struct Options {
  Array<std::string> meshes;
  Array<double> spacings{std::begin(kSpacings), std::end(kSpacings)};
  int polygons = 12;
  int steps = 20;
  int seconds = 0;
  int seed = 1;
  int exact = 20'000;
  bool memory = false;
};

CurveOptions defaultBezier() {
  CurveOptions options = ofLevelZero({CurveKind::kBezier}, kSteadySamples, {});
  options.levels = kAutomaticLevels;
  return options;
}

/// The figures of a kind of curve, for all polygons of a spacing together.
struct KindFigures {
  Array<double> firstMs;
  Array<double> stepMs;
  Array<double> turnings;
  Array<double> levels;
  // Figures of first traces and of steps.
  Array<double> piecesBridged;
  Array<double> piecesSubdivided;
  int lost = 0;
  Array<double> released;  // the distance by which release moves a curve, as a part of its length
  int drafts = 0;          // drags that end with other levels than those of the released curve
};

void addTrace(KindFigures& figures, const TracedCurve& traced) {
  figures.levels.push_back(traced.levels);
  figures.piecesBridged.push_back(traced.piecesBridged);
  figures.piecesSubdivided.push_back(traced.piecesSubdivided);
  figures.lost += traced.lost;
}

/// The time after which a spacing stops.
struct Deadline {
  double at = kInfinity;  ///< the time in milliseconds
  bool isOver() const { return milliseconds() > at; }
};

/// Draws a curve, then drags it by at least one step.
void drawAndDrag(const TurningMeasure& measure, Surface& surface, const SteadyVariant& variant,
                 const Drag& drag, const Deadline& deadline, KindFigures& figures) {
  TracedCurve traced;
  figures.firstMs.push_back(processorTimed([&] { traced = variant.trace(surface, drag.polygon); }));
  figures.turnings.push_back(turning(measure, traced.polyline));
  addTrace(figures, traced);
  const HeldCurve held = variant.hold(surface, drag.polygon);
  for (int i = 1; i < drag.path.count() && !(i > 1 && deadline.isOver()); ++i) {
    traced = held.drag(Drag::kPoint, drag.path[i]);
    figures.stepMs.push_back(traced.ms);
    addTrace(figures, traced);
  }
  const TracedCurve released = held.release();
  figures.drafts += released.levels != traced.levels;
  figures.released.push_back(partMoved(traced.polyline, released.polyline));
}

/// The number of values of near fields at the corners of the faces that a curve's pieces cross, and
/// the number of those that sight does not find. Each of these takes a path search.
struct Sighted {
  int values = 0;
  int unseen = 0;
};

void addSighted(const Curve& curve, Sighted& sighted) {
  if (curve.levels() < 1) return;
  const Geometry& geometry = curve.surface().geometry();
  SightSources sources;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (int k = 0; k < curve.piecesPerSegment(); ++k) {
      const Curve::Piece& piece = curve.piece(j, k);
      if (piece.isSubdivided()) continue;
      std::set<int> vertices;
      for (const SurfacePoint& p : piece.path().line.points) {
        for (int c = 0; c < 3; ++c) vertices.insert(geometry.mesh->corner(p.face, c));
      }
      for (const SurfacePoint& p : piece.points()) {
        findSightSources(geometry, p, sources);
        for (const int v : vertices) {
          ++sighted.values;
          sighted.unseen += !sightFrom(geometry, sources, v);
        }
      }
    }
  }
}

/// The places of a curve's samples in space.
Array<Vec3> sampled(const Curve& curve) {
  Array<Vec3> positions;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (const CurveSample& sample : curve.samples(j)) {
      positions.push_back(position(curve.surface().mesh(), sample.point));
    }
  }
  return positions;
}

/// Appends the distances, in mean edges, between the samples of a default curve and those of the
/// curve of exact distances with equally many levels.
void appendFromExact(Surface& surface, const Array<SurfacePoint>& points, Array<double>& out) {
  CurveOptions options = defaultBezier();
  const Curve curve(surface, options, points);
  options.levels = curve.levels();
  options.field.solver = Solver::kExact;
  const Curve exact(surface, options, points);
  const Array<Vec3> here = sampled(curve);
  const Array<Vec3> there = sampled(exact);
  for (int i = 0; i < here.count(); ++i) {
    out.push_back((here[i] - there[i]).norm() / surface.geometry().meanEdge);
  }
}

void printRow(Surface& surface, const TurningMeasure& measure, double spacing,
              const Options& options) {
  const SteadyVariant automatic = steadyVariant("auto");
  const SteadyVariant limit = steadyVariant("limit");
  Random random(static_cast<uint64_t>(options.seed));
  KindFigures ours;
  KindFigures limits;
  Array<double> fromExact;
  Sighted sighted;
  int drawn = 0;
  Deadline deadline;
  if (options.seconds > 0) deadline.at = milliseconds() + 1e3 * options.seconds;
  while (drawn < options.polygons && !(drawn > 0 && deadline.isOver())) {
    const Drag drag = randomDrag(surface.geometry(), random, {.spacing = spacing}, options.steps);
    drawAndDrag(measure, surface, automatic, drag, deadline, ours);
    drawAndDrag(measure, surface, limit, drag, deadline, limits);
    addSighted(Curve(surface, defaultBezier(), drag.polygon), sighted);
    if (surface.mesh().faceCount() <= options.exact) {
      appendFromExact(surface, drag.polygon, fromExact);
    }
    ++drawn;
  }
  std::printf(
      "| %g | %d | %.2f | %.2f / %.2f | %.2f | %.1f | %.1f | %.2f / %.2f %% | %.2f %% | %d | %.0f "
      "/ "
      "%.0f° ",
      spacing, drawn, median(ours.firstMs), median(ours.stepMs), quantile(ours.stepMs, 1),
      median(limits.stepMs), median(ours.stepMs) / median(limits.stepMs), mean(ours.levels),
      100 * mean(ours.piecesSubdivided), 100 * mean(ours.piecesBridged),
      100.0 * sighted.unseen / std::max(1, sighted.values), ours.lost, median(ours.turnings),
      median(limits.turnings));
  std::printf("| %d, %.2f %% |", ours.drafts, 100 * quantile(ours.released, 1));
  if (fromExact.empty()) {
    std::printf(" - |\n");
  } else {
    std::printf(" %.4f / %.3f |\n", median(fromExact), quantile(fromExact, 1));
  }
  std::fflush(stdout);
}

/// Prints the time and memory of a first and a second curve of distant points, including all data
/// for the mesh.
void printMemory(Surface& surface, const Options& options) {
  Random random(static_cast<uint64_t>(options.seed));
  for (const char* which : {"first", "second"}) {
    const Array<SurfacePoint> points =
        randomControlPolygon(surface.geometry(), random, {.spacing = kFarSpacing});
    const int64_t taken = bytesTakenSoFar();
    const int64_t held = bytesHeld();
    const Curve made(surface, defaultBezier(), points);
    std::printf("The %s curve at %g takes %.2f MB and holds %.2f MB.\n", which, kFarSpacing,
                1e-6 * static_cast<double>(bytesTakenSoFar() - taken),
                1e-6 * static_cast<double>(bytesHeld() - held));
  }
}

void study(const std::string& name, const Options& options) {
  Surface surface(studyMesh(name));
  const Geometry& geometry = surface.geometry();
  const double prepareMs = processorTimed([&] { prepareFields(surface, {}); });
  std::printf("\n## %s\n\n%d triangles, the diagonal is %.0f mean edges long",
              meshName(name).c_str(), surface.mesh().faceCount(),
              geometry.diagonal / geometry.meanEdge);
  if (options.memory) {
    std::printf(".\n");
    printMemory(surface, options);
    return;
  }
  Random random(static_cast<uint64_t>(options.seed));
  const Array<SurfacePoint> points =
      randomControlPolygon(geometry, random, {.spacing = options.spacings[0]});
  const double firstMs = processorTimed([&] { steadyVariant("auto").trace(surface, points); });
  std::printf("; prepared in %.1f ms, then its very first curve takes %.2f ms.\n\n", prepareMs,
              firstMs);
  std::printf(
      "| spacing | curves | first trace: ms | step: ms | limit: ms | step / limit, of ms | levels "
      "| subdivided / "
      "bridged | "
      "no sight | lost | turning / limit's | drafts, release | from exact |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const TurningMeasure measure(surface.mesh());
  for (const double spacing : options.spacings) {
    try {
      printRow(surface, measure, spacing, options);
    } catch (const std::exception& error) {
      std::printf("| %g | none: %s |\n", spacing, error.what());
    }
  }
}

Options parse(int argc, char** argv) {
  Options options;
  const std::map<std::string, int*> numbers = {{"--polygons", &options.polygons},
                                               {"--steps", &options.steps},
                                               {"--seconds", &options.seconds},
                                               {"--seed", &options.seed},
                                               {"--exact", &options.exact}};
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument.rfind("--", 0) != 0) {
      options.meshes.push_back(argument);
      continue;
    }
    if (argument == "--memory") {
      options.memory = true;
      continue;
    }
    const std::string value = ++i < argc ? argv[i] : "";
    if (const auto number = numbers.find(argument); number != numbers.end()) {
      *number->second = std::atoi(value.c_str());
    } else if (argument == "--spacing") {
      options.spacings = {std::atof(value.c_str())};
    } else {
      throw std::runtime_error("there is no option " + argument);
    }
  }
  if (options.meshes.empty()) {
    throw std::runtime_error("usage: everywhere_study [OPTIONS] MESH ...");
  }
  if (options.polygons < 1 || options.steps < 1) {
    throw std::runtime_error("--polygons and --steps take at least 1");
  }
  if (!(options.spacings[0] > 0)) throw std::runtime_error("a spacing must be positive");
  return options;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    const Options options = parse(argc, argv);
    std::printf(
        "Cubic Bezier curves of 4 points, `levels: auto`, %d samples; %d random polygons a spacing "
        "(a leg, in diagonals), each dragged %d steps of a tenth of a mean edge; seed %d.\n\n"
        "Milliseconds of the processor: 'first trace' the median, 'step' the median and the worst, "
        "'limit' the median step of the subdivision curve with every path searched anew. "
        "'Subdivided': pieces that are their own subdivision, 'bridged': others with a bridge. 'No "
        "sight': of the values of near fields along the curve, those that take a path search. "
        "'Lost': "
        "samples that are neither centers of mass nor on a bridge. 'Drafts': drags that end with "
        "other levels than the curve after release; 'release': how far that moves it at "
        "most, as a part of its length. 'From exact': how far samples lie from those with exact "
        "distances at equal levels, median and largest, in mean edges.\n",
        kSteadySamples, options.polygons, options.steps, options.seed);
    for (const std::string& mesh : options.meshes) study(mesh, options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

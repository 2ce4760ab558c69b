#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "bench_support.h"
#include "generators/rough.h"
#include "plot.h"
#include "steadiness.h"

/// The steadiness of cubic Bezier curves whose neighboring control points lie .05 to .3 of the
/// bounding box's diagonal apart: their turning, their gaps, their stillness in a drag of a control
/// point, and the time of a step of the hand.
///
///   steadiness_study [OPTIONS] MESH ...
///
/// A mesh is an OBJ file or the name of a built-in shape. The options:
///   --polygons 30        random control polygons a spacing; 0 for no table of curves
///   --drags 20           drags a spacing; 0 for no table of drags
///   --steps 100          steps a drag, each a tenth of a mean edge
///   --spacing 0.1        this spacing alone
///   --levels 0,1,2,3,4,auto,averages,limit
///                        variants: levels up to 8, automatic levels, or the subdivision curve by
///                        the engine and by itself (steady_variants.h); the last is the reference
///   --seed 1
///   --worst 0            number of the farthest leaps to list, by the indices of drag and step
///   --rough 4            on the meshes with every face cut into 4^2, as noisy scans (rough.h)
///   --plots FOLDER       pictures of the tables
///   --reference FOLDER   folder with reference/bsurf/MESH.json: curves of another program for
///                        comparison, and their control points
namespace karcher {
namespace {

constexpr double kSpacings[] = {0.05, 0.1, 0.2, 0.3};
/// The excess turning of curves over the smoothest ones, in degrees, that does not count.
constexpr double kFreeTurning = 5;

struct Options {
  Array<std::string> meshes;
  Array<double> spacings{std::begin(kSpacings), std::end(kSpacings)};
  Array<SteadyVariant> variants;
  int polygons = 30;
  int drags = 20;
  int steps = 100;
  int seed = 1;
  int rough = 0;
  int worst = 0;
  std::string plots;
  std::string reference;
};

struct Plots {
  Array<Series> turning;
  Array<Series> shiver;
  Array<Series> ms;
};

/// The excess turning of curves over those of another kind: (turning - kFreeTurning) / theirs.
Array<double> excess(const Array<double>& turnings, const Array<double>& theirs) {
  Array<double> ratios;
  for (int i = 0; i < turnings.count(); ++i) {
    ratios.push_back((turnings[i] - kFreeTurning) / theirs[i]);
  }
  return ratios;
}

void printCurves(Surface& surface, const TurningMeasure& measure, const Options& options,
                 Plots& plots) {
  std::printf(
      "\n| spacing | levels | turning | 90 %% of them | beside the last | bridged | lost | from "
      "the first | from the one before | joints | first trace |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const double spacing : options.spacings) {
    Random random(static_cast<uint64_t>(options.seed));
    Array<Array<SurfacePoint>> polygons;
    for (int i = 0; i < options.polygons; ++i) {
      polygons.push_back(randomControlPolygon(surface.geometry(), random, {.spacing = spacing}));
    }
    Array<CurveFigures> figures;
    for (const SteadyVariant& variant : options.variants) {
      figures.push_back(measureCurves(measure, surface, variant, polygons));
    }
    for (int i = 0; i < figures.count(); ++i) {
      const CurveFigures& f = figures[i];
      std::printf(
          "| %g | %s (%.1f) | %.0f° | %.0f° | %.2f | %.2f %% | %d | %.2f %% | %.2f %% | %.2f° | "
          "%.2f ms |\n",
          spacing, options.variants[i].name.c_str(), mean(f.levels), median(f.turnings),
          quantile(f.turnings, 0.9), median(excess(f.turnings, figures.back().turnings)),
          100 * mean(f.bridged), f.lost, 100 * median(partsMoved(figures[0], f)),
          100 * median(partsMoved(figures[std::max(0, i - 1)], f)), quantile(f.corners, 1),
          median(f.ms));
      plots.turning[i].x.push_back(spacing);
      plots.turning[i].y.push_back(median(f.turnings));
    }
    std::fflush(stdout);
  }
}

/// The distance by which release to automatic levels moves a draft: median and largest.
std::string toAutomatic(const HandFigures& figures) {
  const Array<double>& parts = figures.releasedToAutomatic;
  if (parts.empty()) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.2f / %.2f %%", 100 * median(parts), 100 * quantile(parts, 1));
  return text;
}

void printDrags(Surface& surface, const Options& options, Plots& plots) {
  std::printf(
      "\n| spacing | levels | shiver | largest leap | left out | their leap | beyond | passing "
      "averages | their leap | other shiver | its largest leap | bridged | lost | release | to "
      "auto "
      "on release | step | 90 %% of them | step / the last, of ms | allocations | its stages, ms "
      "|\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | "
      "--- | --- | --- | --- | --- |\n");
  for (const double spacing : options.spacings) {
    Random random(static_cast<uint64_t>(options.seed));
    Array<Drag> drags;
    for (int i = 0; i < options.drags; ++i) {
      drags.push_back(randomDrag(surface.geometry(), random, {.spacing = spacing}, options.steps));
    }
    const Array<HandFigures> figures = measureDrags(surface, options.variants, drags);
    for (int i = 0; i < figures.count(); ++i) {
      const HandFigures& f = figures[i];
      std::printf(
          "| %g | %s | %.2f %% | %.1f | %.2f %% | %.2f | %.2f %% | %.2f %% | %.2f | %.2f %% | %.1f "
          "| %.2f %% | %d | %.2f %% | %s | %.2f ms | %.2f ms | %.2f | %.0f |",
          spacing, options.variants[i].name.c_str(), 100 * f.motion.shiverShare(),
          f.motion.largestLeap, 100 * f.motion.passingShare(), f.motion.largestPassing,
          100 * f.motion.beyondShare(), 100.0 * f.averages.passing / std::max(1, f.motion.steps),
          f.averages.largestPassing, 100.0 * f.averages.unexplained / std::max(1, f.motion.steps),
          f.averages.largestLeap, 100 * f.bridged / f.ms.count(), f.lost,
          100 * quantile(f.released, 1), toAutomatic(f).c_str(), median(f.ms), quantile(f.ms, 0.9),
          median(f.ms) / median(figures.back().ms), median(f.allocations));
      for (const std::string& stage : f.stages) {
        std::printf(" %s %.2f", stage.c_str(), median(f.stageMs.at(stage)));
      }
      std::printf(" |\n");
      plots.shiver[i].x.push_back(spacing);
      plots.shiver[i].y.push_back(std::max(1e-4, f.motion.shiverShare()));
      plots.ms[i].x.push_back(spacing);
      plots.ms[i].y.push_back(median(f.ms));
    }
    for (int i = 0; i < figures.count(); ++i) {
      const Array<Leap>& leaps = figures[i].leaps;
      for (int k = 0; k < std::min(options.worst, leaps.count()); ++k) {
        const Leap& leap = leaps[k];
        std::printf("%s at %g: drag %d leaps by %.1f in step %d; legs allow %.1f, averages %.1f\n",
                    options.variants[i].name.c_str(), spacing, leap.drag, leap.motion, leap.step,
                    leap.allowedByLegs, leap.allowedByAverages);
      }
    }
    std::fflush(stdout);
  }
}

/// The turning of another program's curves and of ours with the same control points, by spacing.
struct Compared {
  Array<double> theirs;
  Array<Array<double>> ours;  ///< the turning of our curves, by variant
};

void compare(const std::string& mesh, const Options& options,
             std::map<double, Compared>& compared) {
  const std::string file = options.reference + "/reference/bsurf/" + meshName(mesh) + ".json";
  if (!std::ifstream(file)) return;
  const std::string json = readFile(file);
  Surface surface(studyMesh(mesh));
  const TurningMeasure measure(surface.mesh());
  constexpr const char* kPoints = "\"points\":\"";
  for (size_t at = json.find(kPoints); at != std::string::npos; at = json.find(kPoints, at)) {
    at += std::char_traits<char>::length(kPoints);
    const std::string points = json.substr(at, json.find('"', at) - at);
    constexpr const char* kSpacing = "\"spacing\":";
    const size_t spacingAt = json.find(kSpacing, at) + std::char_traits<char>::length(kSpacing);
    const double spacing = std::strtod(json.c_str() + spacingAt, nullptr);
    const Array<Vec3> theirs = readPositions(json, "laneRiesenfeld", at);
    const Array<SurfacePoint> polygon =
        loadBenchMesh(mesh, options.reference + "/" + points).points;
    Compared& entry = compared[spacing];
    entry.theirs.push_back(turning(measure, theirs));
    entry.ours.resize(options.variants.size());
    std::printf("| %s | %.0f° |", meshName(points).c_str(), entry.theirs.back());
    for (int i = 0; i < options.variants.count(); ++i) {
      const TracedCurve traced = options.variants[i].trace(surface, polygon);
      entry.ours[i].push_back(turning(measure, traced.polyline));
      std::printf(" %.0f°", entry.ours[i].back());
      if (traced.bridged > 0) std::printf(" (%.1f %%)", 100 * traced.bridged);
      std::printf(" |");
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

void printComparison(const Options& options) {
  std::string names;
  std::string rule;
  for (const SteadyVariant& variant : options.variants) {
    names += " " + variant.name + " |";
    rule += " --- |";
  }
  std::printf(
      "\nTurning of b/Surf's Lane-Riesenfeld curve and of ours (bridged):\n\n"
      "| control points | b/Surf |%s\n| --- | --- |%s\n",
      names.c_str(), rule.c_str());
  std::map<double, Compared> compared;
  for (const std::string& mesh : options.meshes) compare(mesh, options, compared);
  std::printf(
      "\n(turning - %g°) / b/Surf's, median over all meshes' polygons:\n\n"
      "| spacing | polygons |%s\n| --- | --- |%s\n",
      kFreeTurning, names.c_str(), rule.c_str());
  for (const auto& [spacing, entry] : compared) {
    std::printf("| %g | %d |", spacing, entry.theirs.count());
    for (const Array<double>& ours : entry.ours) {
      std::printf(" %.2f |", median(excess(ours, entry.theirs)));
    }
    std::printf("\n");
  }
}

void study(const std::string& name, const Options& options) {
  TriangleMesh mesh = studyMesh(name);
  if (options.rough > 0) {
    const TriangleSoup soup = roughened(mesh, options.rough, static_cast<uint64_t>(options.seed));
    mesh = buildMesh(soup.positions, soup.triangles);
  }
  Surface surface(std::move(mesh));
  const Geometry& geometry = surface.geometry();
  const TurningMeasure measure(surface.mesh());
  std::printf("\n## %s\n\n%d triangles, the diagonal is %.0f mean edges long.\n",
              meshName(name).c_str(), surface.mesh().faceCount(),
              geometry.diagonal / geometry.meanEdge);
  Plots plots;
  for (const SteadyVariant& variant : options.variants) {
    for (Array<Series>* series : {&plots.turning, &plots.shiver, &plots.ms}) {
      series->push_back({variant.name, {}, {}});
    }
  }
  if (options.polygons > 0) printCurves(surface, measure, options, plots);
  if (options.drags > 0) printDrags(surface, options, plots);
  if (options.plots.empty()) return;
  const std::string stem = options.plots + "/steadiness-" + meshName(name);
  const std::string x = "spacing / bounding box";
  std::ofstream(stem + "-turning.svg")
      << logLogPlot(meshName(name), x, "turning, deg", plots.turning);
  std::ofstream(stem + "-shiver.svg") << logLogPlot(meshName(name), x, "shiver", plots.shiver);
  std::ofstream(stem + "-step.svg") << logLogPlot(meshName(name), x, "ms a step", plots.ms);
}

/// The variants of a comma-separated list of names.
Array<SteadyVariant> variantsOf(const std::string& names) {
  Array<SteadyVariant> variants;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) variants.push_back(steadyVariant(name));
  return variants;
}

Options parse(int argc, char** argv) {
  Options options;
  std::string levels = "0,1,2,3,4,auto,averages,limit";
  const std::map<std::string, int*> numbers = {
      {"--polygons", &options.polygons}, {"--drags", &options.drags}, {"--steps", &options.steps},
      {"--seed", &options.seed},         {"--rough", &options.rough}, {"--worst", &options.worst}};
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (argument.rfind("--", 0) != 0) {
      options.meshes.push_back(argument);
      continue;
    }
    ++i;
    if (const auto number = numbers.find(argument); number != numbers.end()) {
      *number->second = std::atoi(value.c_str());
    } else if (argument == "--spacing") {
      options.spacings = {std::atof(value.c_str())};
    } else if (argument == "--levels") {
      levels = value;
    } else if (argument == "--plots") {
      options.plots = value;
    } else if (argument == "--reference") {
      options.reference = value;
    } else {
      throw std::runtime_error("there is no option " + argument);
    }
  }
  if (options.meshes.empty())
    throw std::runtime_error("usage: steadiness_study [OPTIONS] MESH ...");
  options.variants = variantsOf(levels);
  if (options.variants.empty()) throw std::runtime_error("--levels must name at least one variant");
  if (options.polygons < 0 || options.drags < 0 || options.steps < 1) {
    throw std::runtime_error("--polygons and --drags take at least 0, --steps at least 1");
  }
  for (const double spacing : options.spacings) {
    if (!(spacing > 0)) throw std::runtime_error("a spacing must be positive");
  }
  return options;
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  using namespace karcher;
  try {
    const Options options = parse(argc, argv);
    std::printf(
        "Cubic Bezier curves of 128 samples, %d random polygons and %d drags of %d steps a "
        "spacing, seed %d.\n\n"
        "'Shiver': steps in which the curve moves more than %g times as far as the hand. Leaps are "
        "in steps of the hand. 'Left out': steps in which a leg passed a vertex that allows such "
        "leaps; 'their leap', as a part of what all passages of the step allow, those of the "
        "averages' paths too; 'beyond', those that leap farther. "
        "'Passing averages': of the steps that count, those that shiver where the paths of "
        "averages passed vertices that allow it. "
        "'To auto on release': how far the curve moves where the drag showed a draft of the one of "
        "automatic levels, median and largest of the drags. "
        "Times are of the processor. Distances between curves ('from level 0', 'release') are "
        "parts "
        "of their lengths.\n",
        options.polygons, options.drags, options.steps, options.seed, DragFigures::kShiver);
    for (const std::string& mesh : options.meshes) study(mesh, options);
    if (!options.reference.empty()) printComparison(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "bench_support.h"
#include "curves/curve_value.h"
#include "curves/spec/bases.h"
#include "generators/accuracy.h"
#include "mesh/mesh_import.h"
#include "peers/compared_curve.h"
#include "plot.h"

/// The distance of a B-spline on a mesh of a smooth surface from the true one on the surface, at
/// three sizes. The study takes the paper's fields and log vectors, and the paper's method also as
/// its authors run it; lost samples do not count. It prints Markdown. With a folder as argument it
/// writes accuracy.md and a plot for each surface there.
///
///   accuracy_study [FOLDER] [SCALE]      SCALE multiplies the triangle counts; 1 by default
namespace karcher {
namespace {

constexpr double kNegligible = 1e-11;

struct FieldMethod {
  const char* name;
  FieldOptions options;
  bool byAuthors = false;  ///< searches start as in the program of the paper's authors
  int levels = 0;
};

const FieldMethod kMethods[] = {
    {"paper, exact", {Method::kPaper, Solver::kExact, 6}},
    {"paper, exact, authors' seeds", {Method::kPaper, Solver::kExact, 6}, true},
    {"paper, graph", {Method::kPaper, Solver::kGraph, 6}},
    {"default", {Method::kKarcher, Solver::kFast, 6}, false, kAutomaticLevels},
    {"log, fast", {Method::kKarcher, Solver::kFast, 6}},
    {"log, exact", {Method::kKarcher, Solver::kExact, 6}},
};

/// The curve of the family's points with the starts of the authors' program (Seeds::kAuthors).
Accuracy measureByAuthors(AccuracyCase& example, const FieldOptions& options) {
  constexpr int kSamples = 128;
  constexpr int kSegmentPoints = 4;
  ComparedOptions compared;
  compared.field = options;
  compared.seeds = Seeds::kAuthors;
  PreparedMethod method(example.surface, compared);
  ComparedPlan plan;
  plan.points = example.points;
  for (int j = 0; j + kSegmentPoints <= example.points.count(); ++j) plan.first.push_back(j);
  plan.table = tabulate(uniformCubicBasis, kSamples);
  ComparedCurve curve(method, std::move(plan));
  while (!curve.advance(kSamples)) {
  }
  Array<Array<CurveSample>> segments;
  for (int j = 0; j < curve.segmentCount(); ++j) segments.push_back(curve.samples(j));
  return accuracyOfFound(example, segments);
}

std::string row(const AccuracyFamily& family, int triangles, const FieldMethod& method,
                const Accuracy& m, const Accuracy* coarser) {
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
  for (const AccuracyFamily& family : accuracyFamilies()) {
    Array<Series> series;
    for (const FieldMethod& method : kMethods) series.push_back({method.name, {}, {}});
    Accuracy coarser[std::size(kMethods)];
    for (int size = 0; size < 3; ++size) {
      const int triangles = static_cast<int>(scale * 2000 * std::pow(3.2, size));
      AccuracyCase example(family, triangles);
      const TriangleMesh& mesh = example.surface.mesh();
      for (int i = 0; i < static_cast<int>(std::size(kMethods)); ++i) {
        const Accuracy m = kMethods[i].byAuthors
                               ? measureByAuthors(example, kMethods[i].options)
                               : measureAccuracy(example, kMethods[i].options, kMethods[i].levels);
        const std::string line =
            row(family, mesh.faceCount(), kMethods[i], m, size > 0 ? &coarser[i] : nullptr);
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

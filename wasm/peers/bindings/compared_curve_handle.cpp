#include "peers/bindings/compared_curve_handle.h"

#include <emscripten/emscripten.h>

#include <utility>

#include "bindings/field_options.h"
#include "bindings/view.h"
#include "curves/spec/bases.h"
#include "mesh/error.h"

namespace karcher::bindings {
namespace {

ComparedMethod comparedMethod(const std::string& name) {
  if (name == "vectorHeat") return ComparedMethod::kVectorHeat;
  if (name == "affineHeat") return ComparedMethod::kAffineHeat;
  if (name == "weightedAverages") return ComparedMethod::kWeightedAverages;
  if (name == "descent") return ComparedMethod::kDescent;
  return ComparedMethod::kFields;
}

/// The basis with this name. Throws Error kBadArgument.
Basis basisOf(const std::string& name, const Array<double>& parameters) {
  if (name == "bspline") return uniformCubicBasis;
  for (const double parameter : parameters) {
    if (parameter > 0 && parameter < kInfinity) continue;
    throw Error(ErrorCode::kBadArgument, "the parameters of a basis must be positive and finite");
  }
  if (parameters.empty()) {
    throw Error(ErrorCode::kBadArgument, "the basis '" + name + "' needs parameters");
  }
  const int degree = parameters.count() - 1;
  if (name == "bezier") {
    return [n = static_cast<int>(parameters[0])](double t) { return bernsteinBasis(n, t); };
  }
  if (name == "rational") {
    return [=](double t) { return rationalBasis(bernsteinBasis(degree, t), parameters); };
  }
  if (name == "barycentric") {
    return [=](double t) { return barycentricBasis(parameters, t); };
  }
  throw Error(ErrorCode::kBadArgument, "there is no basis '" + name + "'");
}

}  // namespace

void ComparedCurveHandle::movePoint(int i, const val& point) {
  curve_.movePoint(i, pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
}

void ComparedCurveHandle::startAt(const val& point) {
  curve_.startAt(pointFromJs(mesh_.numbering(), mesh_.mesh(), point));
}

val ComparedCurveHandle::logMaps() const {
  if (curve_.logMaps() == nullptr) return val::null();
  val result = val::object();
  result.set("made", curve_.logMaps()->logMapCount());
  result.set("asked", static_cast<double>(curve_.logMaps()->logMapsAsked()));
  result.set("ms", curve_.logMaps()->logMapMilliseconds());
  return result;
}

val ComparedCurveHandle::samples() const {
  TracedLine line;
  for (int j = 0; j < curve_.segmentCount(); ++j) line.samples.push_back(&curve_.samples(j));
  return viewToJs(mesh_, line, {});
}

val ComparedCurveHandle::joined() const {
  TracedLine line;
  Array<JoinedPath> paths;
  for (int j = 0; j < curve_.segmentCount(); ++j) {
    if (curve_.samples(j).empty()) continue;
    paths.push_back(joinSamples(mesh_.surface(), curve_.samples(j)));
  }
  for (const JoinedPath& path : paths) line.paths.push_back(&path);
  return viewToJs(mesh_, line, {.inDouble = true, .withPoints = true});
}

std::unique_ptr<PreparedMethodHandle> prepareMethod(MeshHandle& mesh, const val& options,
                                                    const val& progress) {
  ComparedOptions result;
  result.method = comparedMethod(options["method"].as<std::string>());
  result.field = fieldOptionsFromJs(options["field"]);
  if (options["seeds"].as<std::string>() == "authors") result.seeds = Seeds::kAuthors;
  result.delaunay = options["delaunay"].as<bool>();
  result.variant =
      options["adaptive"].as<bool>() ? AffineVariant::kAdaptive : AffineVariant::kLocal;
  result.embedding.landmarks = options["landmarks"].as<int>();
  result.landmarkDistances =
      options["landmarkDistances"].as<std::string>() == "exact" ? Solver::kExact : Solver::kFast;
  result.clock = emscripten_get_now;
  if (!progress.isUndefined()) {
    result.progress = [&progress](int landmarks) {
      if (progress(landmarks).as<bool>()) return;
      throw Error(ErrorCode::kNoEmbedding,
                  "the embedding was given up after " + std::to_string(landmarks) + " landmarks");
    };
  }
  return std::make_unique<PreparedMethodHandle>(mesh, result);
}

std::unique_ptr<ComparedCurveHandle> comparedCurve(PreparedMethodHandle& method, const val& points,
                                                   const val& first, const val& t,
                                                   const val& weights) {
  const MeshHandle& mesh = method.mesh();
  ComparedPlan plan;
  plan.points = pointsFromJs(mesh.numbering(), mesh.mesh(), points);
  plan.first = fromJs<int>(first);
  plan.table.t = fromJs<double>(t);
  plan.table.weights = fromJs<double>(weights);
  const int rows = plan.table.t.count();
  if (rows == 0 || plan.table.weights.count() % rows != 0) {
    throw Error(ErrorCode::kBadWeights, std::to_string(plan.table.weights.count()) +
                                            " weights are no table of " + std::to_string(rows) +
                                            " rows");
  }
  plan.table.points = plan.table.weights.count() / rows;
  return std::make_unique<ComparedCurveHandle>(method, std::move(plan));
}

val basisWeights(const std::string& name, const val& parameters, int samples) {
  constexpr int kMostSamples = 100'000;
  if (samples < 2 || samples > kMostSamples) {
    throw Error(ErrorCode::kBadArgument, "a segment takes 2 to " + std::to_string(kMostSamples) +
                                             " samples, not " + std::to_string(samples));
  }
  const WeightTable table = tabulate(basisOf(name, fromJs<double>(parameters)), samples);
  val result = val::object();
  result.set("points", table.points);
  result.set("t", toJs(table.t));
  result.set("weights", toJs(table.weights));
  return result;
}

}  // namespace karcher::bindings

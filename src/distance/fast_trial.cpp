#include "distance/fast_trial.h"

#include <algorithm>

#include "distance/exact_distance.h"
#include "distance/fast_distance.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// Sources at the worst places, and anywhere; vertices that are looked at from each. Some errors
/// grow with the distance.
constexpr int kWorstPlaces = 4;
constexpr int kNearVertices = 300;
constexpr int kOtherPlaces = 4;
constexpr int kFarVertices = 1200;

/// Thinner faces leave too few digits of a triangle to a solver that goes by its corners.
constexpr double kThinnest = 1e-6;

constexpr float kBad = 3;

struct Places {
  Array<int> worst;  ///< vertices, the worst first
  double thinnest = 1;
  int bad = 0;  ///< vertices worse than kBad
};

/// A virtual source is off by the angle defect that paths to it enclose, and thin faces carry that
/// far along their sides: the defect times the face's thinness says how bad a vertex is. On regular
/// triangles of a sphere that is some hundredths, at the corner of a cube 3.
Places findPlaces(const Geometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  Places places;
  Array<float> score(mesh.positions.size(), 0);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, geometry.edgeLength[3 * f + k]);
    const double area = doubleArea(geometry, f);
    const double thinness = longest * longest / area;
    places.thinnest = std::min(places.thinnest, area / (longest * longest));
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.corner(f, k);
      if (mesh.onBoundary[v]) continue;
      const double defect = std::abs(2 * kPi - geometry.totalAngle[v]);
      score[v] = std::max(score[v], static_cast<float>(thinness * defect));
    }
  }
  for (const float value : score) places.bad += value > kBad ? 1 : 0;
  // One in each stretch of numbers, which lie near each other, so that not all are at one place.
  const int parts = std::min(mesh.vertexCount(), 16 * kWorstPlaces);
  for (int part = 0; part < parts; ++part) {
    const auto place = [&](int i) {
      return static_cast<int>(static_cast<int64_t>(mesh.vertexCount()) * i / parts);
    };
    const auto worst =
        std::max_element(score.begin() + place(part), score.begin() + place(part + 1));
    places.worst.push_back(static_cast<int>(worst - score.begin()));
  }
  sortNumbers(places.worst, [&](int v, int w) { return score[v] > score[w]; });
  return places;
}

/// Grows until so many vertices, or all, were met; returns the radius.
double growToCount(FastDistance& solver, const Geometry& geometry, int count) {
  constexpr double kStep = 1.2;
  double radius = geometry.meanEdge;
  for (;;) {
    solver.grow(radius);
    int met = 0;
    solver.forEachMet([&](int v) { met += solver.distance(v) <= radius ? 1 : 0; });
    if (met >= count || solver.reached() == kInfinity) return radius;
    radius *= kStep;
  }
}

}  // namespace

bool FastTrial::isPassed() const {
  // What the meshes of the gallery (tests/generators) on which the fast solver is off by more than
  // kWrong go beyond, and scans and models do not.
  constexpr double kMostBad = 4e-3;
  constexpr double kMostMean = 2e-3;
  constexpr double kMostWrong = 2e-3;
  return thinnest >= kThinnest && bad <= kMostBad && meanError <= kMostMean &&
         wrong <= kMostWrong * pairs;
}

FastTrial tryFastDistance(const Geometry& geometry, const std::shared_ptr<const VertexFans>& fans) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Places places = findPlaces(geometry);
  FastTrial trial;
  trial.thinnest = places.thinnest;
  trial.bad = places.bad / static_cast<double>(mesh.vertexCount());
  if (!trial.isPassed()) return trial;

  Array<int> sources(places.worst.begin(),
                     places.worst.begin() + std::min(kWorstPlaces, places.worst.count()));
  for (int i = 0; i < kOtherPlaces; ++i) {
    sources.push_back(static_cast<int>(static_cast<int64_t>(mesh.vertexCount()) * (2 * i + 1) /
                                       (2 * kOtherPlaces)));
  }
  FastDistance fast(geometry, fans);
  ExactDistance exact(geometry);
  double sum = 0;
  for (int i = 0; i < sources.count(); ++i) {
    const int source = sources[i];
    fast.setSource(vertexPoint(mesh, source));
    const double radius =
        growToCount(fast, geometry, i < kWorstPlaces ? kNearVertices : kFarVertices);
    exact.setSource(vertexPoint(mesh, source));
    exact.grow(radius);
    int pairs = 0;
    int wrong = 0;
    exact.forEachMet([&](int v) {
      const double truth = exact.distance(v);
      if (v == source || truth > exact.reached() || truth > radius) return;
      const double error = std::abs(fast.growTo(v) / truth - 1);
      sum += error;
      trial.worstError = std::max(trial.worstError, error);
      wrong += error > FastTrial::kWrong ? 1 : 0;
      ++pairs;
    });
    trial.pairs += pairs;
    trial.wrong += wrong;
  }
  if (trial.pairs > 0) trial.meanError = sum / trial.pairs;
  return trial;
}

}  // namespace karcher

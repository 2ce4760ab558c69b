#include "distance/fast_trial.h"

#include <algorithm>

#include "distance/exact_distance.h"
#include "distance/fast_distance.h"
#include "mesh/positions.h"

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

constexpr double kBad = 3;

/// The worst places lie at least this part of the mesh's extent apart.
constexpr double kApart = 0.1;

struct Badness {
  Array<double> ofVertex;
  double thinnest = 1;
  int bad = 0;  ///< vertices worse than kBad
};

/// A virtual source is off by the angle defect that paths to it enclose, and thin faces carry that
/// far along their sides: the defect times the face's thinness says how bad a vertex is. On regular
/// triangles of a sphere that is some hundredths, at the corner of a cube 3.
Badness findBadness(const Geometry& geometry) {
  const TriangleMesh& mesh = *geometry.mesh;
  Badness badness;
  badness.ofVertex.assign(mesh.positions.size(), 0);
  for (int f = 0; f < mesh.faceCount(); ++f) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) longest = std::max(longest, geometry.edgeLength[3 * f + k]);
    const double area = doubleArea(geometry, f);
    const double thinness = longest * longest / area;
    badness.thinnest = std::min(badness.thinnest, area / (longest * longest));
    for (int k = 0; k < 3; ++k) {
      const int v = mesh.corner(f, k);
      if (mesh.onBoundary[v]) continue;
      const double defect = std::abs(2 * kPi - geometry.totalAngle[v]);
      badness.ofVertex[v] = std::max(badness.ofVertex[v], thinness * defect);
    }
  }
  for (const double value : badness.ofVertex) badness.bad += value > kBad ? 1 : 0;
  return badness;
}

/// The sources: the worst vertices that lie apart, and others at even distances in space from the
/// worst one. So they depend on the shape alone, not on how it lies or is numbered; of vertices
/// that are equally bad they are those that lie farthest from the middle, and only of these the
/// first.
Array<int> findSources(const Geometry& geometry, const Badness& badness) {
  const Array<Vec3>& positions = geometry.mesh->positions;
  const int count = positions.count();
  Array<int> sources;
  const auto distance = [&](int v, int source) {
    return (positions[v] - positions[source]).norm();
  };
  const Vec3 middle = middleOf(positions);
  const auto isWorse = [&](int v, int w) {
    // By more than rounding.
    constexpr double kMore = 1 + 1e-9;
    const double a = badness.ofVertex[v];
    const double b = badness.ofVertex[w];
    if (a > kMore * b || b > kMore * a) return a > b;
    return (positions[v] - middle).norm() > kMore * (positions[w] - middle).norm();
  };
  for (int i = 0; i < kWorstPlaces; ++i) {
    int worst = -1;
    for (int v = 0; v < count; ++v) {
      if (worst >= 0 && !isWorse(v, worst)) continue;
      const auto isNear = [&](int s) { return distance(v, s) < kApart * geometry.extent; };
      if (std::none_of(sources.begin(), sources.end(), isNear)) worst = v;
    }
    if (worst >= 0) sources.push_back(worst);
  }
  double farthest = 0;
  for (int v = 0; v < count; ++v) farthest = std::max(farthest, distance(v, sources[0]));
  for (int i = 0; i < kOtherPlaces; ++i) {
    const double at = farthest * (2 * i + 1) / (2 * kOtherPlaces);
    const auto off = [&](int v) { return std::abs(distance(v, sources[0]) - at); };
    int nearest = 0;
    for (int v = 1; v < count; ++v) {
      if (off(v) < off(nearest)) nearest = v;
    }
    sources.push_back(nearest);
  }
  return sources;
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
  if (thinnest < kThinnest || bad > kMostBad) return false;
  // Where no pair is off by more all is well; elsewhere a few may be, if most are nearly exact.
  constexpr double kSure = 0.01;
  constexpr double kMostMean = 1e-3;
  constexpr double kMostWrong = 1e-3;
  return worstError <= kSure || (meanError <= kMostMean && wrong <= kMostWrong * pairs);
}

FastTrial tryFastDistance(const Geometry& geometry, const std::shared_ptr<const VertexFans>& fans) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Badness badness = findBadness(geometry);
  FastTrial trial;
  trial.thinnest = badness.thinnest;
  trial.bad = badness.bad / static_cast<double>(mesh.vertexCount());
  if (!trial.isPassed()) return trial;

  const Array<int> sources = findSources(geometry, badness);
  FastDistance fast(geometry, fans);
  ExactDistance exact(geometry);
  double sum = 0;
  for (int i = 0; i < sources.count(); ++i) {
    const int source = sources[i];
    fast.setSource(vertexPoint(mesh, source));
    const double radius = growToCount(
        fast, geometry, sources.count() - i > kOtherPlaces ? kNearVertices : kFarVertices);
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

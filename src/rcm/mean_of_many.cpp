#include "rcm/mean_of_many.h"

#include <algorithm>

#include "distance/edge_dijkstra.h"
#include "intrinsic/straightest.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"
#include "rcm/one_source_energy.h"

namespace karcher {
namespace {

/// The number of starts at which the search compares K, and the number of descents from them.
constexpr int kStarts = 16;
constexpr int kDescents = 3;
constexpr int kMostSolves = 24;        ///< the largest number of solves in one descent
constexpr double kLongestStep = 0.25;  ///< the longest step, relative to the mesh's extent

/// A descent ends before a step shorter than this, in mean edges, since the gradient is not
/// accurate enough for shorter steps.
constexpr double kLastStep = 0.1;
/// Another descent stops at this distance, in mean edges, from the lowest end so far, since it
/// would also end there.
constexpr double kSameDescent = 2;

/// A symmetric matrix that turns the natural step into the estimated Newton step.
struct Scale {
  double xx = 1;
  double xy = 0;
  double yy = 1;

  Vec2 operator*(const Vec2& v) const { return {xx * v.x() + xy * v.y(), xy * v.x() + yy * v.y()}; }

  /// The same matrix in the frame whose x axis is `direction`.
  Scale turned(const Vec2& direction) const {
    const Vec2 x = rotate(direction, *this * rotateBack(direction, Vec2(1, 0)));
    const Vec2 y = rotate(direction, *this * rotateBack(direction, Vec2(0, 1)));
    return {x.x(), x.y(), y.y()};
  }

  /// The BFGS update. `change` is the change of the natural step over the given length along the x
  /// axis.
  void learn(double length, const Vec2& change) {
    constexpr double kLeastCurvature = 0.02;
    if (!(change.x() > kLeastCurvature * length)) return;
    const double slope = -change.y() / change.x();
    xx = yy * square(slope) + length / change.x();
    xy = yy * slope;
  }
};

/// A place on a descent, with the values there.
struct State {
  SurfacePoint place;
  EnergyAt here;
  Scale scale;

  Vec2 step() const { return scale * here.step; }
};

enum class Ended {
  kAtMinimum,  ///< the next step is shorter than the accuracy of the gradient
  kStuck,      ///< the descent found no lower K within the accuracy of the gradient
  kAtBoundary,
  kKnown,  ///< the descent came near the lowest end of earlier descents
};

struct Descent {
  State end;
  Ended ended = Ended::kStuck;
};

/// Descends from a place. `energyAt` returns K and the natural step at a place, or nothing if the
/// descent may stop there.
template <class EnergyFunction>
Descent descend(const Geometry& geometry, State state, const EnergyFunction& energyAt) {
  double most = kLongestStep * geometry.extent;
  int crossingsLeft = mostCrossingsOfSearch(*geometry.mesh);
  for (int solve = 0; solve < kMostSolves && crossingsLeft > 0; ++solve) {
    Vec2 step = state.step();
    const double wanted = step.norm();
    if (wanted <= kLastStep * geometry.meanEdge) return {state, Ended::kAtMinimum};
    step *= std::min(1.0, most / wanted);
    const StraightestPath path =
        traceStraightest(geometry, state.place, step, {.maxCrossings = crossingsLeft});
    crossingsLeft -= path.path.points.count() / 2;
    const double length = step.norm() - path.remaining;
    if (path.stop == TraceStop::kBoundary && length < kLastStep * geometry.meanEdge) {
      return {state, Ended::kAtBoundary};
    }
    const Vec2 before = step / step.norm();
    const std::optional<EnergyAt> there = energyAt(path.path.end());
    if (!there) return {state, Ended::kKnown};
    // Both steps are in the frame of the path.
    const Vec2 change =
        rotateBack(before, state.here.step) - rotateBack(path.direction, there->step);
    Scale scale = state.scale.turned(Vec2(before.x(), -before.y()));
    scale.learn(length, change);
    if (there->energy < state.here.energy) {
      state = {path.path.end(), *there, scale.turned(path.direction)};
      most = std::min(2 * std::max(most, length), kLongestStep * geometry.extent);
    } else {
      state.scale = scale.turned(before);
      most = length / 2;
      if (most <= kLastStep * geometry.meanEdge) break;
    }
  }
  return {state, Ended::kStuck};
}

/// The starts: the weights are summed in the order of the points, and the sum is divided into
/// `count` equal steps. The point at the middle of each step is a start. Points near in this order
/// are near in space, so that the starts are spread over all points.
Array<SurfacePoint> startsOf(const WeightedPoints& points, int count) {
  Array<SurfacePoint> starts;
  double sum = 0;
  int part = 0;
  for (int i = 0; i < points.points.count() && part < count; ++i) {
    sum += points.weights[i];
    bool isReached = false;
    for (; part < count && sum * count >= part + 0.5; ++part) isReached = true;
    if (isReached) starts.push_back(points.points[i]);
  }
  return starts;
}

/// The vertex of a point's face that is nearest to it.
int nearestCorner(const TriangleMesh& mesh, const SurfacePoint& point) {
  int corner = 0;
  point.bary.maxCoeff(&corner);
  return mesh.corner(point.face, corner);
}

/// The starts with the lowest K by distances along edges. Such distances take a quarter of the
/// solver's time, and are all too long by nearly the same factor. K by straight lines in space is a
/// lower bound; if a start's bound exceeds the kDescents lowest values found so far, the search
/// skips the start.
Array<SurfacePoint> lowestStarts(const Geometry& geometry, const WeightedPoints& points) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Array<SurfacePoint> starts = startsOf(points, kStarts);
  const auto energyBy = [&](const auto& distanceTo) {
    double energy = 0;
    for (int i = 0; i < points.points.count(); ++i) {
      energy += points.weights[i] * square(distanceTo(nearestCorner(mesh, points.points[i])));
    }
    return energy;
  };
  Array<double> bounds;
  for (const SurfacePoint& start : starts) {
    const Vec3& from = mesh.positions[nearestCorner(mesh, start)];
    bounds.push_back(energyBy([&](int v) { return (mesh.positions[v] - from).norm(); }));
  }
  const size_t wanted = std::min(starts.size(), static_cast<size_t>(kDescents));
  Array<double> energies(starts.size(), kInfinity);
  Array<double> lowest(wanted, kInfinity);  // in ascending order
  for (const int i :
       sortedNumbers(starts.count(), [&](int a, int b) { return bounds[a] < bounds[b]; })) {
    if (bounds[i] * (1 - kLocalRounding) > lowest.back()) break;
    const Array<double> distances = edgeDijkstra(geometry, nearestCorner(mesh, starts[i]));
    energies[i] = energyBy([&](int v) { return distances[v]; });
    lowest.back() = std::min(lowest.back(), energies[i]);
    std::sort(lowest.begin(), lowest.end());
  }
  Array<SurfacePoint> chosen;
  while (chosen.size() < wanted) {
    const auto least = std::min_element(energies.begin(), energies.end());
    chosen.push_back(starts[least - energies.begin()]);
    *least = kInfinity;
  }
  return chosen;
}

}  // namespace

bool isOfMany(const Array<SurfacePoint>& points, const Array<double>& weights,
              const MeanOptions& options) {
  return points.count() >= kMany && areCheckable(options.field) && !options.looksForOthers &&
         std::all_of(weights.begin(), weights.end(), [](double weight) { return weight >= 0; }) &&
         mergedPoints(points, weights).points.count() >= kMany;
}

std::optional<Mean> meanOfMany(Surface& surface, const WeightedPoints& points,
                               const MeanOptions& options) {
  const Geometry& geometry = surface.geometry();
  const std::unique_ptr<DistanceSolver> solver = makeDistanceSolver(surface, options.field);
  OneSourceEnergy energy(geometry, points, *solver);
  const Array<SurfacePoint> starts =
      options.start ? Array<SurfacePoint>{*options.start} : lowestStarts(geometry, points);
  State best;
  best.here.energy = kInfinity;
  Ended ended = Ended::kAtMinimum;
  for (int k = 0; k < starts.count(); ++k) {
    const Vec3 known = position(surface.mesh(), best.place);
    const State start{starts[k], energy.at(starts[k]), {}};
    const Descent descent = descend(geometry, start, [&](const SurfacePoint& place) {
      const bool isKnown = k > 0 && (position(surface.mesh(), place) - known).norm() <=
                                        kSameDescent * geometry.meanEdge;
      return isKnown ? std::nullopt : std::optional<EnergyAt>(energy.at(place));
    });
    if (descent.ended == Ended::kKnown || descent.end.here.energy >= best.here.energy) continue;
    best = descent.end;
    ended = descent.ended;
  }
  if (ended == Ended::kAtBoundary) return std::nullopt;
  Mean mean;
  mean.iterations = energy.solved();
  mean.energy = best.here.energy;
  mean.point = best.place;
  const Vec2 last = best.step();
  if (ended == Ended::kAtMinimum && last != Vec2::Zero()) {
    mean.energy -= best.here.step.dot(last);
    mean.point = traceStraightest(geometry, best.place, last,
                                  {.maxCrossings = mostCrossingsOfSearch(*geometry.mesh)})
                     .path.end();
  }
  return mean;
}

}  // namespace karcher

#include "rcm/mean_of_many.h"

#include <algorithm>

#include "distance/edge_dijkstra.h"
#include "intrinsic/straightest.h"
#include "mesh/sorted_numbers.h"
#include "rcm/energy_ring.h"
#include "rcm/one_source_energy.h"

namespace karcher {
namespace {

/// Points at which K is compared first, and those of them from which descents begin.
constexpr int kStarts = 16;
constexpr int kDescents = 3;
constexpr int kMostSolves = 24;        ///< of one descent
constexpr double kLongestStep = 0.25;  ///< of the mesh's extent

/// A step below this part of a mean edge is the last of a descent. The gradient is no better.
constexpr double kLastStep = 0.1;
/// A descent that comes so near to where another one ended, in mean edges, would end there too.
constexpr double kSameDescent = 2;

/// Of the first step by exact distances, in mean edges: a shorter one is not worth its solve, and a
/// longer one is by more than the fast solver's error.
constexpr double kLeastStep = 0.02;
constexpr double kLongestExactStep = 1;
/// A center is moved where K is lower by this part of a square mean edge, as with few points.
constexpr double kGain = kLowerBy / 4;
/// So many creases make K smooth: as few places of a circle tell what it is like there as foretell
/// those between them.
constexpr int kSmooth = 500;
constexpr int kOnCircle = 12;
constexpr int kOnRoughCircle = 16;
/// Where a point of the circle is higher than the center by no more square mean edges, more points
/// beside it are compared: creases make narrow grooves.
constexpr double kNearBound = 0.02;
/// Where K is less curved on the circle, by the energy of a point of the circle over that of its
/// center in square mean edges, a way is as long as if it were curved so. On a plane it is 0.09.
constexpr double kLeastBowl = 0.04;
/// Most centers are moved once; more often where K is all creases.
constexpr int kMostMoves = 12;

/// A symmetric matrix: of the natural step it makes the Newton step, as far as is known.
struct Scale {
  double xx = 1;
  double xy = 0;
  double yy = 1;

  Vec2 operator*(const Vec2& v) const { return {xx * v.x() + xy * v.y(), xy * v.x() + yy * v.y()}; }

  /// The same where the frame's x axis was `direction`.
  Scale turned(const Vec2& direction) const {
    const Vec2 x = rotate(direction, *this * rotateBack(direction, Vec2(1, 0)));
    const Vec2 y = rotate(direction, *this * rotateBack(direction, Vec2(0, 1)));
    return {x.x(), x.y(), y.y()};
  }

  /// BFGS: learns from the change of the natural step over a length along the x axis.
  void learn(double length, const Vec2& change) {
    constexpr double kLeastCurvature = 0.02;
    if (!(change.x() > kLeastCurvature * length)) return;
    const double slope = -change.y() / change.x();
    xx = yy * square(slope) + length / change.x();
    xy = yy * slope;
  }
};

/// Where a descent stands.
struct Stand {
  SurfacePoint place;
  EnergyAt here;
  Scale scale;

  Vec2 step() const { return scale * here.step; }
};

enum class Ended {
  kThere,
  kStuck,  ///< K is higher all around, as far as the gradient tells
  kBoundary,
  kKnown,  ///< where another descent ended
};

struct Descent {
  Stand stand;
  Ended ended = Ended::kStuck;
};

/// Goes down from a place. `energyAt` gives K and the natural step, or none where the descent may
/// as well end.
template <class EnergyFunction>
Descent descend(const Geometry& geometry, Stand stand, const EnergyFunction& energyAt) {
  double most = kLongestStep * geometry.extent;
  int crossingsLeft = mostCrossingsOfSearch(*geometry.mesh);
  for (int solve = 0; solve < kMostSolves && crossingsLeft > 0; ++solve) {
    Vec2 step = stand.step();
    const double wanted = step.norm();
    if (wanted <= kLastStep * geometry.meanEdge) return {stand, Ended::kThere};
    step *= std::min(1.0, most / wanted);
    const StraightestPath path =
        traceStraightest(geometry, stand.place, step, {.maxCrossings = crossingsLeft});
    crossingsLeft -= path.path.points.count() / 2;
    const double length = step.norm() - path.remaining;
    if (path.stop == TraceStop::kBoundary && length < kLastStep * geometry.meanEdge) {
      return {stand, Ended::kBoundary};
    }
    const Vec2 before = step / step.norm();
    const std::optional<EnergyAt> there = energyAt(path.path.end());
    if (!there) return {stand, Ended::kKnown};
    // Both in the frame of the way.
    const Vec2 change =
        rotateBack(before, stand.here.step) - rotateBack(path.direction, there->step);
    Scale scale = stand.scale.turned(Vec2(before.x(), -before.y()));
    scale.learn(length, change);
    if (there->energy < stand.here.energy) {
      stand = {path.path.end(), *there, scale.turned(path.direction)};
      most = std::min(2 * std::max(most, length), kLongestStep * geometry.extent);
    } else {
      stand.scale = scale.turned(before);
      constexpr double kShorter = 0.5;
      most = kShorter * length;
      if (most <= kLastStep * geometry.meanEdge) break;
    }
  }
  return {stand, Ended::kStuck};
}

/// The points where equal parts of the weight are reached, in the points' order, which is one of
/// places near each other.
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

/// The starts of the lowest K, by distances along edges: these take a quarter of the time, and are
/// all too long by much the same part. Where K by straight lines in space, which are shorter, is
/// above the lowest found so far, they are not looked for.
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
  Array<double> lowest(wanted, kInfinity);  // ascending
  for (const int i :
       sortedNumbers(starts.count(), [&](int a, int b) { return bounds[a] < bounds[b]; })) {
    constexpr double kRounding = 1e-12;
    if (bounds[i] * (1 - kRounding) > lowest.back()) break;
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

StraightestPath walk(const Geometry& geometry, const SurfacePoint& from, const Vec2& way) {
  return traceStraightest(geometry, from, way,
                          {.maxCrossings = mostCrossingsOfSearch(*geometry.mesh)});
}

Mean meanAt(const SurfacePoint& place, double energy, int solves) {
  return {place, Status::kConverged, solves, energy, Uniqueness::kNotLooked, {}};
}

/// A minimum by the solver's distances, and the scale of steps there.
struct RoughMean {
  Mean mean;
  Scale scale;
};

/// None where descents end at a boundary.
std::optional<RoughMean> roughMean(Surface& surface, const WeightedPoints& points,
                                   const MeanOptions& options) {
  const Geometry& geometry = surface.geometry();
  const std::unique_ptr<DistanceSolver> solver = makeDistanceSolver(surface, options.field);
  OneSourceEnergy energy(geometry, points, *solver);
  const Array<SurfacePoint> starts =
      options.start ? Array<SurfacePoint>{*options.start} : lowestStarts(geometry, points);
  Stand best;
  best.here.energy = kInfinity;
  Ended ended = Ended::kThere;
  for (int k = 0; k < starts.count(); ++k) {
    const Vec3 known = position(surface.mesh(), best.place);
    const Stand start{starts[k], energy.at(starts[k]), {}};
    const Descent descent = descend(geometry, start, [&](const SurfacePoint& place) {
      const bool isKnown = k > 0 && (position(surface.mesh(), place) - known).norm() <=
                                        kSameDescent * geometry.meanEdge;
      return isKnown ? std::nullopt : std::optional<EnergyAt>(energy.at(place));
    });
    if (descent.ended == Ended::kKnown || descent.stand.here.energy >= best.here.energy) continue;
    best = descent.stand;
    ended = descent.ended;
  }
  if (ended == Ended::kBoundary) return std::nullopt;
  const double energyThere = best.here.energy;
  if (ended != Ended::kThere || best.step() == Vec2::Zero()) {
    return RoughMean{meanAt(best.place, energyThere, energy.solved()), best.scale};
  }
  const Vec2 last = best.step();
  const StraightestPath way = walk(geometry, best.place, last);
  const Vec2 direction = last.normalized();
  const Scale scale = best.scale.turned(Vec2(direction.x(), -direction.y())).turned(way.direction);
  return RoughMean{meanAt(way.path.end(), energyThere - best.here.step.dot(last), energy.solved()),
                   scale};
}

/// A minimum by exact distances near a rough one.
Mean heldToExact(const Geometry& geometry, const WeightedPoints& points, const RoughMean& rough) {
  const double radius = kCheckedRadius * geometry.meanEdge;
  const double squareEdge = square(geometry.meanEdge);
  ExactOneSourceEnergy exact(geometry, points);
  const bool isSmooth = points.points.count() >= kSmooth;
  const int count = isSmooth ? kOnCircle : kOnRoughCircle;
  // The lowest place so far.
  SurfacePoint place = rough.mean.point;
  const EnergyAt here = exact.at(place);
  double energy = here.energy;
  // A step by the exact gradient spares a circle about the wrong place.
  const Vec2 step = rough.scale * here.step;
  if (step.norm() > kLeastStep * geometry.meanEdge) {
    const double part = std::min(1.0, kLongestExactStep * geometry.meanEdge / step.norm());
    const SurfacePoint there = walk(geometry, place, part * step).path.end();
    const double thereEnergy = exact.at(there).energy;
    if (thereEnergy < energy) {
      place = there;
      energy = thereEnergy;
    }
  }
  for (int move = 0;; ++move) {
    EnergyRing ring(geometry, place, energy, count, exact);
    const double bound = energy - kLowerBy * squareEdge;
    const double nearBound = energy + kNearBound * squareEdge;
    SurfacePoint lower;
    double lowerEnergy = kInfinity;
    bool isLowest = false;
    const auto compare = [&](const Vec2& to) {
      const SurfacePoint there = walk(geometry, place, to).path.end();
      const double thereEnergy = exact.at(there).energy;
      if (!(thereEnergy < lowerEnergy)) return;
      lower = there;
      lowerEnergy = thereEnergy;
    };
    for (;;) {
      const auto margin = [&] { return std::min(ring.least(), ring.value(ring.lowest())) - bound; };
      while (!ring.isRefined() && margin() >= 0 && !(isSmooth && ring.error() <= margin())) {
        ring.refine();
      }
      const int lowest = ring.lowest();
      if (!isSmooth && ring.isRefined() && ring.value(lowest) < nearBound) ring.lookBesideLowest();
      isLowest = margin() >= 0;
      if (ring.value(lowest) < lowerEnergy) {
        lower = ring.place(lowest);
        lowerEnergy = ring.value(lowest);
      }
      // Where K is smooth the circle round a minimum of the quadratic within this one is higher
      // than it, too.
      const Vec2 way = ring.wayToMinimum(kLeastBowl * squareEdge);
      const bool isNear = way.norm() <= radius;
      if (!isLowest || (isNear && ring.gainOf(way) > kGain * squareEdge)) compare(way);
      // What the polynomial promises may not be there.
      if (lowerEnergy >= bound && ring.least() < nearBound)
        compare(radius * ring.lowestDirection());
      if (isLowest || ring.isRefined() || lowerEnergy < bound) break;
      ring.refine();
    }
    const bool isMinimum = isLowest || lowerEnergy >= bound;
    const bool isLast = move == kMostMoves;
    const double gain = energy - lowerEnergy;
    // Where K is not smooth what is moved is compared anew, and a minimum stays in the end.
    const bool isDone = isMinimum && (isSmooth || isLast || gain <= kGain * squareEdge);
    const bool isMoved = gain > 0 && (isSmooth || !isDone);
    if (isMoved) {
      place = lower;
      energy = lowerEnergy;
    }
    Mean mean = meanAt(place, energy, rough.mean.iterations + exact.solved());
    if (isDone) return mean;
    if (!isLast) continue;
    mean.status = Status::kLowerNearby;
    return mean;
  }
}

}  // namespace

bool isOfMany(const Array<SurfacePoint>& points, const Array<double>& weights,
              const MeanOptions& options) {
  return points.count() >= kMany && areHeldToExact(options.field) && !options.looksForOthers &&
         std::all_of(weights.begin(), weights.end(), [](double weight) { return weight >= 0; }) &&
         mergedPoints(points, weights).points.count() >= kMany;
}

std::optional<Mean> meanOfMany(Surface& surface, const Array<SurfacePoint>& points,
                               const Array<double>& weights, const MeanOptions& options) {
  const WeightedPoints merged = mergedPoints(points, weights);
  const std::optional<RoughMean> rough = roughMean(surface, merged, options);
  if (!rough) return std::nullopt;
  if (!options.isChecked) return rough->mean;
  return heldToExact(surface.geometry(), merged, *rough);
}

}  // namespace karcher

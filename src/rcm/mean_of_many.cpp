#include "rcm/mean_of_many.h"

#include <algorithm>

#include "intrinsic/straightest.h"
#include "rcm/exact_minimum.h"

namespace karcher {
namespace {

using Matrix2 = Eigen::Matrix2d;

/// Points at which K is compared first.
constexpr int kStarts = 16;
constexpr int kMostSolves = 24;  ///< of one descent
constexpr double kLongestStep = 0.25;  ///< of the bounding box's diagonal
/// Steps below these parts of a mean edge end a descent, and are the last.
constexpr double kLastStep = 1e-2;
/// By the solver's distances, whose error moves the zero by some such part.
constexpr double kLastRoughStep = 0.1;

/// Where a descent stands.
struct Stand {
  SurfacePoint place;
  EnergyAt here;
  /// Of the natural step the matrix makes the Newton step, as far as is known.
  Matrix2 scale = Matrix2::Identity();

  Vec2 step() const { return scale * here.step; }
};

Matrix2 rotation(const Vec2& direction) {
  Matrix2 matrix;
  matrix << direction.x(), -direction.y(), direction.y(), direction.x();
  return matrix;
}

/// BFGS: what the change of the natural step along a way tells.
void learn(Matrix2& scale, const Vec2& way, const Vec2& change) {
  const double along = way.dot(change);
  constexpr double kLeastCurvature = 0.02;
  if (!(along > kLeastCurvature * way.squaredNorm())) return;
  const Matrix2 rest = Matrix2::Identity() - way * change.transpose() / along;
  scale = rest * scale * rest.transpose() + way * way.transpose() / along;
}

enum class Ended { kThere, kStuck, kBoundary };

struct Descent {
  Stand stand;
  Ended ended = Ended::kStuck;
};

/// Goes down from a place. `energyAt` gives K and the natural step.
template <class EnergyFunction>
Descent descend(const Geometry& geometry, Stand stand, double lastStep,
                const EnergyFunction& energyAt) {
  double most = kLongestStep * geometry.diagonal;
  int crossingsLeft = mostCrossingsOfSearch(*geometry.mesh);
  for (int solve = 0; solve < kMostSolves && crossingsLeft > 0; ++solve) {
    Vec2 step = stand.step();
    const double wanted = step.norm();
    if (wanted <= lastStep * geometry.meanEdge) return {stand, Ended::kThere};
    step *= std::min(1.0, most / wanted);
    const StraightestPath path =
        traceStraightest(geometry, stand.place, step, {.maxCrossings = crossingsLeft});
    crossingsLeft -= path.path.points.count() / 2;
    const double length = step.norm() - path.remaining;
    if (path.stop == TraceStop::kBoundary && length < kLastStep * geometry.meanEdge) {
      return {stand, Ended::kBoundary};
    }
    const Vec2 before = step / step.norm();
    const EnergyAt there = energyAt(path.path.end());
    // Both in the frame of the way.
    const Vec2 change =
        rotateBack(before, stand.here.step) - rotateBack(path.direction, there.step);
    Matrix2 scale = rotation(before).transpose() * stand.scale * rotation(before);
    learn(scale, Vec2(length, 0), change);
    if (there.energy < stand.here.energy) {
      const Matrix2 turn = rotation(path.direction);
      stand = {path.path.end(), there, turn * scale * turn.transpose()};
      most = std::min(2 * std::max(most, length), kLongestStep * geometry.diagonal);
    } else {
      stand.scale = rotation(before) * scale * rotation(before).transpose();
      constexpr double kShorter = 0.5;
      most = kShorter * length;
      if (most <= lastStep * geometry.meanEdge) break;
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

/// K on the circle that `converged` is told by.
struct Ring {
  static constexpr int kCount = 8;
  Array<SurfacePoint> places;
  Array<double> values;
  double cosine = 0;  ///< of the first harmonics
  double sine = 0;
  double secondCosine = 0;
  double secondSine = 0;
  double mean = 0;
  int lowest = 0;
  double least = kInfinity;  ///< of the values and of the harmonics
};

Ring ringAround(const Geometry& geometry, const SurfacePoint& center,
                ExactOneSourceEnergy& energy) {
  Ring ring;
  ring.places =
      circleAround(geometry, center, kCheckedRadius * geometry.meanEdge, Ring::kCount);
  for (int k = 0; k < Ring::kCount; ++k) {
    const double value = energy.energyAt(ring.places[k]);
    ring.values.push_back(value);
    const double angle = 2 * kPi * (k + 0.5) / Ring::kCount;
    ring.mean += value / Ring::kCount;
    ring.cosine += 2 * value * std::cos(angle) / Ring::kCount;
    ring.sine += 2 * value * std::sin(angle) / Ring::kCount;
    ring.secondCosine += 2 * value * std::cos(2 * angle) / Ring::kCount;
    ring.secondSine += 2 * value * std::sin(2 * angle) / Ring::kCount;
    if (value < ring.values[ring.lowest]) ring.lowest = k;
  }
  ring.least = ring.values[ring.lowest];
  constexpr int kBetween = 64;
  for (int k = 0; k < kBetween; ++k) {
    const Vec2 one = unitVector(2 * kPi * k / kBetween);
    const Vec2 two = rotate(one, one);
    ring.least = std::min(ring.least, ring.mean + ring.cosine * one.x() + ring.sine * one.y() +
                                          ring.secondCosine * two.x() + ring.secondSine * two.y());
  }
  return ring;
}

}  // namespace

bool isOfMany(const WeightedPoints& points, const MeanOptions& options) {
  return areHeldToExact(options.field) && !options.looksForOthers &&
         points.points.count() >= kMany &&
         std::all_of(points.weights.begin(), points.weights.end(),
                     [](double weight) { return weight > 0; });
}

std::optional<Mean> meanOfMany(Surface& surface, const WeightedPoints& points,
                               const MeanOptions& options) {
  const Geometry& geometry = surface.geometry();
  const std::unique_ptr<DistanceSolver> solver = makeDistanceSolver(surface, options.field);
  OneSourceEnergy energy(geometry, points, *solver);
  const auto roughly = [&](const SurfacePoint& place) { return energy.at(place); };

  Stand stand;
  stand.here.energy = kInfinity;
  const Array<SurfacePoint> starts =
      options.start ? Array<SurfacePoint>{*options.start} : startsOf(points, kStarts);
  for (const SurfacePoint& start : starts) {
    const EnergyAt here = roughly(start);
    if (here.energy < stand.here.energy) stand = {start, here, Matrix2::Identity()};
  }
  Descent descent = descend(geometry, stand, kLastRoughStep, roughly);
  if (descent.ended == Ended::kBoundary) return std::nullopt;
  stand = descent.stand;
  const auto walk = [&](const SurfacePoint& from, const Vec2& step) {
    return traceStraightest(geometry, from, step,
                            {.maxCrossings = mostCrossingsOfSearch(*geometry.mesh)})
        .path.end();
  };
  if (getenv("DBG")) printf("rough: %d solves, ended %d, E %.5f step %.5f\n", energy.solved(), (int)descent.ended, stand.here.energy/square(geometry.meanEdge), stand.step().norm()/geometry.meanEdge);
  if (!options.isChecked) {
    return Mean{walk(stand.place, stand.step()), Status::kConverged, energy.solved(),
                stand.here.energy - stand.here.step.dot(stand.step()),
                Uniqueness::kNotLooked,
                {}};
  }

  ExactOneSourceEnergy exact(geometry, points);
  const auto exactly = [&](const SurfacePoint& place) { return exact.at(place); };
  constexpr int kMostMoves = 4;
  for (int move = 0;; ++move) {
    if (descent.ended == Ended::kThere) stand.place = walk(stand.place, stand.step());
    stand.here = exactly(stand.place);
    descent = descend(geometry, stand, kLastStep, exactly);
    if (descent.ended == Ended::kBoundary) return std::nullopt;
    stand = descent.stand;
    const Vec2 last = descent.ended == Ended::kThere ? stand.step() : Vec2::Zero();
    Mean mean{walk(stand.place, last), Status::kConverged, energy.solved() + exact.solved(),
              stand.here.energy - stand.here.step.dot(last),
              Uniqueness::kNotLooked,
              {}};
    if (getenv("DBG")) printf("exact: %d solves, ended %d, E %.5f step %.5f\n", exact.solved(), (int)descent.ended, mean.energy/square(geometry.meanEdge), last.norm()/geometry.meanEdge);
    const Ring ring = ringAround(geometry, mean.point, exact);
    mean.iterations = energy.solved() + exact.solved();
    const double lower = mean.energy - ring.least;
    if (getenv("DBG")) printf("ring: lower by %.5f, first (%.4f %.4f) second (%.4f %.4f) mean %.4f\n", lower/square(geometry.meanEdge), ring.cosine/square(geometry.meanEdge),ring.sine/square(geometry.meanEdge),ring.secondCosine/square(geometry.meanEdge),ring.secondSine/square(geometry.meanEdge),(ring.mean-mean.energy)/square(geometry.meanEdge));
    if (lower <= kLowerBy * square(geometry.meanEdge)) return mean;
    if (move == kMostMoves) {
      mean.status = Status::kLowerNearby;
      return mean;
    }
    stand.place = ring.places[ring.lowest];
    descent.ended = Ended::kStuck;
  }
}

}  // namespace karcher

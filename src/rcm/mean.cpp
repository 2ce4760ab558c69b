#include "rcm/mean.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "mesh/positions.h"
#include "rcm/center_search.h"
#include "rcm/exact_minimum.h"
#include "rcm/mean_of_many.h"
#include "rcm/minimum_search.h"
#include "rcm/paper_method.h"
#include "rcm/summed_field.h"

namespace karcher {
namespace {

void checkWeights(Array<double>& weights, int points, bool normalize) {
  if (points == 0) {
    throw Error(ErrorCode::kTooFewPoints, "a center of mass needs at least one point");
  }
  if (weights.count() != points) {
    throw Error(ErrorCode::kBadWeights, "there are " + std::to_string(points) + " points but " +
                                            std::to_string(weights.count()) + " weights");
  }
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    if (!std::isfinite(weights[i])) {
      throw Error(ErrorCode::kNotFinite, "weight " + std::to_string(i) + " is not a finite number");
    }
    sum += weights[i];
  }
  if (normalize) {
    if (!(sum > 0) || !std::isfinite(sum)) {
      throw Error(ErrorCode::kBadWeights, "the weights sum to " + inSentence(sum) +
                                              "; only a positive " + (sum > 0 ? "finite " : "") +
                                              "sum can be normalized");
    }
    for (double& weight : weights) weight /= sum;
    return;
  }
  if (std::abs(sum - 1) > kChainRounding) {
    throw Error(ErrorCode::kBadWeights,
                "the weights sum to " + inSentence(sum, 12) + "; they must sum to 1 within 1e-9");
  }
}

/// Raises a negative energy to 0 if no weight is negative. The fields only estimate the sum of
/// squares, and may give a negative number near its minimum.
Mean withSoundEnergy(Mean mean, const Array<double>& weights) {
  const bool anyNegative =
      std::any_of(weights.begin(), weights.end(), [](double weight) { return weight < 0; });
  if (anyNegative) return mean;
  mean.energy = std::max(mean.energy, 0.0);
  for (Minimum& other : mean.otherMinima) other.energy = std::max(other.energy, 0.0);
  return mean;
}

/// Upper bounds on the distances of the points from a place. They use the points' fields at the
/// corner of the place's face at which the place has the largest weight.
Array<double> distancesNear(const Geometry& geometry, const Array<ControlField*>& fields,
                            const SurfacePoint& point) {
  int corner = 0;
  point.bary.maxCoeff(&corner);
  const int vertex = geometry.mesh->corner(point.face, corner);
  const double leg = (geometry.mesh->positions[vertex] - position(*geometry.mesh, point)).norm();
  Array<double> distances;
  for (ControlField* field : fields) {
    distances.push_back(std::sqrt(field->at(vertex).squaredDistance) + leg);
  }
  return distances;
}

bool isToBeChecked(const Mean& mean, const MeanOptions& options) {
  return options.isChecked && mean.status == Status::kConverged && areCheckable(options.field);
}

/// The points of a mean, and the blend of fields in which the search found it. `fields`, if not
/// empty, are the fields of the single points.
struct Blended {
  FieldBlend& blend;
  Weights blendWeights;
  const Array<ControlField*>& fields;
  const Array<SurfacePoint>& points;
  Weights weights;
};

/// Moves a zero to the exact minimum near it, but keeps the zero's energy.
Mean checkedBy(const ExactMinimum& exact, Mean zero) {
  zero.iterations += exact.moves;
  if (!exact.isLowest) zero.status = Status::kLowerNearby;
  zero.point = exact.point;
  return zero;
}

Mean checkedZero(const Mean& zero, const Blended& in) {
  const Geometry& geometry = in.blend.geometry();
  ExactEnergy energy(geometry, in.points, in.weights);
  if (!in.fields.empty()) energy.guesses = distancesNear(geometry, in.fields, zero.point);
  const ExactMinimum exact = exactMinimumNear(geometry, energy, zero.point);
  Mean checked = checkedBy(exact, zero);
  if (exact.moves > 0) checked.energy = in.blend.energy(exact.point, in.blendWeights);
  return checked;
}

/// With at least this many points, the exact energy is smooth enough for a comparison at few
/// places.
constexpr int kSmooth = 200;

/// The mean of many points. It is checked if the options request a check. It is empty if the search
/// ends at a boundary, where fields find the mean better.
std::optional<Mean> checkedMeanOfMany(Surface& surface, const Array<SurfacePoint>& points,
                                      const Array<double>& weights, const MeanOptions& options) {
  const WeightedPoints merged = mergedPoints(points, weights);
  std::optional<Mean> mean = meanOfMany(surface, merged, options);
  if (!mean || !options.isChecked) return mean;
  const Geometry& geometry = surface.geometry();
  const auto checked = [&](auto energy) {
    const ExactMinimum exact = exactMinimumNear(geometry, energy, mean->point);
    Mean result = checkedBy(exact, *mean);
    result.energy = exact.energy;
    return result;
  };
  return merged.points.count() < kSmooth
             ? checked(ExactEnergy(geometry, merged.points, merged.weights))
             : checked(ExactOneSourceEnergy(geometry, merged));
}

/// Checks a mean and its other minima, and removes the zeros that are not minima. With `lowest`,
/// another minimum replaces the center if it is lower.
Mean checkedMean(const Mean& mean, const Blended& in, bool lowest) {
  Mean center = checkedZero(mean, in);
  Array<Minimum> others;
  for (const Minimum& other : mean.otherMinima) {
    Mean found = checkedZero({other.point,
                              Status::kConverged,
                              mean.iterations,
                              other.energy,
                              Uniqueness::kNotLooked,
                              {}},
                             in);
    if (found.status != Status::kConverged) continue;
    const bool isLower = found.energy < center.energy && center.status == Status::kConverged;
    if (lowest && isLower) std::swap(found, center);
    insertByEnergy(others, {found.point, found.energy});
  }
  setOtherMinima(in.blend.geometry(), others, center);
  return center;
}

/// The estimated number of values in the fields of these points. A field has a value for each
/// vertex of the mesh if `everywhere`, else only for the vertices that are nearer to its point than
/// the extent of all points (extentOf).
double likelyValues(const Surface& surface, const Array<SurfacePoint>& points, bool everywhere) {
  const double all = static_cast<double>(points.count()) * surface.mesh().vertexCount();
  if (everywhere) return all;
  Array<Vec3> places;
  for (const SurfacePoint& point : points) places.push_back(position(surface.mesh(), point));
  const double spread = 2 * extentOf(places) / surface.geometry().extent;
  return all * std::min(spread * spread, 1.0);
}

/// Sets the uniqueness of a mean after a search for other minima.
void judgeUniqueness(const Surface& surface, const Array<SurfacePoint>& points,
                     const Array<double>& weights, const std::optional<CurvatureBound>& smooth,
                     Mean& mean) {
  if (mean.status != Status::kConverged) {
    mean.uniqueness = mean.otherMinima.empty() ? Uniqueness::kNotLooked : Uniqueness::kNotUnique;
    return;
  }
  const double radius = provedRadius(surface, points, weights, mean.point, smooth);
  const Vec3 center = position(surface.mesh(), mean.point);
  // Other minima that contradict the proof show an error of the fields, and overrule the proof.
  const bool contradicted =
      std::any_of(mean.otherMinima.begin(), mean.otherMinima.end(), [&](const Minimum& other) {
        return other.energy <= mean.energy ||
               (position(surface.mesh(), other.point) - center).norm() <= radius;
      });
  if (radius >= 0 && !contradicted) {
    mean.uniqueness = Uniqueness::kCertain;
  } else if (mean.otherMinima.empty()) {
    mean.uniqueness = Uniqueness::kLikely;
  }
}

/// The fields of points in a set. For a point without a field, the set moves a field that it no
/// longer needs, or creates a new one.
Array<std::shared_ptr<PointField>> fieldsOf(FieldSet& set, const Array<SurfacePoint>& points) {
  Array<std::shared_ptr<PointField>> fields;
  for (const SurfacePoint& point : points) fields.push_back(set.find(point));
  for (int i = 0; i < points.count(); ++i) {
    if (!fields[i]) fields[i] = set.at(points[i]);
  }
  return fields;
}

}  // namespace

std::optional<SurfacePoint> onlyPoint(const Array<SurfacePoint>& points, Weights weights) {
  std::optional<SurfacePoint> only;
  for (int i = 0; i < points.count(); ++i) {
    if (std::abs(weights.data()[i]) <= kChainRounding) continue;
    if (!only) only = points[i];
    if (points[i].face != only->face || points[i].bary != only->bary) return std::nullopt;
  }
  return only;
}

Mean centerOfMass(Surface& surface, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options) {
  FieldSets sets(surface);
  std::shared_ptr<FieldSet> none;
  return centerOfMass(sets, points, std::move(weights), options, none);
}

Mean centerOfMass(FieldSets& sets, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options, std::shared_ptr<FieldSet>& kept) {
  Surface& surface = sets.surface();
  std::shared_ptr<FieldSet> set = sets.of(options.field);
  // After an error the caller has no set.
  kept = nullptr;
  checkWeights(weights, points.count(), options.normalize);
  Array<SurfacePoint> connected = points;
  if (options.start) connected.push_back(*options.start);
  checkOneComponent(surface, connected);

  const auto finished = [&](Mean mean) {
    if (options.looksForOthers) judgeUniqueness(surface, points, weights, options.smooth, mean);
    return withSoundEnergy(std::move(mean), weights);
  };
  if (const std::optional<SurfacePoint> only = onlyPoint(points, weights)) {
    kept = std::move(set);
    return {*only, Status::kConverged, 0, 0, Uniqueness::kCertain, {}};
  }
  if (isOfMany(points, weights, options)) {
    std::optional<Mean> mean = checkedMeanOfMany(surface, points, weights, options);
    if (mean) return withSoundEnergy(std::move(*mean), weights);
  }
  const double values = likelyValues(surface, points, options.looksForOthers);
  if (values > options.mostValues) {
    ControlField sum = sumOfFields(surface, points, weights, options.field);
    FieldBlend field(surface.geometry(), {&sum});
    const Array<double> one{1};
    const Array<ControlField*> summed;
    Mean mean = findMean(surface, field, one, points, weights, options);
    if (isToBeChecked(mean, options)) {
      mean = checkedMean(mean, {field, one, summed, points, weights}, !options.start);
    }
    return finished(std::move(mean));
  }
  Array<std::shared_ptr<PointField>> fields = fieldsOf(*set, points);
  Array<ControlField*> pointers;
  for (const auto& field : fields) pointers.push_back(&field->field());
  FieldBlend blend(surface.geometry(), pointers);
  Mean mean = findMean(surface, blend, weights, points, weights, options);
  if (isToBeChecked(mean, options)) {
    mean = checkedMean(mean, {blend, weights, pointers, points, weights}, !options.start);
  }
  mean = finished(std::move(mean));
  const bool isKept = values <= options.mostValues / 4;
  if (!isKept) fields.clear();
  // The set keeps at most as many spare fields as there are points.
  set->dropSpare(isKept ? points.count() : 0);
  if (isKept) kept = std::move(set);
  return mean;
}

Array<Mean> centersOfMass(FieldSets& sets, const Array<SurfacePoint>& points,
                          const Array<double>& rows, MeanOptions options,
                          std::shared_ptr<FieldSet>& kept) {
  const int width = points.count();
  if (width == 0) {
    throw Error(ErrorCode::kTooFewPoints, "a center of mass needs at least one point");
  }
  if (rows.count() % width != 0) {
    throw Error(ErrorCode::kBadWeights, "there are " + std::to_string(rows.count()) +
                                            " weights, which are no rows of " +
                                            std::to_string(width));
  }
  options.looksForOthers = false;
  Surface& surface = sets.surface();
  const int count = rows.count() / width;
  Array<double> weights(points.size());
  const auto read = [&](int row) {
    const auto begin = rows.begin() + static_cast<ptrdiff_t>(row) * width;
    weights.assign(begin, begin + width);
    try {
      checkWeights(weights, width, options.normalize);
    } catch (const Error& error) {
      throw Error(error.code(), "row " + std::to_string(row) + ": " + error.what());
    }
  };
  for (int row = 0; row < count; ++row) read(row);
  Array<Mean> means;
  means.reserve(static_cast<size_t>(count));
  const bool keepsFields = likelyValues(surface, points, false) <= options.mostValues;
  if (options.isChecked || !keepsFields) {
    for (int row = 0; row < count; ++row) {
      read(row);
      means.push_back(centerOfMass(sets, points, weights, options, kept));
    }
    return means;
  }
  kept = nullptr;
  Array<SurfacePoint> connected = points;
  if (options.start) connected.push_back(*options.start);
  checkOneComponent(surface, connected);
  std::shared_ptr<FieldSet> set = sets.of(options.field);
  const Array<std::shared_ptr<PointField>> fields = fieldsOf(*set, points);
  Array<ControlField*> pointers;
  for (const auto& field : fields) pointers.push_back(&field->field());
  FieldBlend blend(surface.geometry(), pointers);
  // All rows start at the center of equal weights. An average of averages would take several path
  // searches for each row.
  const Array<double> equal(points.size(), 1.0 / width);
  const SurfacePoint shared = findMean(surface, blend, equal, points, equal, options).point;
  for (int row = 0; row < count; ++row) {
    read(row);
    if (const std::optional<SurfacePoint> only = onlyPoint(points, weights)) {
      means.push_back({*only, Status::kConverged, 0, 0, Uniqueness::kCertain, {}});
      continue;
    }
    Mean mean = findMean(surface, blend, weights, points, weights, options, &shared);
    means.push_back(withSoundEnergy(std::move(mean), weights));
  }
  return means;
}

Mean centerOfMassOfDistances(Surface& surface, const Array<Array<double>>& distances,
                             Array<double> weights, const MeanOptions& options) {
  checkWeights(weights, distances.count(), options.normalize);
  Array<ControlField> owners;
  owners.reserve(distances.size());
  Array<ControlField*> pointers;
  for (const Array<double>& field : distances) {
    owners.push_back(fieldFromDistances(surface, field));
    pointers.push_back(&owners.back());
  }
  FieldBlend fields(surface.geometry(), std::move(pointers));
  SurfacePoint start;
  if (options.start) {
    start = *options.start;
  } else {
    const Array<double>& nearest = distances[firstLargest(weights)];
    start = vertexPoint(
        surface.mesh(),
        static_cast<int>(std::min_element(nearest.begin(), nearest.end()) - nearest.begin()));
  }
  return withSoundEnergy(withEnergy(fields, weights, newtonCenter(fields, weights, start)),
                         weights);
}

}  // namespace karcher

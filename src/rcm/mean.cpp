#include "rcm/mean.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "mesh/error.h"
#include "rcm/exact_minimum.h"
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
      throw Error(ErrorCode::kBadWeights,
                  "the weights cannot be normalised: their sum must be "
                  "positive");
    }
    for (double& weight : weights) weight /= sum;
    return;
  }
  if (std::abs(sum - 1) > kWeightSumTolerance) {
    throw Error(ErrorCode::kBadWeights,
                "the weights sum to " + inSentence(sum, 12) + "; they must sum to 1 within 1e-9");
  }
}

int heaviest(const Array<double>& weights) {
  return static_cast<int>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

Mean withEnergy(FieldBlend& fields, const Array<double>& weights, const CenterOfMass& center) {
  return {center.point, center.status, center.iterations, fields.energy(center.point, weights),
          false};
}

/// The fields' estimate of a sum of squares may lie below 0 near its least; the sum does not.
Mean withSoundEnergy(Mean mean, const Array<double>& weights) {
  const bool anyNegative =
      std::any_of(weights.begin(), weights.end(), [](double weight) { return weight < 0; });
  if (!anyNegative) mean.energy = std::max(mean.energy, 0.0);
  return mean;
}

/// The number of a point that all points of weight not 0 equal, or -1: it is its own mean.
int onlyPoint(const Array<SurfacePoint>& points, const Array<double>& weights) {
  int only = -1;
  for (int i = 0; i < points.count(); ++i) {
    if (weights[i] == 0) continue;
    if (only < 0) only = i;
    if (points[i].face != points[only].face || points[i].bary != points[only].bary) return -1;
  }
  return only;
}

/// Whether a is the better answer: converged before not, then the lower energy.
bool better(const Mean& a, const Mean& b) {
  const bool aConverged = a.status == Status::kConverged;
  const bool bConverged = b.status == Status::kConverged;
  return aConverged != bConverged ? aConverged : a.energy < b.energy;
}

Mean lowestMinimum(FieldBlend& fields, const Array<double>& weights,
                   const Array<SurfacePoint>& starts) {
  const Geometry& geometry = fields.geometry();
  Array<Mean> minima;
  for (const SurfacePoint& start : starts) {
    minima.push_back(withEnergy(fields, weights, walkToCenter(fields, weights, start)));
  }
  Mean best = *std::min_element(minima.begin(), minima.end(), better);
  const Vec3 where = position(*geometry.mesh, best.point);
  for (const Mean& other : minima) {
    if (other.status != Status::kConverged) continue;
    const Vec3 there = position(*geometry.mesh, other.point);
    if ((there - where).norm() > 1e-6 * geometry.diagonal) best.otherMinima = true;
  }
  return best;
}

/// Distances of a point as fields have them at a vertex beside it, no shorter.
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
  return options.isChecked && mean.status == Status::kConverged && areHeldToExact(options.field);
}

/// A center that is a minimum by exact distances too; `fields`, if not empty, are those of the
/// points.
Mean checkedMean(const Mean& mean, FieldBlend& blend, Weights ofBlend,
                 const Array<ControlField*>& fields, const Array<SurfacePoint>& points,
                 Weights weights) {
  const Geometry& geometry = blend.geometry();
  ExactEnergy energy(geometry, points, weights);
  if (!fields.empty()) energy.guesses = distancesNear(geometry, fields, mean.point);
  const ExactMinimum found = exactMinimumNear(geometry, energy, mean.point);
  Mean checked = mean;
  checked.iterations += found.moves;
  if (!found.isLowest) checked.status = Status::kLowerNearby;
  if (found.moves > 0) {
    checked.point = found.point;
    checked.energy = blend.energy(found.point, ofBlend);
  }
  return checked;
}

/// How many values the fields of these points would hold: those of the vertices within the points'
/// spread of each.
double likelyValues(const Surface& surface, const Array<SurfacePoint>& points) {
  Vec3 low = position(surface.mesh(), points[0]);
  Vec3 high = low;
  for (const SurfacePoint& point : points) {
    low = low.cwiseMin(position(surface.mesh(), point));
    high = high.cwiseMax(position(surface.mesh(), point));
  }
  const double spread = 2 * (high - low).norm() / surface.geometry().diagonal;
  return static_cast<double>(points.count()) * surface.mesh().vertexCount() *
         std::min(spread * spread, 1.0);
}

Mean search(FieldBlend& fields, const Array<double>& weights, const Array<SurfacePoint>& points,
            int heaviestPoint, const MeanOptions& options) {
  if (options.field.method == Method::kPaper) {
    const SurfacePoint start = options.start ? *options.start : points[heaviestPoint];
    return withEnergy(fields, weights, newtonCenter(fields, weights, start));
  }
  return lowestMinimum(fields, weights,
                       options.start ? Array<SurfacePoint>{*options.start} : points);
}

/// The fields of points from a set: those that are there stay, the others are moved or made.
Array<std::shared_ptr<PointField>> fieldsOf(FieldSet& set, const Array<SurfacePoint>& points) {
  Array<std::shared_ptr<PointField>> fields;
  for (const SurfacePoint& point : points) fields.push_back(set.find(point));
  for (int i = 0; i < points.count(); ++i) {
    if (!fields[i]) fields[i] = set.at(points[i]);
  }
  return fields;
}

}  // namespace

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
  // After an error none is kept.
  kept = nullptr;
  checkWeights(weights, points.count(), options.normalize);
  Array<SurfacePoint> connected = points;
  if (options.start) connected.push_back(*options.start);
  checkOneComponent(surface, connected);

  const int only = onlyPoint(points, weights);
  if (only >= 0) {
    kept = std::move(set);
    return {points[only], Status::kConverged, 0, 0, false};
  }
  const double values = likelyValues(surface, points);
  if (values > options.mostValues) {
    ControlField sum = sumOfFields(surface, points, weights, options.field);
    FieldBlend field(surface.geometry(), {&sum});
    const Array<double> one{1};
    Mean mean = search(field, one, points, heaviest(weights), options);
    if (isToBeChecked(mean, options)) {
      mean = checkedMean(mean, field, one, {}, points, weights);
    }
    return withSoundEnergy(mean, weights);
  }
  Array<std::shared_ptr<PointField>> fields = fieldsOf(*set, points);
  Array<ControlField*> pointers;
  for (const auto& field : fields) pointers.push_back(&field->field());
  FieldBlend blend(surface.geometry(), pointers);
  Mean mean = search(blend, weights, points, heaviest(weights), options);
  if (isToBeChecked(mean, options)) {
    mean = checkedMean(mean, blend, weights, pointers, points, weights);
  }
  mean = withSoundEnergy(mean, weights);
  const bool isKept = values <= options.mostValues / 4;
  if (!isKept) fields.clear();
  // Of more points that there were before, not more than as many again.
  set->dropSpare(isKept ? points.count() : 0);
  if (isKept) kept = std::move(set);
  return mean;
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
    const Array<double>& nearest = distances[heaviest(weights)];
    start = vertexPoint(
        surface.mesh(),
        static_cast<int>(std::min_element(nearest.begin(), nearest.end()) - nearest.begin()));
  }
  return withSoundEnergy(withEnergy(fields, weights, newtonCenter(fields, weights, start)),
                         weights);
}

}  // namespace karcher

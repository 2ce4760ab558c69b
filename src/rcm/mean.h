#pragma once

#include <memory>
#include <optional>

#include "rcm/center_of_mass.h"
#include "rcm/field_set.h"
#include "rcm/uniqueness.h"

/// The center of mass of given points, without a known start.
namespace karcher {

struct Minimum {
  SurfacePoint point;
  double energy = 0;  ///< the energy, as Mean::energy
};

struct Mean {
  SurfacePoint point;
  Status status = Status::kConverged;
  int iterations = 0;
  /// The sum of weight times squared distance, as the fields estimate it (FieldBlend::energy), or
  /// by exact distances for many points (mean_of_many.h). It is negative only if a weight is.
  double energy = 0;
  /// The uniqueness. It may be kNotUnique without `looksForOthers`, if searches from the control
  /// points found other minima.
  Uniqueness uniqueness = Uniqueness::kNotLooked;
  /// The other minima at which searches ended, checked like the center, more than a tenth of the
  /// mean edge apart, in ascending order of energy. If the uniqueness is certain, they lie higher,
  /// and farther from the center than any of the points.
  Array<Minimum> otherMinima;
};

struct MeanOptions {
  FieldOptions field;
  /// The start of the search. By default, the paper's method starts at the control point of the
  /// largest weight. kKarcher starts at an average of averages, then at the control points near
  /// which K may be lower (first_start.h), and returns the lowest minimum; for many points it
  /// starts at some of them (mean_of_many.h).
  std::optional<SurfacePoint> start;
  bool normalize = false;  ///< whether to divide the weights by their sum instead of requiring 1
  /// Whether to search from the control points and from 32 places all over the surface, and to
  /// decide whether the center is the only one. Without `start` the center is the lowest minimum
  /// found. Each field is computed on the whole surface.
  bool looksForOthers = false;
  /// The curvature bound of the smooth surface that the mesh approximates, if known. It serves the
  /// uniqueness.
  std::optional<CurvatureBound> smooth = std::nullopt;
  /// The memory limit in values of fields, of about 150 bytes each. Above it, fields are not kept
  /// separately but summed one after the other (summed_field.h), in the memory of one field over
  /// the whole surface. Many points (mean_of_many.h) need no fields.
  double mostValues = 2e6;
  /// Whether means by kKarcher with fast or exact distances are checked. Then kConverged requires a
  /// local minimum of K by exact distances (exact_minimum.h), to which the center is moved from a
  /// zero near by; without one the status is kLowerNearby. If false, kConverged is any zero with a
  /// positive definite Hessian, as for a curve's samples.
  bool isChecked = true;
};

/// The point that all points of nonzero weight equal, if there is one: it is their mean. Weights up
/// to 1e-9 come from rounding.
std::optional<SurfacePoint> onlyPoint(const Array<SurfacePoint>& points, Weights weights);

/// If all points of nonzero weight are equal, the mean is that point, with energy 0. Throws Error:
/// kBadWeights (not one for each point, not summing to 1 within 1e-9, or normalised with a sum that
/// is not positive), kNotFinite, kTooFewPoints (none), kUnreachable (several components).
Mean centerOfMass(Surface& surface, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options);

/// The same with the fields of a set, which is returned in `kept` for the next call: if only
/// weights change, no field is computed again, and if points move, only theirs. No set is kept
/// after an error, or if the fields are likely to hold more than a quarter of `mostValues`. The
/// result does not depend on the sets' contents.
Mean centerOfMass(FieldSets& sets, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options, std::shared_ptr<FieldSet>& kept);

/// The centers of mass of one set of points, one for each row of weights, which `rows` has one
/// after the other. Each center is that of `centerOfMass` but costs as little as a sample of a
/// curve, since the points' fields are computed once and the searches start at the center of equal
/// weights. Only options.isChecked checks them by exact distances, each at the cost of a single
/// center. options.looksForOthers has no effect. Throws as `centerOfMass` does, naming the row of
/// invalid weights; kBadWeights if `rows` does not have one weight for each point in each row.
Array<Mean> centersOfMass(FieldSets& sets, const Array<SurfacePoint>& points,
                          const Array<double>& rows, MeanOptions options,
                          std::shared_ptr<FieldSet>& kept);

/// The same for fields from a caller's own distances, an array with a distance for each vertex for
/// every point, by the paper's method. The search starts at options.start, else at the vertex
/// nearest to the source of the largest weight.
Mean centerOfMassOfDistances(Surface& surface, const Array<Array<double>>& distances,
                             Array<double> weights, const MeanOptions& options);

}  // namespace karcher

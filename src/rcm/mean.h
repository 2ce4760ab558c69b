#pragma once

#include <memory>
#include <optional>

#include "rcm/center_of_mass.h"
#include "rcm/field_set.h"
#include "rcm/uniqueness.h"

/// The center of mass of points given at once, from a cold start.
namespace karcher {

struct Minimum {
  SurfacePoint point;
  double energy = 0;  ///< as Mean's
};

struct Mean {
  SurfacePoint point;
  Status status = Status::kConverged;
  int iterations = 0;
  /// The sum of weight times squared distance, as the fields estimate it (FieldBlend::energy), or
  /// of many points (mean_of_many.h) by exact distances; not below 0 where no weight is.
  double energy = 0;
  /// kNotUnique without `looksForOthers`, too, if the searches that were made found other minima.
  Uniqueness uniqueness = Uniqueness::kNotLooked;
  /// Other minima at which searches ended, checked as the center is: more than a tenth of the mean
  /// edge apart, from the lowest up. Where the uniqueness is certain they lie higher, and farther
  /// than any of the points.
  Array<Minimum> otherMinima;
};

struct MeanOptions {
  FieldOptions field;
  /// Where the search starts. By default at the control point of the largest weight with the
  /// paper's method. With kKarcher at an average of averages, then at the control points near which
  /// K may be lower than there (first_start.h); the lowest energy is returned. Of many points at
  /// some of them (mean_of_many.h).
  std::optional<SurfacePoint> start;
  bool normalize = false;  ///< divide the weights by their sum instead of requiring 1
  /// Search from the control points and from 32 places all over the surface, and tell whether the
  /// center is the only one. Without `start` it is the lowest minimum that was found. Reads all of
  /// each field.
  bool looksForOthers = false;
  /// Of the smooth surface that the mesh approximates, where that is known: for the uniqueness.
  std::optional<CurvatureBound> smooth = std::nullopt;
  /// A limit of memory in values of fields, about 150 bytes each. Above it fields are not kept one
  /// by one: they are summed one after the other (summed_field.h), which takes the memory of one
  /// over the whole surface. Many points (mean_of_many.h) need no fields.
  double mostValues = 2e6;
  /// With kKarcher and fast or exact distances: kConverged only where K by exact distances has a
  /// local minimum (exact_minimum.h), to which the center is moved from a zero near by; else the
  /// status is kLowerNearby. Without it kConverged is any zero with a positive definite Hessian, as
  /// of a curve's samples.
  bool isChecked = true;
};

/// Points that are all one, but for those of weight 0, are their own mean, with no energy.
/// Throws Error: kBadWeights (not one a point, not summing to 1 within 1e-9, or to normalise a sum
/// that is not positive), kNotFinite, kTooFewPoints (none), kUnreachable (several components).
Mean centerOfMass(Surface& surface, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options);

/// The same with the fields of a set, which is put into `kept` for the next time: where only
/// weights change no field is made anew, and where points move, only theirs. After an error, and
/// where the fields are likely to hold more than a quarter of `mostValues`, none is kept. The
/// answer does not depend on what the sets hold.
Mean centerOfMass(FieldSets& sets, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options, std::shared_ptr<FieldSet>& kept);

/// The centers of mass of one set of points, one for each row of weights, one row after the other:
/// what `centerOfMass` finds of each, at the cost of a curve's samples, as the points' fields are
/// made once. Only with options.isChecked they are held to exact distances, each at the cost of a
/// center of its own. Nothing is looked for beside them: options.looksForOthers has no effect.
/// Throws as `centerOfMass` does, naming the row of weights that do not serve; kBadWeights for
/// weights that are not rows of one a point.
Array<Mean> centersOfMass(FieldSets& sets, const Array<SurfacePoint>& points,
                          const Array<double>& rows, MeanOptions options,
                          std::shared_ptr<FieldSet>& kept);

/// The same for fields from a caller's own distances, one array of a distance a vertex for each
/// point, by the paper's method. The search starts at options.start, else at the vertex nearest to
/// the source of the largest weight.
Mean centerOfMassOfDistances(Surface& surface, const Array<Array<double>>& distances,
                             Array<double> weights, const MeanOptions& options);

}  // namespace karcher

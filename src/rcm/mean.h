#pragma once

#include <memory>
#include <optional>

#include "rcm/field_blend.h"
#include "rcm/field_set.h"
#include "rcm/search_end.h"
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
  /// The sum of weight times squared distance, as the fields estimate it (FieldBlend::energy). For
  /// many points (mean_of_many.h) it is computed by exact distances if the mean is checked, else by
  /// the solver's distances. The energy is negative only if a weight is negative.
  double energy = 0;
  /// The uniqueness. It may be kNotUnique without `looksForOthers`, if searches from the control
  /// points found other minima.
  Uniqueness uniqueness = Uniqueness::kNotLooked;
  /// The other minima at which searches ended, in ascending order of energy. They are checked like
  /// the center, and lie more than a tenth of the mean edge apart. If `uniqueness` is kCertain,
  /// their energies are higher than the center's, and they lie farther from the center than all
  /// given points.
  Array<Minimum> otherMinima;
};

struct MeanOptions {
  FieldOptions field;
  /// The start of the search. By default, the paper's method starts at the control point of the
  /// largest weight. kKarcher starts at an average of averages, then at the control points near
  /// which K may be lower (first_start.h), and returns the lowest minimum. For many points kKarcher
  /// starts at some of the points (mean_of_many.h).
  std::optional<SurfacePoint> start;
  bool normalize = false;  ///< whether to divide the weights by their sum; else the sum is checked
  /// Whether to search from the control points and from 32 places all over the surface, and to
  /// decide whether the center is the only minimum. Without `start` the center is the lowest
  /// minimum found. This computes each field on the whole surface.
  bool looksForOthers = false;
  /// The curvature bound of the smooth surface that the mesh approximates, if known. The proof of
  /// uniqueness uses it.
  std::optional<CurvatureBound> smooth = std::nullopt;
  /// The memory limit, as a number of values of fields; a value takes about 150 bytes. If the
  /// fields are likely to need more, the search keeps only their sum (summed_field.h), which takes
  /// the memory of one field over the whole surface. Many points (mean_of_many.h) need no fields.
  double mostValues = 2e6;
  /// Whether to check means by kKarcher with fast or exact distances. A check moves the center from
  /// a zero to a near local minimum of K by exact distances (exact_minimum.h). Only such a minimum
  /// is kConverged; if the check finds none, the status is kLowerNearby. Without a check, every
  /// zero with a positive definite Hessian is kConverged, as for a curve's samples.
  bool isChecked = true;
};

/// The common place of all points whose weights exceed 1e-9 in absolute value; empty if these
/// points do not lie at one place. The common place is the mean of the points. Smaller weights come
/// from rounding.
std::optional<SurfacePoint> onlyPoint(const Array<SurfacePoint>& points, Weights weights);

/// If `onlyPoint` finds a point, the mean is that point, with energy 0. Throws Error: kTooFewPoints
/// if there are no points; kBadWeights if there is not one weight for each point, if the weights do
/// not sum to 1 within 1e-9, or, with options.normalize, if their sum is not positive and finite;
/// kNotFinite if a weight is not finite; kUnreachable if the points and options.start do not lie on
/// one component.
Mean centerOfMass(Surface& surface, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options);

/// The same with the fields of a set. `kept` returns the set for the next call. If only weights
/// change, the next call computes no field again; if points move, it computes only their fields.
/// `kept` is null after an error, after a search without fields (mean_of_many.h), or if the fields
/// are likely to hold more than a quarter of `mostValues`. The result does not depend on the sets'
/// contents.
Mean centerOfMass(FieldSets& sets, const Array<SurfacePoint>& points, Array<double> weights,
                  const MeanOptions& options, std::shared_ptr<FieldSet>& kept);

/// The centers of mass of one set of points, one for each row of weights; `rows` holds the rows one
/// after the other. Each center is the one that `centerOfMass` finds, but takes only the time of a
/// sample of a curve: the function computes the points' fields once, and starts all searches at the
/// center of equal weights. If options.isChecked, or if the fields are likely to exceed
/// options.mostValues, each row takes as long as a call of `centerOfMass`. options.looksForOthers
/// has no effect. Throws what `centerOfMass` throws, with the row of invalid weights; kBadWeights
/// if a row does not have one weight for each point.
Array<Mean> centersOfMass(FieldSets& sets, const Array<SurfacePoint>& points,
                          const Array<double>& rows, MeanOptions options,
                          std::shared_ptr<FieldSet>& kept);

/// The center of mass by the paper's method, for fields from a caller's own distances. `distances`
/// has an array for each point, with a distance for each vertex. The search starts at
/// options.start, else at the vertex nearest to the source of the largest weight.
Mean centerOfMassOfDistances(Surface& surface, const Array<Array<double>>& distances,
                             Array<double> weights, const MeanOptions& options);

}  // namespace karcher

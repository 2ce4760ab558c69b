#pragma once

#include "curves/spec/curve_shape.h"

/// The bases (bases.h) of the segments of all kinds of curves, as data.
namespace karcher {

enum class BasisForm { kBernstein, kUniformCubic, kBSpline, kBarycentric, kCatmullRom, kOwn };

/// The basis of one segment as data, so that segments with equal bases can share their weights.
struct SegmentBasis {
  BasisForm form = BasisForm::kBernstein;
  int degree = 1;  ///< the degree of kBernstein and kBSpline
  /// kBSpline: 2 degree + 2 knots around the span, of which [degree] is 0 and [degree + 1] is 1;
  /// kCatmullRom: 4 knots, the middle ones 0 and 1; kBarycentric: betas.
  Array<double> numbers = {};
  std::shared_ptr<const OwnBasis> own = {};
  bool isMirrored = false;  ///< whether kOwn is mirrored (CurveShape::isBasisMirrored)
  /// A fold adds `factor` times weight `from` of the basis to the weight of the segment's point
  /// `to`. Without folds, weight i belongs to point i.
  struct Fold {
    int from = 0;
    int to = 0;
    double factor = 1;
    bool operator==(const Fold&) const = default;
  };
  Array<Fold> folds = {};
  int points = 0;  ///< the number of the segment's weights after folding

  bool operator==(const SegmentBasis&) const = default;
};

/// The weights of the segment's points at t in [0, 1]; they sum to 1. Throws Error kBadWeights if a
/// caller's basis returns a wrong number of weights, or weights that do not sum to 1.
Array<double> weightsAt(const SegmentBasis& basis, double t);

/// Writes the same weights to `weights`. If `pointWeights` is not empty, the weights are multiplied
/// by these factors and divided by the sum of the products.
void weightsAt(const SegmentBasis& basis, const Array<double>& pointWeights, double t,
               Array<double>& weights);

/// The parameters between 0 and 1, ascending, at which one point has all the weight, so that the
/// curve passes through it.
Array<double> nodesOf(const SegmentBasis& basis);

}  // namespace karcher

#include "curves/spec/segment_basis.h"

#include <algorithm>

#include "curves/spec/bases.h"
#include "mesh/error.h"
#include "rcm/field_blend.h"

namespace karcher {
namespace {

Array<double> ownWeights(const SegmentBasis& basis, double t) {
  Array<double> weights = (*basis.own)(basis.points, basis.isMirrored ? 1 - t : t);
  if (basis.isMirrored) std::reverse(weights.begin(), weights.end());
  double sum = 0;
  for (const double weight : weights) sum += weight;
  if (weights.count() == basis.points && std::abs(sum - 1) <= kChainRounding) return weights;
  throw Error(ErrorCode::kBadWeights, "the basis gives " + std::to_string(weights.count()) +
                                          " weights of sum " + inSentence(sum, 12) +
                                          " at t = " + inSentence(t) + "; there must be " +
                                          std::to_string(basis.points) + ", of sum 1 within 1e-9");
}

void findUnfolded(const SegmentBasis& basis, double t, Array<double>& weights) {
  switch (basis.form) {
    case BasisForm::kUniformCubic: {
      const std::array<double, 4> cubic = uniformCubicWeights(t);
      weights.assign(cubic.begin(), cubic.end());
      return;
    }
    case BasisForm::kBSpline:
      return bsplineBasis(basis.numbers, basis.degree, basis.degree, t, weights);
    case BasisForm::kBarycentric:
      return barycentricBasis(basis.numbers, t, weights);
    case BasisForm::kCatmullRom:
      return catmullRomBasis(basis.numbers, t, weights);
    case BasisForm::kOwn:
      weights = ownWeights(basis, t);
      return;
    case BasisForm::kBernstein:
      return bernsteinBasis(basis.degree, t, weights);
  }
}

/// Replaces the weights of the basis by those of the segment's points.
void fold(const SegmentBasis& basis, Array<double>& weights) {
  const int count = weights.count();
  weights.resize(weights.size() + static_cast<size_t>(basis.points), 0.0);
  for (const SegmentBasis::Fold& fold : basis.folds) {
    weights[count + fold.to] += fold.factor * weights[fold.from];
  }
  weights.erase(weights.begin(), weights.begin() + count);
}

}  // namespace

Array<double> weightsAt(const SegmentBasis& basis, double t) {
  Array<double> weights;
  weightsAt(basis, {}, t, weights);
  return weights;
}

void weightsAt(const SegmentBasis& basis, const Array<double>& pointWeights, double t,
               Array<double>& weights) {
  findUnfolded(basis, t, weights);
  if (!basis.folds.empty()) fold(basis, weights);
  if (!pointWeights.empty()) makeRational(pointWeights, weights);
}

Array<double> nodesOf(const SegmentBasis& basis) {
  Array<double> nodes;
  if (basis.form != BasisForm::kBarycentric) return nodes;
  const int last = basis.numbers.count() - 1;
  for (int i = 1; i < last; ++i) nodes.push_back(static_cast<double>(i) / last);
  return nodes;
}

}  // namespace karcher

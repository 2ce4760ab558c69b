#include "curves/polygon/spline_levels.h"

#include <algorithm>
#include <utility>

#include "curves/spec/knots.h"

namespace karcher {
namespace {

/// Weights of parents below this are rounding.
constexpr double kNegligible = 1e-12;

/// The row of a knot insertion for the new control point whose knots are new_[j + 1], ...,
/// new_[j + p]: its weights of the p + 1 old points of span `span`, as the blossom of that span's
/// polynomial (E. Cohen, T. Lyche, R. Riesenfeld, "Discrete B-splines and subdivision techniques",
/// 1980). `old(k)` and `refined(k)` give knots.
template <class Old, class Refined>
Array<double> insertionRow(const Old& old, const Refined& refined, int degree, int span, int j) {
  // Row by row of de Boor's pyramid, on unit vectors.
  Array<Array<double>> d(static_cast<size_t>(degree) + 1);
  for (int i = 0; i <= degree; ++i) {
    d[i].assign(static_cast<size_t>(degree) + 1, 0);
    d[i][i] = 1;
  }
  for (int r = 1; r <= degree; ++r) {
    for (int i = degree; i >= r; --i) {
      const int k = span - degree + i;
      const double left = old(k);
      const double right = old(k + degree + 1 - r);
      const double a = (refined(j + r) - left) / (right - left);
      for (int c = 0; c <= degree; ++c) d[i][c] = (1 - a) * d[i - 1][c] + a * d[i][c];
    }
  }
  Array<double>& row = d[degree];
  double sum = 0;
  for (double& weight : row) {
    if (weight < kNegligible) weight = 0;
    sum += weight;
  }
  for (double& weight : row) weight /= sum;
  return row;
}

/// A B-spline's control polygon with its legs.
struct SplinePolygon {
  Array<WeightedPoint> points;
  Array<SurfacePath> legs;
  Array<double> knots;
};

class SplineLevels {
 public:
  SplineLevels(const Geometry& geometry, int degree, bool closed)
      : geometry_(geometry), mesh_(*geometry.mesh), degree_(degree), closed_(closed) {}

  /// One level: a knot in the middle of each span.
  SplinePolygon refined(const SplinePolygon& polygon) {
    old_ = &polygon;
    count_ = polygon.points.count();
    const Array<double> knots = closed_ ? refinedClosedKnots() : refinedOpenKnots();
    const int points = knots.count() - (closed_ ? 1 : degree_ + 1);
    SplinePolygon result;
    anchors_.clear();
    for (int j = 0; j < points; ++j) appendPoint(knots, j, result);
    for (int j = 0; j + (closed_ ? 0 : 1) < points; ++j) appendLeg((j + 1) % points, j, result);
    result.knots = knots;
    return result;
  }

 private:
  /// A path from a new point to an old one that it lies near, to lead its legs by.
  struct Anchor {
    SurfacePath path;
    int parent = 0;  ///< counted on around a closed curve
  };

  /// A point that averages have brought so far, from one end of the parents.
  struct Side {
    WeightedPoint point;
    int parent = 0;        ///< the last that was averaged
    SurfacePath toParent;  ///< of no length at first
  };

  double oldKnot(int k) const {
    return closed_ ? knotOfSpan(old_->knots, degree_, true, k - degree_) : old_->knots[k];
  }

  int wrapped(int i) const { return closed_ ? ((i % count_) + count_) % count_ : i; }
  const SurfacePath& leg(int i) const { return old_->legs[wrapped(i)]; }

  Array<double> refinedClosedKnots() const {
    Array<double> knots;
    for (int k = 0; k + 1 < old_->knots.count(); ++k) appendHalved(old_->knots, k, knots);
    knots.push_back(old_->knots.back());
    return knots;
  }

  /// The outer spans are halved too, so that the first and the last points come near; those that no
  /// span of the curve needs are left out.
  Array<double> refinedOpenKnots() const {
    const Array<double>& old = old_->knots;
    Array<double> all;
    for (int k = 0; k + 1 < old.count(); ++k) appendHalved(old, k, all);
    all.push_back(old.back());
    const auto first = std::upper_bound(all.begin(), all.end(), old[degree_]) - 1 - degree_;
    const auto last = std::lower_bound(all.begin(), all.end(), old[count_]) + degree_ + 1;
    return Array<double>(first, last);
  }

  static void appendHalved(const Array<double>& knots, int k, Array<double>& out) {
    out.push_back(knots[k]);
    if (knots[k + 1] > knots[k]) out.push_back(knots[k] + (knots[k + 1] - knots[k]) / 2);
  }

  /// The old span whose polynomial gives new point j: one that a span of the new point lies in.
  template <class Refined>
  int spanFor(const Refined& refined, int j) const {
    int span = degree_;
    const double at = closed_ ? refined(j) : std::clamp(refined(j), oldKnot(degree_), lastStart());
    while (oldKnot(span + 1) <= at) ++span;
    while (closed_ && oldKnot(span) > at) --span;
    return span;
  }

  /// The start of the last span that is not empty.
  double lastStart() const {
    int k = count_;
    while (old_->knots[k] == old_->knots[count_]) --k;
    return old_->knots[k];
  }

  void appendPoint(const Array<double>& knots, int j, SplinePolygon& result) {
    const auto old = [&](int k) { return oldKnot(k); };
    const auto refined = [&](int k) {
      return closed_ ? knotOfSpan(knots, degree_, true, k - degree_) : knots[k];
    };
    const int span = spanFor(refined, j);
    const Array<double> row = insertionRow(old, refined, degree_, span, j);
    int first = 0;
    while (row[first] == 0) ++first;
    int last = degree_;
    while (row[last] == 0) --last;
    Array<double> weights;
    for (int k = first; k <= last; ++k) {
      weights.push_back(row[k] * pointAt(span - degree_ + k).weight);
    }
    result.points.push_back(averageOf(span - degree_ + first, weights));
  }

  const WeightedPoint& pointAt(int i) const { return old_->points[wrapped(i)]; }

  /// The repeated average of consecutive old points from number `first` on, from both ends towards
  /// the middle. Notes its anchor.
  WeightedPoint averageOf(int first, const Array<double>& weights) {
    int left = 0;
    int right = weights.count() - 1;
    if (left == right) {
      WeightedPoint point{pointAt(first).point, weights[0]};
      anchors_.push_back({{{point.point}, {0}}, first});
      return point;
    }
    Side near = sideAt(first, weights[left]);
    Side far = sideAt(first + right, weights[right]);
    while (++left < --right) {
      advance(near, weights[left], 1);
      advance(far, weights[right], -1);
    }
    if (left == right) {
      advance(near, weights[left] / 2, 1);
      advance(far, weights[left] / 2, -1);
    }
    Chain chain(mesh_, path_);
    chain.append(near.toParent);
    if (near.parent != far.parent) chain.append(leg(near.parent));
    chain.appendReversed(far.toParent);
    straighten(geometry_, path_, workspace_);
    const LegAverage average = averageOn(mesh_, path_, near.point.weight, far.point.weight);
    Anchor anchor;
    anchor.parent = near.parent;
    appendPart(mesh_, path_, average.at, 0, anchor.path);
    appendPart(mesh_, near.toParent, 0, near.toParent.length(), anchor.path);
    anchors_.push_back(std::move(anchor));
    return average.point;
  }

  Side sideAt(int parent, double weight) const {
    const SurfacePoint& point = pointAt(parent).point;
    return {{point, weight}, parent, {{point}, {0}}};
  }

  /// Averages the next parent in, in direction `step` of the row.
  void advance(Side& side, double weight, int step) {
    Chain chain(mesh_, path_);
    chain.append(side.toParent);
    if (step > 0) {
      chain.append(leg(side.parent));
    } else {
      chain.appendReversed(leg(side.parent - 1));
    }
    straighten(geometry_, path_, workspace_);
    const LegAverage average = averageOn(mesh_, path_, side.point.weight, weight);
    side.toParent = partOf(mesh_, path_, average.at, path_.length());
    side.parent += step;
    side.point = average.point;
  }

  /// The leg from new point j to new point `next`.
  void appendLeg(int next, int j, SplinePolygon& result) {
    const Anchor& from = anchors_[j];
    const Anchor& to = anchors_[next];
    // Around the end of a closed curve the numbers of parents start again.
    const int parent = to.parent + (next <= j ? count_ : 0);
    SurfacePath path;
    Chain chain(mesh_, path);
    chain.append(from.path);
    for (int k = from.parent; k < parent; ++k) chain.append(leg(k));
    for (int k = from.parent; k > parent; --k) chain.appendReversed(leg(k - 1));
    chain.appendReversed(to.path);
    straighten(geometry_, path, workspace_);
    result.legs.push_back(std::move(path));
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  int degree_;
  bool closed_;
  const SplinePolygon* old_ = nullptr;
  int count_ = 0;
  Array<Anchor> anchors_;
  SurfacePath path_;
  StripWorkspace workspace_;
};

}  // namespace

RefinedPolygon refinedSpline(const Geometry& geometry, const CurveShape& shape,
                             Array<WeightedPoint> points, const Array<SurfacePath>& legs,
                             int levels) {
  const Array<double> knots = knotsOf(shape, points.count());
  SplinePolygon polygon{std::move(points), legs, knots};
  SplineLevels scheme(geometry, shape.degree, shape.closed);
  for (int level = 0; level < levels; ++level) polygon = scheme.refined(polygon);
  CurveShape refined{CurveKind::kBSpline, shape.closed, shape.degree, KnotRule::kOwn};
  refined.knots = polygon.knots;
  RefinedPolygon result;
  result.pieces = layOut(refined, polygon.points.count());
  result.points = std::move(polygon.points);
  result.legs = std::move(polygon.legs);
  return result;
}

}  // namespace karcher

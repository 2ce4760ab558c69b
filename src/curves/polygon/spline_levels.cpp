#include "curves/polygon/spline_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curves/spec/knots.h"
#include "intrinsic/straighten.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The row of a knot insertion for one new control point: the weights of the p + 1 old points of
/// span `span`. They are the blossom of the span's polynomial at the new point's p knots, which
/// begin with refined(j + 1) (E. Cohen, T. Lyche, R. Riesenfeld, "Discrete B-splines and
/// subdivision techniques", 1980). `old(k)` and `refined(k)` return knots.
template <class Old, class Refined>
Array<double> insertionRow(const Old& old, const Refined& refined, int degree, int span, int j) {
  // This computes de Boor's pyramid row by row, on unit vectors.
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
    if (weight < kLocalRounding) weight = 0;
    sum += weight;
  }
  for (double& weight : row) weight /= sum;
  return row;
}

/// Knots of which halving can divide each nonempty span `levels` times. A span of a few units of
/// the last place becomes longer at the cost of the next, which moves the curve by less than
/// rounding.
Array<double> divisible(Array<double> knots, int levels) {
  const double units = std::ldexp(std::numeric_limits<double>::epsilon(), levels + 1);
  double before = knots.front();
  for (int k = 1; k < knots.count(); ++k) {
    const bool isEmpty = std::exchange(before, knots[k]) == knots[k];
    const double last = knots[k - 1];
    knots[k] = isEmpty ? last : std::max(knots[k], last + units * std::abs(last));
  }
  return knots;
}

/// Inserts a knot in the middle of each span, and finds the parents of the new points.
class KnotHalving {
 public:
  KnotHalving(const Array<double>& knots, int points, int degree, bool closed)
      : old_(knots), count_(points), degree_(degree), closed_(closed) {}

  Array<double> halved() const { return closed_ ? everySpanHalved() : openHalved(); }

  /// The parents of point j of the new level, which has the knots `knots`.
  SplineLevel::Parents parents(const Array<double>& knots, int j) const {
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
    return {span - degree_ + first, Array<double>(row.begin() + first, row.begin() + last + 1)};
  }

 private:
  double oldKnot(int k) const {
    return closed_ ? knotOfSpan(old_, degree_, true, k - degree_) : old_[k];
  }

  Array<double> everySpanHalved() const {
    Array<double> knots;
    for (int k = 0; k + 1 < old_.count(); ++k) appendHalved(k, knots);
    knots.push_back(old_.back());
    return knots;
  }

  /// The open knots with halved spans, without the outer knots that no point needs. The outer spans
  /// are halved, too, so that the first and the last points approach the curve.
  Array<double> openHalved() const {
    Array<double> all = everySpanHalved();
    const auto first = std::upper_bound(all.begin(), all.end(), old_[degree_]) - 1 - degree_;
    const auto last = std::lower_bound(all.begin(), all.end(), old_[count_]) + degree_ + 1;
    return Array<double>(first, last);
  }

  void appendHalved(int k, Array<double>& out) const {
    out.push_back(old_[k]);
    if (old_[k + 1] > old_[k]) out.push_back(old_[k] + (old_[k + 1] - old_[k]) / 2);
  }

  /// The old span whose polynomial gives new point j: the widest one in the new point's support, or
  /// the first of equally wide ones. Weights extrapolated from a narrow span beside wide ones would
  /// lose accuracy.
  template <class Refined>
  int spanFor(const Refined& refined, int j) const {
    int span = degree_;
    const double at = closed_ ? refined(j) : std::clamp(refined(j), oldKnot(degree_), lastStart());
    while (oldKnot(span + 1) <= at) ++span;
    while (closed_ && oldKnot(span) > at) --span;
    const auto width = [&](int k) { return oldKnot(k + 1) - oldKnot(k); };
    const double end = refined(j + degree_ + 1);
    for (int k = span + 1; (closed_ || k < count_) && oldKnot(k) < end; ++k) {
      if (width(k) > width(span)) span = k;
    }
    return span;
  }

  /// The start of the last nonempty span.
  double lastStart() const {
    int k = count_;
    while (old_[k] == old_[count_]) --k;
    return old_[k];
  }

  const Array<double>& old_;
  int count_;
  int degree_;
  bool closed_;
};

int pointsWith(const Array<double>& knots, const CurveShape& shape) {
  return knots.count() - (shape.closed ? 1 : shape.degree + 1);
}

void resize(SplineLevel& level, int points, const CurveShape& shape) {
  level.points.resize(static_cast<size_t>(points));
  level.legs.resize(static_cast<size_t>(legCount(shape, points)));
  level.anchors.resize(2 * static_cast<size_t>(points));
}

bool isKnown(const CurveShape& shape, int points, int levels, const SplineWorkspace& workspace) {
  return workspace.points == points && workspace.levels.count() == levels + 1 &&
         layAlike(workspace.shape, shape);
}

/// Computes the parents and the pieces, unless the workspace has them already: they depend only on
/// the shape and on the numbers of points and levels.
void layOutLevels(const CurveShape& shape, int points, int levels, SplineWorkspace& workspace) {
  if (isKnown(shape, points, levels, workspace)) return;
  workspace.points = 0;
  workspace.levels.resize(static_cast<size_t>(levels) + 1);
  Array<double> knots = divisible(knotsOf(shape, points), levels);
  resize(workspace.levels[0], points, shape);
  for (int level = 1; level <= levels; ++level) {
    const KnotHalving old(knots, pointsWith(knots, shape), shape.degree, shape.closed);
    Array<double> halved = old.halved();
    SplineLevel& next = workspace.levels[level];
    resize(next, pointsWith(halved, shape), shape);
    next.parents.clear();
    for (int j = 0; j < next.points.count(); ++j) next.parents.push_back(old.parents(halved, j));
    knots = std::move(halved);
  }
  CurveShape refined{CurveKind::kBSpline, shape.closed, shape.degree, KnotRule::kOwn};
  refined.knots = std::move(knots);
  workspace.pieces = layOut(refined, workspace.levels.back().points.count());
  workspace.shape = shape;
  workspace.points = points;
}

/// Computes one level from the previous one.
class SplineLevelStep {
 public:
  SplineLevelStep(const Geometry& geometry, const SplineLevel& old, bool closed,
                  StripWorkspace& strip, SplineWorkspace& workspace)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        old_(old),
        count_(old.points.count()),
        closed_(closed),
        strip_(strip),
        path_(workspace.path),
        near_(workspace.near),
        far_(workspace.far) {}

  void write(SplineLevel& next) {
    const int points = next.points.count();
    for (int j = 0; j < points; ++j) {
      next.points[j] = averageOf(next.parents[j], &next.anchors[2 * j]);
    }
    for (int j = 0; j < next.legs.count(); ++j) writeLeg((j + 1) % points, j, next);
  }

 private:
  using Anchor = SplineLevel::Anchor;
  using Parents = SplineLevel::Parents;
  using Side = SplineWorkspace::Side;

  int wrapped(int i) const { return closed_ ? ((i % count_) + count_) % count_ : i; }
  const SurfacePath& leg(int i) const { return old_.legs[wrapped(i)]; }
  const WeightedPoint& pointAt(int i) const { return old_.points[wrapped(i)]; }

  /// Returns the repeated average of the parents, from both ends of their row towards the middle,
  /// and writes its two anchors.
  WeightedPoint averageOf(const Parents& parents, Anchor* anchors) {
    int left = 0;
    int right = parents.weights.count() - 1;
    const auto weight = [&](int k) {
      // Each side takes half of the middle parent's weight.
      const double share = left == right ? 0.5 : 1;
      return share * parents.weights[k] * pointAt(parents.first + k).weight;
    };
    begin(parents.first, weight(left), near_);
    begin(parents.first + right, weight(right), far_);
    while (++left <= --right) {
      advance(near_, weight(left), 1);
      advance(far_, weight(right), -1);
    }
    Chain chain(mesh_, path_);
    chain.append(near_.toParent);
    if (near_.parent != far_.parent) chain.append(leg(near_.parent));
    chain.appendReversed(far_.toParent);
    straighten(geometry_, path_, strip_);
    const LegAverage average = averageOn(mesh_, path_, near_.point.weight, far_.point.weight);
    lead(average.at, 0, near_, anchors[0]);
    lead(average.at, path_.length(), far_, anchors[1]);
    return average.point;
  }

  /// Writes an anchor. It leads along `path_` from the length `from` to an end of `path_` at the
  /// length `to`, and on to the side's parent.
  void lead(double from, double to, const Side& side, Anchor& anchor) const {
    takePart(mesh_, path_, from, to, anchor.path);
    appendPart(mesh_, side.toParent, 0, side.toParent.length(), anchor.path);
    anchor.parent = side.parent;
  }

  void begin(int parent, double weight, Side& side) const {
    const SurfacePoint& point = pointAt(parent).point;
    side.point = {point, weight};
    side.parent = parent;
    side.toParent.points.assign(1, point);
    side.toParent.lengths.assign(1, 0.0);
  }

  /// Includes the next parent of the row in the average, in direction `step`.
  void advance(Side& side, double weight, int step) {
    Chain chain(mesh_, path_);
    chain.append(side.toParent);
    if (step > 0) {
      chain.append(leg(side.parent));
    } else {
      chain.appendReversed(leg(side.parent - 1));
    }
    straighten(geometry_, path_, strip_);
    const LegAverage average = averageOn(mesh_, path_, side.point.weight, weight);
    takePart(mesh_, path_, average.at, path_.length(), side.toParent);
    side.parent += step;
    side.point = average.point;
  }

  /// Writes the leg from new point j to new point `to`.
  void writeLeg(int to, int j, SplineLevel& next) {
    const Anchor& start = next.anchors[2 * j + 1];
    const Anchor& end = next.anchors[2 * to];
    // Past the end of a closed curve, the indices of parents restart.
    const int parent = end.parent + (to <= j ? count_ : 0);
    SurfacePath& path = next.legs[j];
    Chain chain(mesh_, path);
    chain.append(start.path);
    for (int k = start.parent; k < parent; ++k) chain.append(leg(k));
    for (int k = start.parent; k > parent; --k) chain.appendReversed(leg(k - 1));
    chain.appendReversed(end.path);
    straighten(geometry_, path, strip_);
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SplineLevel& old_;
  int count_;
  bool closed_;
  StripWorkspace& strip_;
  SurfacePath& path_;
  Side& near_;
  Side& far_;
};

}  // namespace

void refineSpline(const Geometry& geometry, const CurveShape& shape,
                  const Array<WeightedPoint>& points, const Array<SurfacePath>& legs, int levels,
                  StripWorkspace& strip, SplineWorkspace& workspace) {
  layOutLevels(shape, points.count(), levels, workspace);
  workspace.levels[0].points = points;
  workspace.levels[0].legs = legs;
  for (int level = 0; level < levels; ++level) {
    SplineLevelStep(geometry, workspace.levels[level], shape.closed, strip, workspace)
        .write(workspace.levels[level + 1]);
  }
}

}  // namespace karcher

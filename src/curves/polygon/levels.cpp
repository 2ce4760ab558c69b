#include "curves/polygon/levels.h"

#include <algorithm>
#include <string>
#include <utility>

#include "curves/spec/knots.h"
#include "intrinsic/tangent.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// Averages in one curve: a drag goes through all of them.
constexpr double kMostAverages = 1e6;
/// Weights of parents below this are rounding.
constexpr double kNegligible = 1e-12;

bool isBezier(CurveKind kind) { return kind == CurveKind::kBezier || kind == CurveKind::kRational; }

/// The average of both ends of a path, with its weight, and how far along it lies.
struct Average {
  WeightedPoint point;
  double at = 0;
};
Average averageOn(const TriangleMesh& mesh, const SurfacePath& path, double from, double to) {
  const double at = path.length() * (to / (from + to));
  return {{pointAlong(mesh, path, at), from + to}, at};
}

/// Paths one after the other, as one; `begin` starts it.
class Chain {
 public:
  Chain(const TriangleMesh& mesh, SurfacePath& path) : mesh_(mesh), path_(path) {
    path_.points.clear();
    path_.lengths.clear();
  }
  /// The part between two lengths, backwards where from > to.
  void append(const SurfacePath& next, double from, double to) {
    appendPart(mesh_, next, from, to, path_);
  }
  void append(const SurfacePath& next) { append(next, 0, next.length()); }
  void appendReversed(const SurfacePath& next) { append(next, next.length(), 0); }

 private:
  const TriangleMesh& mesh_;
  SurfacePath& path_;
};

SurfacePath partOf(const TriangleMesh& mesh, const SurfacePath& path, double from, double to) {
  SurfacePath part;
  Chain(mesh, part).append(path, from, to);
  return part;
}

/// The averages on all legs of a polygon, with the share `share(i)` of the later point on leg i.
template <class Share>
Array<Average> averagesOf(const TriangleMesh& mesh, const LeggedPolygon& polygon,
                          const Share& share) {
  Array<Average> averages;
  for (int i = 0; i < polygon.legs.count(); ++i) {
    const double s = share(i);
    averages.push_back(averageOn(mesh, polygon.legs[i], (1 - s) * polygon.points[i].weight,
                                 s * polygon.points[i + 1].weight));
  }
  return averages;
}

/// Makes a polygon that of the averages on its legs, one point fewer.
void replaceByAverages(const Geometry& geometry, const Array<Average>& averages,
                       LeggedPolygon& polygon, StripWorkspace& workspace) {
  Array<SurfacePath>& legs = polygon.legs;
  for (int i = 0; i + 1 < legs.count(); ++i) {
    SurfacePath inner;
    Chain chain(*geometry.mesh, inner);
    chain.append(legs[i], averages[i].at, legs[i].length());
    chain.append(legs[i + 1], 0, averages[i + 1].at);
    straighten(geometry, inner, workspace);
    legs[i] = std::move(inner);
  }
  legs.pop_back();
  polygon.points.clear();
  for (const Average& average : averages) polygon.points.push_back(average.point);
}

// B-splines.

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
    const Average average = averageOn(mesh_, path_, near.point.weight, far.point.weight);
    Anchor anchor;
    anchor.parent = near.parent;
    Chain back(mesh_, anchor.path);
    back.append(path_, average.at, 0);
    back.append(near.toParent);
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
    const Average average = averageOn(mesh_, path_, side.point.weight, weight);
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

// Bezier curves.

void appendPieces(const Geometry& geometry, const LeggedPolygon& polygon, int levels,
                  StripWorkspace& workspace, RefinedPolygon& out) {
  if (levels > 0) {
    const BezierHalves halves = halvesOf(geometry, polygon, workspace);
    appendPieces(geometry, halves.first, levels - 1, workspace, out);
    appendPieces(geometry, halves.second, levels - 1, workspace, out);
    return;
  }
  const int degree = polygon.points.count() - 1;
  // A piece starts where the one before it ends.
  const int first = std::max(out.points.count() - 1, 0);
  SegmentLayout layout;
  layout.basis = {BasisForm::kBernstein, degree};
  layout.basis.points = degree + 1;
  for (int k = 0; k <= degree; ++k) layout.points.push_back(first + k);
  out.points.insert(out.points.end(), polygon.points.begin() + (out.points.empty() ? 0 : 1),
                    polygon.points.end());
  out.legs.insert(out.legs.end(), polygon.legs.begin(), polygon.legs.end());
  out.pieces.push_back(std::move(layout));
}

// Catmull-Rom curves.

/// The cubic Bezier polygons of a curve through points: with the derivative at a point that Barry
/// and Goldman's pyramid has there, by log maps along the legs that meet at it.
class ThroughPoints {
 public:
  ThroughPoints(const Geometry& geometry, const CurveShape& shape,
                const Array<SurfacePoint>& points, const Array<SurfacePath>& legs)
      : geometry_(geometry), mesh_(*geometry.mesh), shape_(shape), points_(points), legs_(legs) {
    const int count = legs.count();
    for (const SurfacePath& leg : legs) gaps_.push_back(leg.length());
    spacings_ = catmullRomSpacings(gaps_, shape.centripetal);
    for (int j = 0; j < count; ++j) handles_.push_back({handleAfter(j), handleBefore(j)});
  }

  int segmentCount() const { return legs_.count(); }

  LeggedPolygon polygon(int j, StripWorkspace& workspace) const {
    const auto& [after, before] = handles_[j];
    const SurfacePoint& end = points_[(j + 1) % points_.count()];
    LeggedPolygon result;
    result.points = {{points_[j], 1}, {after.end(), 1}, {before.end(), 1}, {end, 1}};
    SurfacePath middle;
    Chain chain(mesh_, middle);
    chain.appendReversed(after);
    chain.append(legs_[j]);
    chain.append(before);
    straighten(geometry_, middle, workspace);
    result.legs = {after, middle, reversed(before)};
    return result;
  }

 private:
  /// From the start of segment j a third of the derivative on.
  SurfacePath handleAfter(int j) const {
    if (j == 0 && !shape_.closed) return partOf(mesh_, legs_[0], 0, legs_[0].length() / 3);
    const int before = (j + legs_.count() - 1) % legs_.count();
    return expAlong(geometry_, points_[j], spacings_[j] / 3 * derivative(before, j));
  }

  /// From the end of segment j a third of the derivative back.
  SurfacePath handleBefore(int j) const {
    const int last = legs_.count() - 1;
    if (j == last && !shape_.closed) {
      return partOf(mesh_, legs_[j], legs_[j].length(), legs_[j].length() * 2 / 3);
    }
    const int after = (j + 1) % legs_.count();
    return expAlong(geometry_, points_[(j + 1) % points_.count()],
                    -spacings_[j] / 3 * derivative(j, after));
  }

  /// At the point between two legs.
  Vec2 derivative(int before, int after) const {
    const Vec2 onward = logAlong(geometry_, legs_[after]) / spacings_[after];
    const Vec2 back = -logAlong(geometry_, reversed(legs_[before])) / spacings_[before];
    const double sum = spacings_[before] + spacings_[after];
    return (spacings_[before] * onward + spacings_[after] * back) / sum;
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const CurveShape& shape_;
  const Array<SurfacePoint>& points_;
  const Array<SurfacePath>& legs_;
  Array<double> gaps_;
  Array<double> spacings_;
  Array<std::pair<SurfacePath, SurfacePath>> handles_;
};

}  // namespace

bool takesLevels(CurveKind kind) {
  return kind == CurveKind::kBSpline || isBezier(kind) || kind == CurveKind::kCatmullRom;
}

void checkLevels(const CurveShape& shape, int points, int levels) {
  if (levels < 0 || levels > kMostLevels) {
    throw Error(ErrorCode::kBadArgument, "a curve takes 0 to " + std::to_string(kMostLevels) +
                                             " levels, not " + std::to_string(levels));
  }
  if (levels == 0) return;
  if (!takesLevels(shape.kind)) {
    throw Error(ErrorCode::kBadArgument,
                std::string("a curve of the kind '") + curveKindName(shape.kind) +
                    "' takes no levels: it cannot be subdivided by averages of two points");
  }
  const double legs = legCount(shape, points);
  const double averages = (isBezier(shape.kind) ? legs * legs : 6 * legs) * std::pow(2.0, levels);
  if (averages > kMostAverages) {
    throw Error(ErrorCode::kBadArgument, "a curve of this kind with " + std::to_string(points) +
                                             " points takes fewer than " + std::to_string(levels) +
                                             " levels");
  }
}

RefinedPolygon refinedPolygon(const Geometry& geometry, const CurveShape& shape,
                              const Array<SurfacePoint>& points, const Array<SurfacePath>& legs,
                              int levels) {
  Array<WeightedPoint> weighted;
  const bool hasWeights = takesWeights(shape.kind) && !shape.weights.empty();
  for (int i = 0; i < points.count(); ++i) {
    weighted.push_back({points[i], hasWeights ? shape.weights[i] : 1});
  }
  RefinedPolygon result;
  if (shape.kind == CurveKind::kBSpline) {
    result = refinedSpline(geometry, shape, std::move(weighted), legs, levels);
  } else {
    StripWorkspace workspace;
    if (isBezier(shape.kind)) {
      // A closed one ends at its first point.
      if (shape.closed) weighted.push_back(WeightedPoint(weighted[0]));
      appendPieces(geometry, {std::move(weighted), legs}, levels, workspace, result);
    } else {
      const ThroughPoints through(geometry, shape, points, legs);
      for (int j = 0; j < through.segmentCount(); ++j) {
        appendPieces(geometry, through.polygon(j, workspace), levels, workspace, result);
      }
    }
  }
  result.weighted = hasWeights;
  return result;
}

BezierHalves halvesOf(const Geometry& geometry, const LeggedPolygon& polygon,
                      StripWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  BezierHalves halves;
  LeggedPolygon row = polygon;
  halves.first.points.push_back(row.points.front());
  halves.second.points.push_back(row.points.back());
  while (!row.legs.empty()) {
    const Array<Average> averages = averagesOf(mesh, row, [](int) { return 0.5; });
    halves.first.legs.push_back(partOf(mesh, row.legs.front(), 0, averages.front().at));
    halves.second.legs.push_back(
        partOf(mesh, row.legs.back(), averages.back().at, row.legs.back().length()));
    replaceByAverages(geometry, averages, row, workspace);
    halves.first.points.push_back(row.points.front());
    halves.second.points.push_back(row.points.back());
  }
  std::reverse(halves.second.points.begin(), halves.second.points.end());
  std::reverse(halves.second.legs.begin(), halves.second.legs.end());
  return halves;
}

LeggedPolygon polygonOf(const RefinedPolygon& refined, const SegmentLayout& piece) {
  LeggedPolygon polygon;
  for (int k = 0; k < piece.points.count(); ++k) {
    polygon.points.push_back(refined.points[piece.points[k]]);
    if (!refined.weighted) polygon.points.back().weight = 1;
    if (k > 0) polygon.legs.push_back(refined.legs[piece.points[k - 1]]);
  }
  return polygon;
}

SurfacePoint averageAt(const Geometry& geometry, const SegmentBasis& basis, LeggedPolygon polygon,
                       double t, StripWorkspace& workspace) {
  const int degree = polygon.legs.count();
  const auto knot = [&](int k) {
    return basis.form == BasisForm::kBSpline ? basis.numbers[k] : k - degree;
  };
  for (int row = 1; row <= degree; ++row) {
    const auto share = [&](int i) {
      if (basis.form == BasisForm::kBernstein) return t;
      const double left = knot(i + row);
      return (t - left) / (knot(i + degree + 1) - left);
    };
    replaceByAverages(geometry, averagesOf(*geometry.mesh, polygon, share), polygon, workspace);
  }
  return polygon.points[0].point;
}

}  // namespace karcher

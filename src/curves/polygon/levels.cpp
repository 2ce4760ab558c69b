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

LegAverage averageOn(const TriangleMesh& mesh, const SurfacePath& path, double from, double to) {
  const double at = path.length() * (to / (from + to));
  return {{pointAlong(mesh, path, at), from + to}, at};
}

/// Paths one after the other, to be straightened as one.
class Chain {
 public:
  Chain(const TriangleMesh& mesh, SurfacePath& path) : mesh_(mesh), points_(path.points) {
    points_.clear();
    // Of a path of one point, which is straight.
    path.lengths.assign(1, 0.0);
  }
  /// The part between two lengths, backwards where from > to.
  void append(const SurfacePath& next, double from, double to) {
    appendPart(mesh_, next, from, to, points_);
  }
  void append(const SurfacePath& next) { append(next, 0, next.length()); }
  void appendReversed(const SurfacePath& next) { append(next, next.length(), 0); }

 private:
  const TriangleMesh& mesh_;
  Array<SurfacePoint>& points_;
};

void takePart(const TriangleMesh& mesh, const SurfacePath& path, double from, double to,
              SurfacePath& part) {
  part.points.clear();
  part.lengths.clear();
  appendPart(mesh, path, from, to, part);
}

SurfacePath partOf(const TriangleMesh& mesh, const SurfacePath& path, double from, double to) {
  SurfacePath part;
  appendPart(mesh, path, from, to, part);
  return part;
}

/// Finds the averages on the legs of the workspace's row, with the share `share(i)` of the later
/// point on leg i.
template <class Share>
void findAverages(const TriangleMesh& mesh, const Share& share, AveragingWorkspace& workspace) {
  const LeggedPolygon& row = workspace.row;
  workspace.averages.clear();
  for (int i = 0; i + 1 < row.points.count(); ++i) {
    const double s = share(i);
    workspace.averages.push_back(
        averageOn(mesh, row.legs[i], (1 - s) * row.points[i].weight, s * row.points[i + 1].weight));
  }
}

/// Makes the row that of the averages on its legs, one point fewer.
void replaceByAverages(const Geometry& geometry, AveragingWorkspace& workspace) {
  const Array<LegAverage>& averages = workspace.averages;
  Array<SurfacePath>& legs = workspace.row.legs;
  for (int i = 0; i + 1 < averages.count(); ++i) {
    Chain chain(*geometry.mesh, workspace.inner);
    chain.append(legs[i], averages[i].at, legs[i].length());
    chain.append(legs[i + 1], 0, averages[i + 1].at);
    straighten(geometry, workspace.inner, workspace.strip);
    std::swap(legs[i], workspace.inner);
  }
  workspace.row.points.clear();
  for (const LegAverage& average : averages) workspace.row.points.push_back(average.point);
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

/// Numbers of what is written of a refined polygon so far.
struct Written {
  int points = 0;
  int legs = 0;
  int pieces = 0;
};

void appendPiece(const LeggedPolygon& polygon, RefinedPolygon& out, Written& written) {
  const int degree = polygon.points.count() - 1;
  // A piece starts where the one before it ends.
  const int first = std::max(written.points - 1, 0);
  SegmentLayout& layout = out.pieces[written.pieces++];
  layout.basis = {BasisForm::kBernstein, degree};
  layout.basis.points = degree + 1;
  layout.points.clear();
  for (int k = 0; k <= degree; ++k) {
    layout.points.push_back(first + k);
    out.points[first + k] = polygon.points[k];
  }
  written.points = first + degree + 1;
  for (const SurfacePath& leg : polygon.legs) out.legs[written.legs++] = leg;
}

void appendPieces(const Geometry& geometry, const LeggedPolygon& polygon, int levels,
                  AveragingWorkspace& workspace, RefinedPolygon& out, Written& written) {
  if (levels == 0) {
    appendPiece(polygon, out, written);
    return;
  }
  BezierHalves& halves = workspace.halves[levels - 1];
  halve(geometry, polygon, workspace, halves);
  appendPieces(geometry, halves.first, levels - 1, workspace, out, written);
  appendPieces(geometry, halves.second, levels - 1, workspace, out, written);
}

/// Makes room for what a number of Bezier curves of a degree become.
void makeRoom(int curves, int degree, int levels, AveragingWorkspace& workspace,
              RefinedPolygon& out) {
  const auto pieces = static_cast<size_t>(curves) << levels;
  const auto legs = pieces * static_cast<size_t>(degree);
  out.pieces.resize(pieces);
  out.legs.resize(legs);
  out.points.resize(legs + 1);
  if (workspace.halves.count() < levels) workspace.halves.resize(static_cast<size_t>(levels));
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

void refinePolygon(const Geometry& geometry, const CurveShape& shape,
                   const Array<SurfacePoint>& points, const Array<SurfacePath>& legs, int levels,
                   AveragingWorkspace& workspace, RefinedPolygon& refined) {
  LeggedPolygon& whole = workspace.polygon;
  whole.points.clear();
  const bool hasWeights = takesWeights(shape.kind) && !shape.weights.empty();
  for (int i = 0; i < points.count(); ++i) {
    whole.points.push_back({points[i], hasWeights ? shape.weights[i] : 1});
  }
  if (shape.kind == CurveKind::kBSpline) {
    refined = refinedSpline(geometry, shape, whole.points, legs, levels);
  } else {
    Written written;
    if (isBezier(shape.kind)) {
      // A closed one ends at its first point.
      if (shape.closed) whole.points.push_back(WeightedPoint(whole.points[0]));
      whole.legs = legs;
      makeRoom(1, legs.count(), levels, workspace, refined);
      appendPieces(geometry, whole, levels, workspace, refined, written);
    } else {
      const ThroughPoints through(geometry, shape, points, legs);
      makeRoom(through.segmentCount(), 3, levels, workspace, refined);
      for (int j = 0; j < through.segmentCount(); ++j) {
        whole = through.polygon(j, workspace.strip);
        appendPieces(geometry, whole, levels, workspace, refined, written);
      }
    }
  }
  refined.weighted = hasWeights;
}

void halve(const Geometry& geometry, const LeggedPolygon& polygon, AveragingWorkspace& workspace,
           BezierHalves& halves) {
  const TriangleMesh& mesh = *geometry.mesh;
  auto& [first, second] = halves;
  const int degree = polygon.legs.count();
  for (LeggedPolygon* half : {&first, &second}) {
    half->points.resize(polygon.points.size());
    half->legs.resize(polygon.legs.size());
  }
  LeggedPolygon& row = workspace.row;
  row = polygon;
  first.points[0] = row.points.front();
  second.points[degree] = row.points.back();
  for (int k = 0; k < degree; ++k) {
    findAverages(
        mesh, [](int) { return 0.5; }, workspace);
    const SurfacePath& last = row.legs[degree - 1 - k];
    takePart(mesh, row.legs[0], 0, workspace.averages.front().at, first.legs[k]);
    takePart(mesh, last, workspace.averages.back().at, last.length(), second.legs[degree - 1 - k]);
    replaceByAverages(geometry, workspace);
    first.points[k + 1] = row.points.front();
    second.points[degree - 1 - k] = row.points.back();
  }
}

void takePolygon(const RefinedPolygon& refined, const SegmentLayout& piece,
                 LeggedPolygon& polygon) {
  polygon.points.clear();
  polygon.legs.resize(piece.points.size() - 1);
  for (int k = 0; k < piece.points.count(); ++k) {
    polygon.points.push_back(refined.points[piece.points[k]]);
    if (!refined.weighted) polygon.points.back().weight = 1;
    if (k > 0) polygon.legs[k - 1] = refined.legs[piece.points[k - 1]];
  }
}

SurfacePoint averageAt(const Geometry& geometry, const SegmentBasis& basis,
                       const LeggedPolygon& polygon, double t, AveragingWorkspace& workspace) {
  const int degree = polygon.legs.count();
  const auto knot = [&](int k) {
    return basis.form == BasisForm::kBSpline ? basis.numbers[k] : k - degree;
  };
  workspace.row = polygon;
  for (int row = 1; row <= degree; ++row) {
    const auto share = [&](int i) {
      if (basis.form == BasisForm::kBernstein) return t;
      const double left = knot(i + row);
      return (t - left) / (knot(i + degree + 1) - left);
    };
    findAverages(*geometry.mesh, share, workspace);
    replaceByAverages(geometry, workspace);
  }
  return workspace.row.points[0].point;
}

}  // namespace karcher

#include "curves/polygon/knot_insertion.h"

#include <algorithm>

#include "curves/spec/knots.h"

namespace karcher {
namespace {

int countOf(const ControlPolygon& polygon) { return polygon.points.count(); }

/// The span of a knot vector in which u lies (the last one if several are empty), and the index of
/// its knot.
struct KnotPlace {
  int place = 0;
  int span = 0;
};

KnotPlace placeOf(const ControlPolygon& polygon, double u) {
  const Array<double>& knots = polygon.knots;
  // The last knot of the vector that is at most u, as the number of a span.
  const auto last = knots.end() - (polygon.closed ? 2 : 1);
  const auto beyond = std::upper_bound(knots.begin(), last + 1, u);
  const int place = static_cast<int>(beyond - knots.begin());
  return {place, place - 1 - (polygon.closed ? 0 : polygon.degree)};
}

/// `insertKnot` for a closed curve of fewer than p points. New points extend more than once around,
/// so that the knots of several turns affect each of them. The curve is unrolled over these turns.
int insertAround(const Geometry& geometry, ControlPolygon& polygon, double u) {
  const int p = polygon.degree;
  const int n = countOf(polygon);
  const auto [place, span] = placeOf(polygon, u);
  const double period = polygon.knots.back() - polygon.knots.front();
  // The points of this turn and of later ones depend on no knots before the unrolled ones. One more
  // turn follows it.
  const int turn = (p + n) / (n + 1);
  const int turns = turn + 2;
  ControlPolygon open;
  open.degree = p;
  for (int i = 0; i < turns * n + p; ++i) open.points.push_back(polygon.points[i % n]);
  for (int j = -p; j <= turns * n + p; ++j) {
    open.knots.push_back(knotOfSpan(polygon.knots, p, true, j));
  }
  for (int k = 0; k < turns; ++k) insertKnot(geometry, open, u + k * period);
  const auto first = open.points.begin() + turn * (n + 1);
  polygon.points.assign(first, first + n + 1);
  polygon.knots.insert(polygon.knots.begin() + place, u);
  return (span + 1) % (n + 1);
}

/// Inserts u until the curve passes a control point there.
void insertFully(const Geometry& geometry, ControlPolygon& polygon, double u) {
  while (multiplicity(polygon, u) < polygon.degree) insertKnot(geometry, polygon, u);
}

}  // namespace

WeightedPoint average(const Geometry& geometry, const WeightedPoint& a, const WeightedPoint& b,
                      double s) {
  const double weight = (1 - s) * a.weight + s * b.weight;
  return {averageOf(geometry, a.point, b.point, s * b.weight / weight), weight};
}

int multiplicity(const ControlPolygon& polygon, double knot) {
  const Array<double>& knots = polygon.knots;
  // The last knot of a closed curve is its first.
  const auto end = knots.end() - (polygon.closed ? 1 : 0);
  const double period = polygon.closed ? knots.back() - knots.front() : 0;
  const double inside = polygon.closed && knot == knots.back() ? knot - period : knot;
  return static_cast<int>(std::count(knots.begin(), end, inside));
}

int insertKnot(const Geometry& geometry, ControlPolygon& polygon, double u) {
  const int p = polygon.degree;
  const int n = countOf(polygon);
  if (polygon.closed && n < p) return insertAround(geometry, polygon, u);
  const int repeats = multiplicity(polygon, u);
  const Array<double>& knots = polygon.knots;
  const auto [place, span] = placeOf(polygon, u);

  // Control point i depends on the knots of the spans i - p to i + 1.
  const auto knot = [&](int j) { return knotOfSpan(knots, p, polygon.closed, j); };
  const auto old = [&](int i) -> const WeightedPoint& {
    return polygon.points[polygon.closed ? ((i % n) + n) % n : i];
  };
  const auto renewed = [&](int i) {
    const double start = knot(i - p);
    return average(geometry, old(i - 1), old(i), (u - start) / (knot(i) - start));
  };
  const int first = span + 1;
  const int end = span + p - repeats;  // the number of the last new point
  Array<WeightedPoint> points(static_cast<size_t>(n) + 1);
  if (polygon.closed) {
    for (int i = first; i <= span + n + 1; ++i) {
      points[i % (n + 1)] = i <= end ? renewed(i) : old(i - 1);
    }
  } else {
    for (int i = 0; i <= n; ++i) {
      points[i] = i < first ? old(i) : i <= end ? renewed(i) : old(i - 1);
    }
  }
  polygon.points = std::move(points);
  polygon.knots.insert(polygon.knots.begin() + place, u);
  return first % (n + 1);
}

Array<WeightedPoint> elevated(const Geometry& geometry, const Array<WeightedPoint>& bezier) {
  const int n = bezier.count();
  Array<WeightedPoint> points{bezier[0]};
  for (int i = 1; i < n; ++i) {
    points.push_back(average(geometry, bezier[i], bezier[i - 1], static_cast<double>(i) / n));
  }
  points.push_back(bezier[n - 1]);
  return points;
}

BezierParts divided(const Geometry& geometry, const Array<WeightedPoint>& bezier, double t) {
  Array<WeightedPoint> level = bezier;
  BezierParts parts;
  parts.before.push_back(level.front());
  parts.after.push_back(level.back());
  while (level.count() > 1) {
    for (int i = 0; i + 1 < level.count(); ++i) {
      level[i] = average(geometry, level[i], level[i + 1], t);
    }
    level.pop_back();
    parts.before.push_back(level.front());
    parts.after.push_back(level.back());
  }
  std::reverse(parts.after.begin(), parts.after.end());
  return parts;
}

ControlPolygon partBefore(const Geometry& geometry, ControlPolygon open, double u) {
  insertFully(geometry, open, u);
  const auto first = std::lower_bound(open.knots.begin(), open.knots.end(), u);
  const int points = static_cast<int>(first - open.knots.begin());
  open.points.resize(static_cast<size_t>(points));
  open.knots.resize(static_cast<size_t>(points));
  open.knots.insert(open.knots.end(), static_cast<size_t>(open.degree) + 1, u);
  return open;
}

ControlPolygon partAfter(const Geometry& geometry, ControlPolygon open, double u) {
  insertFully(geometry, open, u);
  const auto beyond = std::upper_bound(open.knots.begin(), open.knots.end(), u);
  // The curve passes through the point before the last p of the knots.
  const int point = static_cast<int>(beyond - open.knots.begin()) - open.degree - 1;
  Array<double> knots(static_cast<size_t>(open.degree) + 1, u);
  knots.insert(knots.end(), beyond, open.knots.end());
  open.knots = std::move(knots);
  open.points.erase(open.points.begin(), open.points.begin() + point);
  return open;
}

ControlPolygon cutOpen(const Geometry& geometry, ControlPolygon closed, double u) {
  insertFully(geometry, closed, u);
  const int p = closed.degree;
  const int n = countOf(closed);
  const double period = closed.knots.back() - closed.knots.front();
  const double start = u == closed.knots.back() ? u - period : u;
  const auto beyond = std::upper_bound(closed.knots.begin(), closed.knots.end(), start);
  // The last span that starts there blends the points from its own number on.
  const int span = static_cast<int>(beyond - closed.knots.begin()) - 1;
  ControlPolygon open;
  open.degree = p;
  for (int i = span; i <= span + n; ++i) open.points.push_back(closed.points[i % n]);
  open.knots.assign(static_cast<size_t>(p) + 1, start);
  for (int j = span + 1; j <= span + n - p; ++j) {
    open.knots.push_back(knotOfSpan(closed.knots, p, true, j));
  }
  open.knots.insert(open.knots.end(), static_cast<size_t>(p) + 1, start + period);
  return open;
}

}  // namespace karcher

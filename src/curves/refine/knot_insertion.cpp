#include "curves/refine/knot_insertion.h"

#include <algorithm>
#include <utility>

#include "curves/spec/knots.h"
#include "intrinsic/straighten.h"

namespace karcher {
namespace {

int countOf(const ControlPolygon& polygon) { return polygon.points.count(); }

/// The index at which u enters the knot vector, and the index of the span in which u lies: the last
/// span that starts at or before u.
struct KnotPlace {
  int place = 0;
  int span = 0;
};

KnotPlace placeOf(const ControlPolygon& polygon, double u) {
  const Array<double>& knots = polygon.knots;
  // The last knot that is at most u starts the span. A closed curve's last knot starts none.
  const auto last = knots.end() - (polygon.closed ? 2 : 1);
  const auto beyond = std::upper_bound(knots.begin(), last + 1, u);
  const int place = static_cast<int>(beyond - knots.begin());
  return {place, place - 1 - (polygon.closed ? 0 : polygon.degree)};
}

/// Replaces a run of n legs by n + 1 new legs: from the run's start, through the average on each
/// old leg, to the run's end.
Array<SurfacePath> legsOver(const Geometry& geometry, const Array<SurfacePath>& run,
                            const Array<LegAverage>& averages) {
  const TriangleMesh& mesh = *geometry.mesh;
  StripWorkspace strip;
  Array<SurfacePath> legs(run.size() + 1);
  takePart(mesh, run.front(), 0, averages.front().at, legs.front());
  for (int i = 0; i + 1 < run.count(); ++i) {
    Chain chain(mesh, legs[i + 1]);
    chain.append(run[i], averages[i].at, run[i].length());
    chain.append(run[i + 1], 0, averages[i + 1].at);
    straighten(geometry, legs[i + 1], strip);
  }
  takePart(mesh, run.back(), averages.back().at, run.back().length(), legs.back());
  return legs;
}

/// `insertKnot` for a closed curve of fewer than p points. The new points go around the curve more
/// than once, so that each depends on the knots of several turns. The function unrolls the curve
/// over these turns.
int insertAround(const Geometry& geometry, ControlPolygon& polygon, double u) {
  const int p = polygon.degree;
  const int n = countOf(polygon);
  const auto [place, span] = placeOf(polygon, u);
  const double period = polygon.knots.back() - polygon.knots.front();
  // `turn` is the first turn whose points depend only on unrolled knots. One more turn follows it.
  const int turn = (p + n) / (n + 1);
  const int turns = turn + 2;
  ControlPolygon open;
  open.degree = p;
  for (int i = 0; i < turns * n + p; ++i) {
    if (i > 0) open.legs.push_back(polygon.legs[(i - 1) % n]);
    open.points.push_back(polygon.points[i % n]);
  }
  for (int j = -p; j <= turns * n + p; ++j) {
    open.knots.push_back(knotOfSpan(polygon.knots, p, true, j));
  }
  for (int k = 0; k < turns; ++k) insertKnot(geometry, open, u + k * period);
  const int first = turn * (n + 1);
  const int end = first + n + 1;
  polygon.points.assign(open.points.begin() + first, open.points.begin() + end);
  polygon.legs.assign(open.legs.begin() + first, open.legs.begin() + end);
  polygon.knots.insert(polygon.knots.begin() + place, u);
  return (span + 1) % (n + 1);
}

/// Inserts u until the curve passes through a control point there.
void insertFully(const Geometry& geometry, ControlPolygon& polygon, double u) {
  for (int k = multiplicity(polygon, u); k < polygon.degree; ++k) insertKnot(geometry, polygon, u);
}

}  // namespace

int multiplicity(const ControlPolygon& polygon, double knot) {
  const Array<double>& knots = polygon.knots;
  const auto repeats = std::count(knots.begin(), knots.end(), knot);
  if (!polygon.closed || knot != knots.front()) return static_cast<int>(repeats);
  // The last knot of a closed curve is its first.
  return static_cast<int>(repeats + std::count(knots.begin(), knots.end(), knots.back()) - 1);
}

int insertKnot(const Geometry& geometry, ControlPolygon& polygon, double u) {
  const int p = polygon.degree;
  const int n = countOf(polygon);
  if (polygon.closed && n < p) return insertAround(geometry, polygon, u);
  const int repeats = multiplicity(polygon, u);
  const auto [place, span] = placeOf(polygon, u);

  // Control point i depends on the knots of the spans i - p to i + 1. New point i, from `first` to
  // `end`, lies on the old leg from point i - 1 to point i.
  const auto knot = [&](int j) { return knotOfSpan(polygon.knots, p, polygon.closed, j); };
  const int first = span + 1;
  const int end = span + p - repeats;
  Array<SurfacePath> run;
  Array<LegAverage> averages;
  for (int i = first; i <= end; ++i) {
    const double s = (u - knot(i - p)) / (knot(i) - knot(i - p));
    run.push_back(polygon.legs[(i - 1) % n]);
    averages.push_back(averageOn(*geometry.mesh, run.back(),
                                 (1 - s) * polygon.points[(i - 1) % n].weight,
                                 s * polygon.points[i % n].weight));
  }
  Array<SurfacePath> renewed = legsOver(geometry, run, averages);
  Array<WeightedPoint> points(static_cast<size_t>(n) + 1);
  Array<SurfacePath> legs(polygon.legs.size() + 1);
  // On a closed curve, the loops begin at the new points.
  const int begin = polygon.closed ? first : 0;
  for (int i = begin; i < begin + n + 1; ++i) {
    points[i % (n + 1)] = i < first  ? polygon.points[i]
                          : i <= end ? averages[i - first].point
                                     : polygon.points[(i - 1) % n];
  }
  for (int i = polygon.closed ? first - 1 : 0, k = 0; k < legs.count(); ++i, ++k) {
    legs[i % (n + 1)] = i < first - 1 ? polygon.legs[i]
                        : i <= end    ? std::move(renewed[i - (first - 1)])
                                      : polygon.legs[(i - 1) % n];
  }
  polygon.points = std::move(points);
  polygon.legs = std::move(legs);
  polygon.knots.insert(polygon.knots.begin() + place, u);
  return first % (n + 1);
}

LeggedPolygon elevated(const Geometry& geometry, const LeggedPolygon& bezier) {
  const int n = bezier.points.count();
  Array<LegAverage> averages;
  LeggedPolygon result;
  result.points.push_back(bezier.points.front());
  for (int i = 1; i < n; ++i) {
    const double share = static_cast<double>(i) / n;
    averages.push_back(averageOn(*geometry.mesh, bezier.legs[i - 1],
                                 share * bezier.points[i - 1].weight,
                                 (1 - share) * bezier.points[i].weight));
    result.points.push_back(averages.back().point);
  }
  result.points.push_back(bezier.points.back());
  result.legs = legsOver(geometry, bezier.legs, averages);
  return result;
}

ControlPolygon partBefore(const Geometry& geometry, ControlPolygon open, double u) {
  insertFully(geometry, open, u);
  const auto first = std::lower_bound(open.knots.begin(), open.knots.end(), u);
  const int points = static_cast<int>(first - open.knots.begin());
  open.points.resize(static_cast<size_t>(points));
  open.legs.resize(static_cast<size_t>(points) - 1);
  open.knots.resize(static_cast<size_t>(points));
  open.knots.insert(open.knots.end(), static_cast<size_t>(open.degree) + 1, u);
  return open;
}

ControlPolygon partAfter(const Geometry& geometry, ControlPolygon open, double u) {
  insertFully(geometry, open, u);
  const auto beyond = std::upper_bound(open.knots.begin(), open.knots.end(), u);
  // At u the curve passes through a control point. Its index is p less than the index of the last
  // knot u.
  const int point = static_cast<int>(beyond - open.knots.begin()) - open.degree - 1;
  Array<double> knots(static_cast<size_t>(open.degree) + 1, u);
  knots.insert(knots.end(), beyond, open.knots.end());
  open.knots = std::move(knots);
  open.points.erase(open.points.begin(), open.points.begin() + point);
  open.legs.erase(open.legs.begin(), open.legs.begin() + point);
  return open;
}

ControlPolygon cutOpen(const Geometry& geometry, ControlPolygon closed, double u) {
  insertFully(geometry, closed, u);
  const int p = closed.degree;
  const int n = countOf(closed);
  const double period = closed.knots.back() - closed.knots.front();
  const auto beyond = std::upper_bound(closed.knots.begin(), closed.knots.end(), u);
  // The last span that starts at u blends the points from index `span` on.
  const int span = static_cast<int>(beyond - closed.knots.begin()) - 1;
  ControlPolygon open;
  open.degree = p;
  for (int i = span; i <= span + n; ++i) open.points.push_back(closed.points[i % n]);
  for (int i = span; i < span + n; ++i) open.legs.push_back(closed.legs[i % n]);
  open.knots.assign(static_cast<size_t>(p) + 1, u);
  for (int j = span + 1; j <= span + n - p; ++j) {
    open.knots.push_back(knotOfSpan(closed.knots, p, true, j));
  }
  open.knots.insert(open.knots.end(), static_cast<size_t>(p) + 1, u + period);
  return open;
}

}  // namespace karcher

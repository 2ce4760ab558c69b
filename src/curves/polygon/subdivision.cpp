#include "curves/polygon/subdivision.h"

#include <utility>

#include "curves/polygon/knot_insertion.h"
#include "intrinsic/straightest.h"
#include "intrinsic/strip_path.h"

namespace karcher {
namespace {

constexpr int kDeepest = 6;
/// Parts of a curve shorter than this, in mean edges, are not cut any more.
constexpr double kShortest = 0.25;
/// Weights below this count for nothing: the points of a long Bezier curve far from the parameter.
constexpr double kNegligible = 1e-9;

/// The average of both, with the sum of their weights.
WeightedPoint merged(const Geometry& geometry, const WeightedPoint& a, const WeightedPoint& b) {
  const double sum = a.weight + b.weight;
  return {averageAlongGeodesic(geometry, a.point, b.point, b.weight / sum), sum};
}

/// The average of points of positive weight, from both ends of the list.
WeightedPoint foldedFromEnds(const Geometry& geometry, const Array<WeightedPoint>& points) {
  int left = 0;
  int right = points.count() - 1;
  if (left == right) return points[0];
  WeightedPoint first = points[left];
  WeightedPoint last = points[right];
  while (++left < --right) {
    first = merged(geometry, first, points[left]);
    last = merged(geometry, last, points[right]);
  }
  if (left == right) {
    const WeightedPoint half{points[left].point, points[left].weight / 2};
    first = merged(geometry, first, half);
    last = merged(geometry, last, half);
  }
  return merged(geometry, first, last);
}

using Polygon = Array<SurfacePath>;  ///< its edges

double lengthOf(const Polygon& polygon) {
  double sum = 0;
  for (const SurfacePath& edge : polygon) sum += edge.length();
  return sum;
}

/// De Casteljau's triangle at 1/2. Halves of shortest paths are shortest paths, so the edges of
/// both polygons are there already; only those inside the triangle are searched for.
std::pair<Polygon, Polygon> split(const Geometry& geometry, const Polygon& polygon) {
  const TriangleMesh& mesh = *geometry.mesh;
  std::pair<Polygon, Polygon> parts;
  Polygon level = polygon;
  while (!level.empty()) {
    Array<LineHalves> halves;
    for (const SurfacePath& edge : level) halves.push_back(halvesOf(mesh, edge));
    Polygon inner;
    for (int i = 1; i < halves.count(); ++i) {
      inner.push_back(
          geodesicLine(geometry, halves[i - 1].second.points[0], halves[i].second.points[0]));
    }
    parts.first.push_back(std::move(halves.front().first));
    parts.second.insert(parts.second.begin(), std::move(halves.back().second));
    level = std::move(inner);
  }
  return parts;
}

void appendPolygon(const Polygon& polygon, double t0, double t1, ParametricLine& line) {
  const double step = (t1 - t0) / polygon.count();
  SurfacePath& path = line.path;
  for (int i = 0; i < polygon.count(); ++i) {
    const SurfacePath& edge = polygon[i];
    const double before = path.points.empty() ? 0 : path.length();
    for (int k = path.points.empty() ? 0 : 1; k < edge.points.count(); ++k) {
      const double part = edge.length() > 0 ? edge.lengths[k] / edge.length() : 1;
      path.points.push_back(edge.points[k]);
      path.lengths.push_back(before + edge.lengths[k]);
      line.t.push_back(
          k + 1 == edge.points.count() && i + 1 == polygon.count() ? t1 : t0 + (i + part) * step);
    }
  }
}

void subdivide(const Geometry& geometry, const Polygon& polygon, double t0, double t1, int depth,
               ParametricLine& line) {
  if (depth == kDeepest || polygon.count() == 1 ||
      lengthOf(polygon) < kShortest * geometry.meanEdge) {
    appendPolygon(polygon, t0, t1, line);
    return;
  }
  const auto [left, right] = split(geometry, polygon);
  const double middle = (t0 + t1) / 2;
  subdivide(geometry, left, t0, middle, depth + 1, line);
  subdivide(geometry, right, middle, t1, depth + 1, line);
}

}  // namespace

SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (s < 0) return averageAlongGeodesic(geometry, b, a, 1 - s);
  const SurfacePath line = geodesicLine(geometry, a, b);
  if (s <= 1) return pointAlong(mesh, line, s * line.length());
  // On from b, in the direction of the last piece.
  for (int i = line.points.count() - 2; i >= 0; --i) {
    if (line.lengths[i] == line.length()) continue;
    const int face = commonFace(mesh, line.points[i], b);
    const SurfacePoint end = inFace(mesh, b, face);
    const Vec2 piece =
        pointInFace(geometry, end) - pointInFace(geometry, inFace(mesh, line.points[i], face));
    const Vec2 vector = (s - 1) * line.length() * piece.normalized();
    return traceStraightest(geometry, end, vector).path.end();
  }
  return b;
}

SurfacePoint repeatedAverage(const Geometry& geometry, const Array<SurfacePoint>& points,
                             const Array<double>& weights) {
  Array<WeightedPoint> positive;
  Array<WeightedPoint> negative;
  for (int i = 0; i < points.count(); ++i) {
    if (weights[i] > kNegligible) positive.push_back({points[i], weights[i]});
    if (weights[i] < -kNegligible) negative.push_back({points[i], -weights[i]});
  }
  const WeightedPoint average = foldedFromEnds(geometry, positive);
  if (negative.empty()) return average.point;
  const WeightedPoint away = foldedFromEnds(geometry, negative);
  return averageAlongGeodesic(geometry, away.point, average.point, 1 + away.weight);
}

void appendBezier(const Geometry& geometry, const Array<SurfacePoint>& points, double t0, double t1,
                  ParametricLine& line) {
  Polygon polygon;
  for (int i = 1; i < points.count(); ++i) {
    polygon.push_back(geodesicLine(geometry, points[i - 1], points[i]));
  }
  subdivide(geometry, polygon, t0, t1, 0, line);
}

}  // namespace karcher

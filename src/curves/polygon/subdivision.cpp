#include "curves/polygon/subdivision.h"

#include "mesh/rounding.h"

namespace karcher {
namespace {

/// A part is not halved if its control polygon is shorter than this, in mean edges.
constexpr double kShortest = 0.25;
constexpr int kMostHalvings = 6;

/// The average of two points, with the sum of their weights.
WeightedPoint merged(const Geometry& geometry, const WeightedPoint& a, const WeightedPoint& b,
                     SubdivisionWorkspace& workspace) {
  const double sum = a.weight + b.weight;
  return {averageAlongGeodesic(geometry, a.point, b.point, b.weight / sum, workspace), sum};
}

/// The average of points of positive weight, from both ends of the list towards its middle.
WeightedPoint foldedFromEnds(const Geometry& geometry, const Array<WeightedPoint>& points,
                             SubdivisionWorkspace& workspace) {
  int left = 0;
  int right = points.count() - 1;
  if (left == right) return points[0];
  WeightedPoint first = points[left];
  WeightedPoint last = points[right];
  while (++left < --right) {
    first = merged(geometry, first, points[left], workspace);
    last = merged(geometry, last, points[right], workspace);
  }
  if (left == right) {
    const WeightedPoint half{points[left].point, points[left].weight / 2};
    first = merged(geometry, first, half, workspace);
    last = merged(geometry, last, half, workspace);
  }
  return merged(geometry, first, last, workspace);
}

double lengthOf(const Array<SurfacePath>& legs) {
  double sum = 0;
  for (const SurfacePath& leg : legs) sum += leg.length();
  return sum;
}

void appendPolygon(const Array<SurfacePath>& legs, double t0, double t1, ParametricLine& line) {
  const int count = legs.count();
  const double step = (t1 - t0) / count;
  SurfacePath& path = line.path;
  for (int i = 0; i < count; ++i) {
    const SurfacePath& leg = legs[i];
    const double before = path.points.empty() ? 0 : path.length();
    for (int k = path.points.empty() ? 0 : 1; k < leg.points.count(); ++k) {
      const double part = leg.length() > 0 ? leg.lengths[k] / leg.length() : 1;
      path.points.push_back(leg.points[k]);
      path.lengths.push_back(before + leg.lengths[k]);
      line.t.push_back(k + 1 == leg.points.count() && i + 1 == count ? t1 : t0 + (i + part) * step);
    }
  }
}

void subdivide(const Geometry& geometry, const LeggedPolygon& polygon, double t0, double t1,
               int halvings, AveragingWorkspace& workspace, ParametricLine& line) {
  if (halvings == kMostHalvings || polygon.legs.count() == 1 ||
      lengthOf(polygon.legs) < kShortest * geometry.meanEdge) {
    appendPolygon(polygon.legs, t0, t1, line);
    return;
  }
  BezierHalves& halves = workspace.halves[halvings];
  halve(geometry, polygon, workspace, halves);
  const double middle = (t0 + t1) / 2;
  subdivide(geometry, halves.first, t0, middle, halvings + 1, workspace, line);
  subdivide(geometry, halves.second, middle, t1, halvings + 1, workspace, line);
}

}  // namespace

SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s,
                                  SubdivisionWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (s < 0) return averageAlongGeodesic(geometry, b, a, 1 - s, workspace);
  SurfacePath& line = workspace.line;
  // The points lie on one component.
  findPath(geometry, a, b, workspace.paths, line);
  if (s <= 1) return pointAlong(mesh, line, s * line.length());
  // The path continues from b in the direction of the last piece.
  for (int i = line.points.count() - 2; i >= 0; --i) {
    if (line.lengths[i] == line.length()) continue;
    const int face = commonFace(mesh, line.points[i], b);
    const SurfacePoint end = inFace(mesh, b, face);
    const Vec2 piece = stepInFace(geometry, face, line.points[i], end);
    const Vec2 vector = (s - 1) * line.length() * piece.normalized();
    traceStraightest(geometry, end, vector, workspace.beyond);
    return workspace.beyond.path.end();
  }
  return b;
}

SurfacePoint repeatedAverage(const Geometry& geometry, const Array<SurfacePoint>& points,
                             const Array<double>& weights, SubdivisionWorkspace& workspace) {
  Array<WeightedPoint>& positive = workspace.positive;
  Array<WeightedPoint>& negative = workspace.negative;
  positive.clear();
  negative.clear();
  // Points of almost no weight are left out. A Bezier curve of many points has many of them.
  for (int i = 0; i < points.count(); ++i) {
    if (weights[i] > kChainRounding) positive.push_back({points[i], weights[i]});
    if (weights[i] < -kChainRounding) negative.push_back({points[i], -weights[i]});
  }
  const WeightedPoint average = foldedFromEnds(geometry, positive, workspace);
  if (negative.empty()) return average.point;
  const WeightedPoint away = foldedFromEnds(geometry, negative, workspace);
  return averageAlongGeodesic(geometry, away.point, average.point, 1 + away.weight, workspace);
}

void appendBezier(const Geometry& geometry, std::span<const SurfacePoint> points, double t0,
                  double t1, SubdivisionWorkspace& workspace, ParametricLine& line) {
  LeggedPolygon& polygon = workspace.polygon;
  polygon.points.clear();
  for (const SurfacePoint& point : points) polygon.points.push_back({point});
  polygon.legs.resize(points.size() - 1);
  for (size_t i = 1; i < points.size(); ++i) {
    findPath(geometry, points[i - 1], points[i], workspace.paths, polygon.legs.data()[i - 1]);
  }
  workspace.averaging.halves.resize(static_cast<size_t>(kMostHalvings));
  subdivide(geometry, polygon, t0, t1, 0, workspace.averaging, line);
}

}  // namespace karcher

#include "curves/polygon/subdivision.h"

#include <utility>

#include "intrinsic/strip_path.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// Parts of a curve shorter than this, in mean edges, are not divided further.
constexpr double kShortest = 0.25;

/// The average of two points, with the sum of their weights.
WeightedPoint merged(const Geometry& geometry, const WeightedPoint& a, const WeightedPoint& b,
                     SubdivisionWorkspace& workspace) {
  const double sum = a.weight + b.weight;
  return {averageAlongGeodesic(geometry, a.point, b.point, b.weight / sum, workspace), sum};
}

/// The average of points of positive weight, taken from both ends of the list.
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

using Polygon = std::span<const SurfacePath>;  ///< a polygon's edges

double lengthOf(const Polygon& polygon) {
  double sum = 0;
  for (const SurfacePath& edge : polygon) sum += edge.length();
  return sum;
}

/// The first edges of a list, which is enlarged if needed.
template <class T>
std::span<T> firstOf(Array<T>& edges, size_t count) {
  if (edges.size() < count) edges.resize(count);
  return {edges.data(), count};
}

/// De Casteljau's triangle at 1/2. Halves of shortest paths are shortest paths, so that the edges
/// of both polygons are known and only those inside the triangle need a search.
void split(const Geometry& geometry, const Polygon& polygon, SubdivisionWorkspace& workspace,
           SubdivisionWorkspace::Parts& parts) {
  const size_t edges = polygon.size();
  const std::span<SurfacePath> first = firstOf(parts.first, edges);
  const std::span<SurfacePath> second = firstOf(parts.second, edges);
  const std::span<SurfacePath> row = firstOf(workspace.row, edges);
  const std::span<LineHalves> halves = firstOf(workspace.halves, edges);
  for (size_t count = edges; count > 0; --count) {
    const Polygon level = count == edges ? polygon : row.first(count);
    for (size_t i = 0; i < count; ++i) halve(*geometry.mesh, level[i], halves[i]);
    for (size_t i = 1; i < count; ++i) {
      geodesicLine(geometry, halves[i - 1].second.points[0], halves[i].second.points[0],
                   workspace.geodesics, row[i - 1]);
    }
    std::swap(first[edges - count], halves[0].first);
    std::swap(second[count - 1], halves[count - 1].second);
  }
}

void appendPolygon(const Polygon& polygon, double t0, double t1, ParametricLine& line) {
  const int edges = static_cast<int>(polygon.size());
  const double step = (t1 - t0) / edges;
  SurfacePath& path = line.path;
  for (int i = 0; i < edges; ++i) {
    const SurfacePath& edge = polygon[static_cast<size_t>(i)];
    const double before = path.points.empty() ? 0 : path.length();
    for (int k = path.points.empty() ? 0 : 1; k < edge.points.count(); ++k) {
      const double part = edge.length() > 0 ? edge.lengths[k] / edge.length() : 1;
      path.points.push_back(edge.points[k]);
      path.lengths.push_back(before + edge.lengths[k]);
      line.t.push_back(k + 1 == edge.points.count() && i + 1 == edges ? t1
                                                                      : t0 + (i + part) * step);
    }
  }
}

void subdivide(const Geometry& geometry, const Polygon& polygon, double t0, double t1, int depth,
               SubdivisionWorkspace& workspace, ParametricLine& line) {
  if (depth == SubdivisionWorkspace::kDeepest || polygon.size() == 1 ||
      lengthOf(polygon) < kShortest * geometry.meanEdge) {
    appendPolygon(polygon, t0, t1, line);
    return;
  }
  SubdivisionWorkspace::Parts& parts = workspace.parts[static_cast<size_t>(depth)];
  split(geometry, polygon, workspace, parts);
  const double middle = (t0 + t1) / 2;
  subdivide(geometry, firstOf(parts.first, polygon.size()), t0, middle, depth + 1, workspace, line);
  subdivide(geometry, firstOf(parts.second, polygon.size()), middle, t1, depth + 1, workspace,
            line);
}

}  // namespace

SurfacePoint averageAlongGeodesic(const Geometry& geometry, const SurfacePoint& a,
                                  const SurfacePoint& b, double s,
                                  SubdivisionWorkspace& workspace) {
  const TriangleMesh& mesh = *geometry.mesh;
  if (s < 0) return averageAlongGeodesic(geometry, b, a, 1 - s, workspace);
  SurfacePath& line = workspace.line;
  geodesicLine(geometry, a, b, workspace.geodesics, line);
  if (s <= 1) return pointAlong(mesh, line, s * line.length());
  // The path continues from b in the direction of the last piece.
  for (int i = line.points.count() - 2; i >= 0; --i) {
    if (line.lengths[i] == line.length()) continue;
    const int face = commonFace(mesh, line.points[i], b);
    const SurfacePoint end = inFace(mesh, b, face);
    const Vec2 piece =
        pointInFace(geometry, end) - pointInFace(geometry, inFace(mesh, line.points[i], face));
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
  // A Bezier curve of many points gives those far from the parameter almost no weight.
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
  const std::span<SurfacePath> polygon = firstOf(workspace.polygon, points.size() - 1);
  for (size_t i = 1; i < points.size(); ++i) {
    geodesicLine(geometry, points[i - 1], points[i], workspace.geodesics, polygon[i - 1]);
  }
  subdivide(geometry, polygon, t0, t1, 0, workspace, line);
}

}  // namespace karcher

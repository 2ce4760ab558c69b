#include "generators/plane.h"

#include <algorithm>

#include "generators/delaunay.h"
#include "generators/grid.h"
#include "generators/random.h"

namespace karcher {
namespace {

constexpr double kStretch = 20;

/// A grid of columns x rows cells of size 1.
struct Grid {
  int columns;
  int rows;

  /// A square full of cells that are `stretch` times as wide as high.
  Grid(int triangles, double stretch)
      : columns(std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / (2 * stretch)))))),
        rows(std::max(2, static_cast<int>(std::lround(triangles / (2.0 * columns))))) {}

  /// The vertices, row by row; inner ones move by up to `jitter` along each axis.
  Array<Vec2> vertices(double jitter, Random& random) const {
    Array<Vec2> result;
    for (int j = 0; j <= rows; ++j) {
      for (int i = 0; i <= columns; ++i) {
        const bool inside = i > 0 && i < columns && j > 0 && j < rows;
        const double dx = inside ? random.uniform(-jitter, jitter) : 0;
        const double dy = inside ? random.uniform(-jitter, jitter) : 0;
        result.emplace_back(i + dx, j + dy);
      }
    }
    return result;
  }

  Array<Vec2> randomVertices(Random& random) const {
    Array<Vec2> result = vertices(0, random);
    for (int j = 1; j < rows; ++j) {
      for (int i = 1; i < columns; ++i) {
        const double x = random.uniform(0, columns);
        const double y = random.uniform(0, rows);
        result[j * (columns + 1) + i] = {x, y};
      }
    }
    return result;
  }
};

}  // namespace

const char* tessellationName(PlaneTessellation tessellation) {
  switch (tessellation) {
    case PlaneTessellation::kRandomDelaunay:
      return "Delaunay of random points";
    case PlaneTessellation::kJitteredDelaunay:
      return "Delaunay of a jittered grid";
    case PlaneTessellation::kRegularGrid:
      return "regular quad grid";
    case PlaneTessellation::kStretched:
      return "stretched 20:1";
    case PlaneTessellation::kStretchedSheared:
      return "stretched 20:1 and sheared";
    case PlaneTessellation::kStretchedRandom:
      return "20:1 jittered grid, random diagonals";
  }
  return "unknown";
}

TriangleSoup tessellatedPlane(PlaneTessellation tessellation, int triangles, uint64_t seed) {
  Random random(seed);
  const bool stretched = tessellation >= PlaneTessellation::kStretched;
  const Grid grid(triangles, stretched ? kStretch : 1);
  Array<Vec2> points;
  TriangleSoup soup;
  switch (tessellation) {
    case PlaneTessellation::kRandomDelaunay:
      points = grid.randomVertices(random);
      soup.triangles = delaunay(points);
      break;
    case PlaneTessellation::kJitteredDelaunay:
    case PlaneTessellation::kStretched:
    case PlaneTessellation::kStretchedSheared:
      points = grid.vertices(0.35, random);
      soup.triangles = delaunay(points);
      break;
    case PlaneTessellation::kRegularGrid:
      points = grid.vertices(0, random);
      soup.triangles = gridTriangles(grid.columns, grid.rows, [](int, int) { return true; });
      break;
    case PlaneTessellation::kStretchedRandom:
      // A jitter under a quarter keeps every cell convex.
      points = grid.vertices(0.2, random);
      soup.triangles =
          gridTriangles(grid.columns, grid.rows, [&](int, int) { return random.uniform() < 0.5; });
      break;
  }
  const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
  for (const Vec2& p : points) {
    const double y = p.y() / grid.rows;
    soup.positions.emplace_back(p.x() / grid.columns + shear * y, y, 0);
  }
  return soup;
}

}  // namespace karcher

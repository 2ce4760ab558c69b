#include <cstdio>
#include <ctime>

#include "bench_support.h"
#include "distance/find_path.h"
#include "generators/random_points.h"
#include "intrinsic/straightest.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "regions/region.h"

/// What cells and regions of random closed polygons take on a sphere and a torus of 70,000
/// triangles: their crossings with one another, and the least time of five, of the processor, so
/// that what else runs does not count.
namespace karcher {
namespace {

template <class Work>
double processorTime(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A polygon of eight corners round a random point.
SurfacePath randomPolygon(const Geometry& geometry, Random& random) {
  constexpr int kCorners = 8;
  const SurfacePoint middle = randomPoint(*geometry.mesh, random);
  FindPathWorkspace workspace;
  SurfacePath leg;
  SurfacePath path;
  Array<SurfacePoint> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double radius = geometry.extent * random.uniform(0.1, 0.3);
    const Vec2 way = radius * unitVector(2 * kPi * i / kCorners);
    corners.push_back(traceStraightest(geometry, middle, way).path.end());
  }
  for (int i = 0; i < kCorners; ++i) {
    findPath(geometry, corners[i], corners[(i + 1) % kCorners], workspace, leg);
    for (const SurfacePoint& point : leg.points) appendPoint(*geometry.mesh, point, path);
  }
  return path;
}

/// Vertices inside faces at which four lines meet.
int crossingsOf(const Arrangement& all) {
  Array<int> lines(all.added.size(), 0);
  for (int i = 0; i < all.uses.count(); ++i) {
    const int h = all.uses[i].halfedge;
    if (i > 0 && all.uses[i - 1].halfedge == h) continue;
    for (const int vertex : {all.tail[h], all.head(h)}) {
      if (vertex >= all.meshVertices) ++lines[vertex - all.meshVertices];
    }
  }
  int count = 0;
  for (const int n : lines) count += n >= 4;
  return count;
}

void study(Shape shape, int polygons) {
  const ImportedMesh imported = importMesh(makeShape(shape, 70'000));
  const Geometry geometry = buildGeometry(imported.mesh);
  Random random(7);
  Array<SurfacePath> paths;
  for (int i = 0; i < polygons; ++i) paths.push_back(randomPolygon(geometry, random));
  double cells = kInfinity;
  double regions = kInfinity;
  Arrangement all;
  for (int i = 0; i < 5; ++i) {
    cells = std::min(cells, processorTime([&] { all = arrange(geometry, paths); }));
    regions = std::min(regions, processorTime([&] {
                         const Region region = enclosed(all, {0, all.paths}, FillRule::kEvenOdd);
                         boundaryOf(all, region);
                       }));
  }
  std::printf(
      "%-8s %6d triangles, %3d curves, %5d crossings, %5d cells: cells %6.2f ms, "
      "region and boundary %6.2f ms\n",
      shapeName(shape), imported.mesh.faceCount(), polygons, crossingsOf(all), all.cellCount(),
      cells, regions);
}

}  // namespace
}  // namespace karcher

int main() {
  using karcher::Shape;
  for (const int polygons : {4, 16, 55}) {
    for (const Shape shape : {Shape::kSphere, Shape::kTorus}) karcher::study(shape, polygons);
  }
}

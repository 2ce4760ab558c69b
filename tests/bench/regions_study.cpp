#include <cstdio>
#include <ctime>
#include <string>

#include "bench_support.h"
#include "distance/find_path.h"
#include "generators/random_points.h"
#include "intrinsic/straightest.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "regions/cut.h"
#include "regions/region.h"

/// The processor time of cells, regions and cuts along random closed polygons on spheres and tori
/// of 70,000 and a million triangles, beside its limit. It is the least of five or two runs, which
/// other programs disturb little.
namespace karcher {
namespace {

template <class Work>
double processorTime(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// A polygon of eight corners around a random point.
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

struct Crossings {
  int edges = 0;  // crossings of curves with edges of the mesh
  int lines = 0;  // crossings of curves: vertices inside faces at which four lines meet
};

Crossings crossingsOf(const Arrangement& all) {
  Crossings crossings;
  Array<int> lines(all.added.size(), 0);
  for (int i = 0; i < all.uses.count(); ++i) {
    const int h = all.uses[i].halfedge;
    if (i > 0 && all.uses[i - 1].halfedge == h) continue;
    for (const int vertex : {all.tail[h], all.head(h)}) {
      if (vertex >= all.meshVertices) ++lines[vertex - all.meshVertices];
    }
  }
  for (const int n : lines) crossings.lines += n >= 4;
  for (const DrawnVertex& vertex : all.added) crossings.edges += vertex.halfedge >= 0;
  return crossings;
}

/// The largest allowed time of a row, in milliseconds; 0 without a limit.
struct Asked {
  double cells = 0;
  double cut = 0;
};

std::string beside(double milliseconds, double asked) {
  char text[64];
  std::snprintf(text, sizeof text, asked > 0 ? "%.1f ms (asked %.0f)" : "%.1f ms", milliseconds,
                asked);
  return text;
}

void study(Shape shape, int triangles, int polygons, const Asked& asked) {
  const ImportedMesh imported = importMesh(makeShape(shape, triangles));
  const Geometry geometry = buildGeometry(imported.mesh);
  Random random(7);
  Array<SurfacePath> paths;
  for (int i = 0; i < polygons; ++i) paths.push_back(randomPolygon(geometry, random));
  double cells = kInfinity;
  double regions = kInfinity;
  double cut = kInfinity;
  Arrangement all;
  int parts = 0;
  const int rounds = triangles > 500'000 ? 2 : 5;
  for (int i = 0; i < rounds; ++i) {
    cells = std::min(cells, processorTime([&] { all = arrange(geometry, paths); }));
    regions = std::min(regions, processorTime([&] {
                         const Region region = enclosed(all, {0, all.paths}, FillRule::kEvenOdd);
                         boundaryOf(all, region);
                       }));
    cut = std::min(cut, processorTime([&] {
                     parts = partsOf(cutApart(geometry, all), all.cellCount()).count();
                   }));
  }
  const Crossings crossings = crossingsOf(all);
  std::printf("%s, %d triangles, %d curves, %d crossings with edges, %d with each other: ",
              shapeName(shape), imported.mesh.faceCount(), polygons, crossings.edges,
              crossings.lines);
  std::printf("%d cells %s, region and boundary %.1f ms, %d parts %s\n", all.cellCount(),
              beside(cells, asked.cells).c_str(), regions, parts, beside(cut, asked.cut).c_str());
  std::fflush(stdout);
}

}  // namespace
}  // namespace karcher

int main() {
  using karcher::Shape;
  for (const Shape shape : {Shape::kSphere, Shape::kTorus}) {
    karcher::study(shape, 70'000, 4, {.cells = 20});
    karcher::study(shape, 70'000, 16, {});
    karcher::study(shape, 70'000, 55, {});
    karcher::study(shape, 1'000'000, 100, {.cells = 1000, .cut = 3000});
  }
}

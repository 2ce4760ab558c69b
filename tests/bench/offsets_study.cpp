#include <cmath>
#include <cstdio>
#include <string>

#include "bench_support.h"
#include "curves/offset.h"
#include "distance/path_distance.h"
#include "distance/shortest_path.h"
#include "generators/random.h"
#include "generators/region_drawings.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"

/// The deviation of offsets from their distance, as a part of it: the exact distance from the curve
/// less the offset's, at the points of each line and between them. The exact distance is that of
/// the curve's field. At some points it is the shortest of exact paths to points all along the
/// curve.
///
///   offsets_study [MESH.obj ...]
namespace karcher {
namespace {

/// Distances as parts of the bounding box's diagonal.
constexpr double kDistances[] = {0.002, 0.01, 0.03};
constexpr int kCurves = 3;
constexpr int kChecked = 4;
/// The number of samples of a curve for each distance of the offset along it: the nearest one finds
/// the nearest place.
constexpr int kAlong = 10;

/// A closed polygon of geodesics around a place.
SurfacePath randomPolygon(const Geometry& geometry, Random& random) {
  const SurfacePoint middle = randomPoint(*geometry.mesh, random);
  Array<SurfacePoint> corners;
  for (int i = 0; i < 7; ++i) {
    const double radius = geometry.diagonal * random.uniform(0.05, 0.15);
    corners.push_back(
        traceStraightest(geometry, middle, radius * unitVector(2 * kPi * i / 7)).path.end());
  }
  return chain(geometry, corners, true);
}

struct Row {
  int lines = 0;
  int points = 0;
  double largest = 0;
  double sum = 0;
  double otherwise = 0;  ///< the largest deviation by shortest paths
  double milliseconds = 0;
};

void add(const Geometry& geometry, const SurfacePath& curve, double distance, Random& random,
         Row& row) {
  Array<Isoline> lines;
  row.milliseconds += processorTimed(
      [&] { lines = offsetLines(geometry, std::span(&curve, 1), distance, OffsetSide::kBoth); });
  const PathDistance field(geometry, std::span(&curve, 1), 1.5 * distance);
  const auto measure = [&](const SurfacePoint& point) {
    const double off = std::abs(field.at(point).value - distance) / distance;
    row.largest = std::max(row.largest, off);
    row.sum += off;
    ++row.points;
  };
  for (const Isoline& line : lines) {
    ++row.lines;
    measure(line.points[0]);
    for (int i = 1; i < line.points.count(); ++i) {
      measure(line.points[i]);
      for (const double part : {0.25, 0.5, 0.75}) {
        measure(pointBetween(*geometry.mesh, line.points[i - 1], line.points[i], part));
      }
    }
  }
  for (int i = 0; i < kChecked && !lines.empty(); ++i) {
    const Array<SurfacePoint>& points = lines[random.index(lines.count())].points;
    const SurfacePoint point = points[random.index(points.count())];
    const int samples = static_cast<int>(std::ceil(kAlong * curve.length() / distance));
    const double step = curve.length() / samples;
    double nearest = 0;
    double least = kInfinity;
    const auto look = [&](double length) {
      const SurfacePoint on = pointAlong(*geometry.mesh, curve, length);
      // Distances in space are at most those of paths, so that most points need no path.
      const Vec3 away = position(*geometry.mesh, on) - position(*geometry.mesh, point);
      if (away.norm() > std::min(least, 1.5 * distance)) return;
      const double found = shortestPath(geometry, point, on).length();
      if (found < least) nearest = length;
      least = std::min(least, found);
    };
    for (int k = 0; k < samples; ++k) look(k * step);
    for (double part = step / 2; part > 1e-5 * distance; part /= 2) {
      const double middle = nearest;
      look(middle - part);
      look(middle + part);
    }
    row.otherwise = std::max(row.otherwise, std::abs(least - distance) / distance);
  }
}

void study(const std::string& name, const TriangleMesh& mesh) {
  const Geometry geometry = buildGeometry(mesh);
  for (const double part : kDistances) {
    const double distance = part * geometry.diagonal;
    Random random(5);
    Row row;
    std::string refused;
    for (int i = 0; i < kCurves; ++i) {
      try {
        add(geometry, randomPolygon(geometry, random), distance, random, row);
      } catch (const Error& error) {
        refused = error.what();
      }
    }
    std::printf("| %s | %d | %.3f | %.2f | %d | %.1e | %.1e | %.1e | %.0f | %s |\n", name.c_str(),
                mesh.faceCount(), part, distance / geometry.meanEdge, row.lines,
                row.sum / std::max(row.points, 1), row.largest, row.otherwise,
                row.milliseconds / kCurves, refused.c_str());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace karcher

int main(int argc, char** argv) {
  std::printf(
      "| mesh | triangles | distance | in mean edges | lines | mean error | largest | beside exact "
      "paths | ms an offset | refused |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  karcher::forEachMesh({argv + 1, argv + argc},
                       [](const std::string& name, const karcher::TriangleMesh& mesh, bool) {
                         karcher::study(name, mesh);
                       });
}

#include "distance/exact_lengths.h"

#include <gtest/gtest.h>

#include "distance/shortest_path.h"
#include "generators/random_points.h"
#include "measures/allocations.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

TEST(ExactLengths, AreThoseOfShortestPathsWhateverIsLikely) {
  const TriangleMesh mesh = importMesh(icosphere(12)).mesh;
  const Geometry geometry = buildGeometry(mesh);
  Random random(271127);
  const SurfacePoint source = randomPlace(mesh, random);
  Array<SurfacePoint> points;
  for (int i = 0; i < 20; ++i) points.push_back(randomPlace(mesh, random));
  for (const double likely : {1e-3, 0.5, 2.0, 4.0}) {
    const Array<double> lengths = exactLengths(geometry, source, points, likely);
    for (int i = 0; i < points.count(); ++i) {
      EXPECT_NEAR(lengths[i], shortestPath(geometry, source, points[i]).length(), 1e-12);
    }
  }
}

TEST(ExactLengths, SearchNoFartherThanTheyNeed) {
  const TriangleMesh mesh = importMesh(icosphere(60)).mesh;
  const Geometry geometry = buildGeometry(mesh);
  const SurfacePoint source = nearestPoint(mesh, Vec3(0, 0, 1));
  const Array<SurfacePoint> points = {nearestPoint(mesh, Vec3(std::sin(0.4), 0, std::cos(0.4)))};
  const auto bytesWith = [&](double likely) {
    const int64_t before = bytesTakenSoFar();
    exactLengths(geometry, source, points, likely);
    return bytesTakenSoFar() - before;
  };
  // The whole sphere is 25 times as large as the disk up to the point.
  EXPECT_LT(bytesWith(0.2), 2 * bytesWith(0.41));
}

TEST(ExactLengths, AreInfiniteOnAnotherComponent) {
  TriangleSoup soup;
  for (const double x : {0.0, 5.0}) {
    const int first = static_cast<int>(soup.positions.size());
    soup.positions.insert(soup.positions.end(), {Vec3(x, 0, 0), Vec3(x + 1, 0, 0), Vec3(x, 1, 0)});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const TriangleMesh mesh = importMesh(soup).mesh;
  const SurfacePoint source = nearestPoint(mesh, Vec3(0, 0, 0));
  const Array<double> lengths =
      exactLengths(buildGeometry(mesh), source,
                   {nearestPoint(mesh, Vec3(5, 0, 0)), nearestPoint(mesh, Vec3(0, 1, 0))}, 0.5);
  EXPECT_EQ(lengths[0], kInfinity);
  EXPECT_NEAR(lengths[1], 1, 1e-15);
}

}  // namespace
}  // namespace karcher

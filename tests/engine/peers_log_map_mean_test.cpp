#include <gtest/gtest.h>

#include <sstream>

#include "curves/spec/bases.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "peers/affine_heat.h"
#include "peers/log_map_mean.h"
#include "support.h"

namespace karcher {
namespace {

LogMapFromVertex vectorHeatOf(const HeatOperators& operators) {
  return [&operators](int v) { return vectorHeatLogMap(operators, v); };
}

LogMapFromVertex affineHeatOf(const HeatOperators& operators) {
  return [&operators](int v) { return affineHeatLogMap(operators, v, AffineVariant::kLocal); };
}

TEST(LogMapMean, TracesTheSplineOfAnIndependentLibrary) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  std::ifstream file = testData("bunny_vector_heat_spline.txt");
  std::string line;
  while (file.peek() == '#') std::getline(file, line);
  Array<SurfacePoint> points;
  std::getline(file, line);
  std::istringstream vertices(line);
  for (int v; vertices >> v;) points.push_back(vertexPoint(mesh, v));
  ASSERT_EQ(points.count(), 8);

  LogMapMean mean(geometry, vectorHeatOf(operators), {});
  SurfacePoint start = points[0];
  int traced = -1;
  int samples = 0;
  int lost = 0;
  int segment = 0;
  double t = 0;
  Vec3 expected;
  while (file >> segment >> t >> expected[0] >> expected[1] >> expected[2]) {
    if (segment != traced) mean.setPoints({points.begin() + segment, points.begin() + segment + 4});
    traced = segment;
    const SearchEnd center = mean.centerOfMass(uniformCubicBasis(t), start);
    start = center.point;
    ++samples;
    if (center.status != Status::kConverged) {
      ++lost;
      continue;
    }
    // The library stops at a step of about 1e-5 mean edges.
    EXPECT_LT((position(mesh, center.point) - expected).norm(), 1e-4 * geometry.meanEdge)
        << "segment " << segment << ", t = " << t;
  }
  EXPECT_EQ(samples, 159);
  EXPECT_LE(lost, 1);
}

TEST(LogMapMean, OfExactLogarithmsOnThePlaneIsTheAffineAverage) {
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kJitteredDelaunay, 800, 2));
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  Random random(31);
  for (int i = 0; i < 20; ++i) {
    Array<SurfacePoint> points;
    Vec3 expected = Vec3::Zero();
    const Array<double> weights{0.5, 0.4, 0.3, -0.2};
    for (int k = 0; k < 4; ++k) {
      points.push_back(nearestPoint(mesh, {random.uniform(0.2, 0.8), random.uniform(0.2, 0.8), 0}));
      expected += weights[k] * position(mesh, points[k]);
    }
    LogMapMean mean(geometry, affineHeatOf(operators), points);
    const SearchEnd center = mean.centerOfMass(weights, points[i % 4]);
    EXPECT_EQ(center.status, Status::kConverged) << "seed 31, case " << i;
    EXPECT_LT((position(mesh, center.point) - expected).norm(), 1e-6 * geometry.meanEdge);
    EXPECT_LE(mean.logMapCount(), 9);
  }
}

TEST(LogMapMean, ReportsTheBoundary) {
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  LogMapMean mean(geometry, affineHeatOf(operators),
                  {nearestPoint(mesh, {1, 4.2, 0}), nearestPoint(mesh, {5, 4.4, 0})});
  const SearchEnd center =
      mean.centerOfMass(Array<double>{2.0, -1.0}, nearestPoint(mesh, {1.2, 4.4, 0}));
  EXPECT_EQ(center.status, Status::kBoundary);
}

/// The authors' library halves a step up to seven times before it gives up a search. It accepts the
/// place if one of these steps is shorter than a third of the root of the face's area. At the
/// boundary of a plane no step lowers the energy, and the step leads to the center in the plane.
TEST(LogMapMean, MeetsTheLibraryRuleByItsShortestStep) {
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  const double longest = 128 * std::sqrt(0.5) / 3;
  int accepted = 0;
  for (const double beyond : {0.02, 1.0, 6.5, 7.0, 7.4, 7.7, 8.0, 20.0}) {
    LogMapMean mean(geometry, affineHeatOf(operators),
                    {nearestPoint(mesh, {1, 4.2, 0}), nearestPoint(mesh, {5, 4.4, 0})});
    const Array<double> weights{1 + beyond, -beyond};
    const SearchEnd center = mean.centerOfMass(weights, nearestPoint(mesh, {1.2, 4.4, 0}));
    const Vec3 inPlane(1 - 4 * beyond, 4.2 - 0.2 * beyond, 0);
    const double step = (inPlane - position(mesh, center.point)).norm();
    EXPECT_EQ(center.status, inPlane.x() > 0 ? Status::kConverged : Status::kBoundary) << beyond;
    EXPECT_EQ(mean.metLibraryRule(), step < longest) << beyond << ": " << step;
    accepted += mean.metLibraryRule();
  }
  EXPECT_EQ(accepted, 6);
}

TEST(LogMapMean, KeepsLogMapsOfPointsThatMove) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  int computed = 0;
  const LogMapFromVertex logMaps = [&](int v) {
    ++computed;
    return vectorHeatLogMap(operators, v);
  };
  const Array<double> weights{0.3, 0.45, 0.25};
  Array<SurfacePoint> points;
  for (const int v : {561, 301, 1409}) points.push_back(vertexPoint(mesh, v));
  const size_t mapBytes = mesh.positions.size() * sizeof(Vec2);
  for (const size_t kept : {size_t{1000}, size_t{0}}) {
    LogMapMean mean(geometry, logMaps, points, {.mostBytes = kept * mapBytes});
    const SurfacePoint first = mean.centerOfMass(weights, points[1]).point;
    const int before = mean.logMapCount();
    // The point moves away and back: its log map is still known.
    const SurfacePoint there = edgePoint(mesh.outgoing[1409], 0.5);
    mean.movePoint(2, there);
    const SearchEnd moved = mean.centerOfMass(weights, points[1]);
    const int after = mean.logMapCount();
    mean.movePoint(2, points[2]);
    EXPECT_EQ(position(mesh, mean.centerOfMass(weights, points[1]).point), position(mesh, first));
    if (kept > 0) {
      EXPECT_LT(after - before, before);  // at least the log map of the start is the same
      EXPECT_EQ(mean.logMapCount(), after);
    } else {
      EXPECT_GT(after - before, 1);
      EXPECT_EQ(mean.logMapCount(), after + before);
    }
    // Kept log maps do not change the result.
    LogMapMean fresh(geometry, logMaps, {points[0], points[1], there});
    const SearchEnd expected = fresh.centerOfMass(weights, points[1]);
    EXPECT_EQ(moved.status, expected.status);
    EXPECT_EQ(position(mesh, moved.point), position(mesh, expected.point));
    EXPECT_GE(computed, mean.logMapCount());
  }
}

TEST(LogMapMean, TimesTheLogMapsAlone) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  double now = 0;
  const LogMapFromVertex logMaps = [&](int v) {
    now += 3;
    return vectorHeatLogMap(operators, v);
  };
  LogMapMeanOptions options;
  options.clock = [&] { return now; };
  const Array<SurfacePoint> points{vertexPoint(mesh, 561), vertexPoint(mesh, 301)};
  LogMapMean mean(geometry, logMaps, points, options);
  mean.centerOfMass(Array<double>{0.4, 0.6}, points[0]);
  EXPECT_GT(mean.logMapCount(), 1);
  EXPECT_EQ(mean.logMapMilliseconds(), 3 * mean.logMapCount());
  mean.setPoints(points);
  EXPECT_EQ(mean.logMapMilliseconds(), 0);
}

/// Two components.
TriangleMesh twoTriangles() {
  return buildMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}},
                   {{0, 1, 2}, {3, 4, 5}});
}

TEST(LogMapMean, ReportsThatAMovedPointHasNoLogarithm) {
  const TriangleMesh mesh = twoTriangles();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  const SurfacePoint here{0, Vec3(0.2, 0.5, 0.3)};
  const SurfacePoint elsewhere{1, Vec3(0.2, 0.5, 0.3)};
  const Array<double> weights{0.5, 0.5};
  LogMapMean mean(geometry, affineHeatOf(operators), {here, here});
  EXPECT_EQ(mean.centerOfMass(weights, here).status, Status::kConverged);
  mean.movePoint(1, elsewhere);
  EXPECT_THROW(mean.centerOfMass(weights, here), Error);
  mean.movePoint(1, here);
  EXPECT_EQ(mean.centerOfMass(weights, here).status, Status::kConverged);
}

TEST(LogMapMean, RefusesWeightsAndPointsThatDoNotFit) {
  const TriangleMesh mesh = twoTriangles();
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  const SurfacePoint here{0, Vec3(0.2, 0.5, 0.3)};
  const SurfacePoint elsewhere{1, Vec3(0.2, 0.5, 0.3)};
  LogMapMean mean(geometry, vectorHeatOf(operators), {here, elsewhere});
  try {
    mean.centerOfMass(Array<double>{1.0}, here);
    FAIL() << "one weight for two points";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kBadWeights);
  }
  try {
    mean.centerOfMass(Array<double>{0.5, 0.5}, here);
    FAIL() << "two components";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnreachable);
  }
}

}  // namespace
}  // namespace karcher

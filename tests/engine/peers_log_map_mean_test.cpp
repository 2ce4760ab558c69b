#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "curves/bases.h"
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
  std::ifstream file(KARCHER_TEST_DATA "/bunny_vector_heat_spline.txt");
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
    const CenterOfMass center = mean.centerOfMass(uniformCubicBasis(t), start);
    start = center.point;
    ++samples;
    if (center.status != Status::kConverged) {
      ++lost;
      continue;
    }
    // The library stopped at a step of about 1e-5 mean edges.
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
    const CenterOfMass center = mean.centerOfMass(weights, points[i % 4]);
    EXPECT_EQ(center.status, Status::kConverged) << "seed 31, case " << i;
    EXPECT_LT((position(mesh, center.point) - expected).norm(), 1e-6 * geometry.meanEdge);
    EXPECT_LE(mean.logMapCount(), 9);
  }
}

TEST(LogMapMean, SaysWhereTheSurfaceEnds) {
  const TriangleMesh mesh = planeGrid(8, 8);
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  LogMapMean mean(geometry, affineHeatOf(operators),
                  {nearestPoint(mesh, {1, 4.2, 0}), nearestPoint(mesh, {5, 4.4, 0})});
  const CenterOfMass center =
      mean.centerOfMass(Array<double>{2.0, -1.0}, nearestPoint(mesh, {1.2, 4.4, 0}));
  EXPECT_EQ(center.status, Status::kBoundary);
}

TEST(LogMapMean, RefusesWeightsAndPointsThatDoNotFit) {
  const TriangleMesh mesh = buildMesh(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
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

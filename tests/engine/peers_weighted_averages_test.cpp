#include <gtest/gtest.h>

#include "distance/window_distance.h"
#include "generators/plane.h"
#include "generators/random_points.h"
#include "generators/sphere.h"
#include "mesh/error.h"
#include "peers/multidimensional_scaling.h"
#include "peers/weighted_averages.h"
#include "support.h"

namespace karcher {
namespace {

/// Distances in a straight line, which are geodesic on a convex piece of the plane.
DistancesFromVertex straightDistances(const TriangleMesh& mesh) {
  return [&mesh](int v) {
    Array<double> distances;
    for (const Vec3& p : mesh.positions) distances.push_back((p - mesh.positions[v]).norm());
    return distances;
  };
}

DistancesFromVertex greatCircleDistances(const TriangleMesh& mesh) {
  return [&mesh](int v) {
    Array<double> distances;
    for (const Vec3& p : mesh.positions) {
      const Vec3& q = mesh.positions[v];
      distances.push_back(std::atan2(p.cross(q).norm(), p.dot(q)));
    }
    return distances;
  };
}

/// The bunny in eight dimensions, by exact distances from 100 landmarks and refinement.
struct EmbeddedBunny {
  TriangleMesh mesh = bunnyMesh();
  Geometry geometry = buildGeometry(mesh);
  Embedding embedding;

  EmbeddedBunny() {
    WindowDistance solver(geometry);
    EmbeddingOptions options;
    options.landmarks = 100;
    embedding = embedSurface(
        geometry,
        [&](int v) {
          solver.setSource(vertexPoint(mesh, v));
          solver.grow(kInfinity);
          Array<double> distances;
          for (int w = 0; w < mesh.vertexCount(); ++w) distances.push_back(solver.distance(w));
          return distances;
        },
        options);
  }
};

const EmbeddedBunny& embeddedBunny() {
  static const EmbeddedBunny bunny;
  return bunny;
}

TEST(MultidimensionalScaling, FindsPointsThatHaveTheDistances) {
  Random random(5);
  Eigen::MatrixXd points(40, 5);
  for (Eigen::Index i = 0; i < points.size(); ++i) points(i) = random.uniform(-1, 1);
  Eigen::MatrixXd distances(40, 40);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) distances(i, j) = (points.row(i) - points.row(j)).norm();
  }
  const Scaling scaling = scaleDistances(distances);
  ASSERT_EQ(scaling.positions.cols(), 8);
  EXPECT_LT(scaling.stress, 1e-9);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const double distance = (scaling.positions.row(i) - scaling.positions.row(j)).norm();
      EXPECT_NEAR(distance, distances(i, j), 1e-9);
    }
  }
}

TEST(MultidimensionalScaling, LowersTheStress) {
  const TriangleMesh mesh = meshOf(relaxedSphere(200, 3));
  const auto from = greatCircleDistances(mesh);
  Eigen::MatrixXd distances(mesh.vertexCount(), mesh.vertexCount());
  for (int i = 0; i < mesh.vertexCount(); ++i) {
    const Array<double> row = from(i);
    for (int j = 0; j < mesh.vertexCount(); ++j) distances(i, j) = i == j ? 0 : row[j];
  }
  distances = (distances + distances.transpose()).eval() / 2;
  double before = kInfinity;
  for (const int iterations : {0, 1, 5, 50}) {
    ScalingOptions options;
    options.maxIterations = iterations;
    const Scaling scaling = scaleDistances(distances, options);
    EXPECT_LT(scaling.stress, before);
    before = scaling.stress;
  }
  EXPECT_LT(before, 0.1);
}

TEST(PhongProjection, OfAPointOfTheSurfaceIsThePoint) {
  SKIP_WHERE_SANITIZED();
  const EmbeddedBunny& bunny = embeddedBunny();
  EXPECT_LE(bunny.embedding.foldedFaces, 2);
  EXPECT_GT(bunny.embedding.landmarks, 100);
  const PhongSurface surface(bunny.mesh, bunny.embedding.positions, bunny.embedding.planes);
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const SurfacePoint point = randomPoint(bunny.mesh, random);
    if (isFolded(bunny.mesh, bunny.embedding.positions, bunny.embedding.planes, point.face)) {
      continue;
    }
    const SurfacePoint nearby{point.face, Vec3::Constant(1.0 / 3)};
    const auto projection = surface.project(surface.position(point), nearby);
    ASSERT_TRUE(projection) << "seed 2, case " << i;
    EXPECT_LT((position(bunny.mesh, *projection) - position(bunny.mesh, point)).norm(),
              1e-9 * bunny.geometry.meanEdge);
  }
}

TEST(PhongProjection, IsOrthogonalToTheBlendedPlaneAndContinuous) {
  const EmbeddedBunny& bunny = embeddedBunny();
  const PhongSurface surface(bunny.mesh, bunny.embedding.positions, bunny.embedding.planes);
  Random random(4);
  int moves = 0;
  double longest = 0;
  for (int i = 0; i < 40; ++i) {
    // A short straight segment in space, slightly beside the surface, over several faces.
    const SurfacePoint start = randomPoint(bunny.mesh, random);
    const TangentPlane plane = surface.planeAt(start);
    EmbeddedPoint offset;
    for (int d = 0; d < kEmbeddingDimensions; ++d) offset[d] = random.uniform(-1, 1);
    offset -= plane.transpose() * (plane * offset);
    const EmbeddedPoint from =
        surface.position(start) + 0.3 * bunny.geometry.meanEdge * offset.normalized();
    const EmbeddedPoint along = 2 * bunny.geometry.meanEdge * plane.row(0).transpose();
    constexpr int kSteps = 400;
    SurfacePoint before = start;
    for (int k = 0; k <= kSteps; ++k) {
      const EmbeddedPoint p = from + static_cast<double>(k) / kSteps * along;
      const auto projection = surface.project(p, before);
      ASSERT_TRUE(projection) << "seed 4, case " << i;
      EXPECT_LT((surface.planeAt(*projection) * (p - surface.position(*projection))).norm(),
                1e-7 * bunny.geometry.meanEdge);
      if (k > 0) {
        const Vec3 move = position(bunny.mesh, *projection) - position(bunny.mesh, before);
        longest = std::max(longest, move.norm());
        ++moves;
      }
      before = *projection;
    }
  }
  EXPECT_EQ(moves, 40 * 400);
  // A step is 0.005 mean edges long.
  EXPECT_LT(longest, 0.05 * bunny.geometry.meanEdge);
}

TEST(WeightedAverages, OnThePlaneAreAffineAverages) {
  // Every vertex is a landmark, so that the embedding is the plane itself.
  const TriangleMesh mesh = meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 500, 1));
  const Geometry geometry = buildGeometry(mesh);
  const Embedding embedding = embedSurface(geometry, straightDistances(mesh));
  EXPECT_EQ(embedding.landmarks, mesh.vertexCount());
  EXPECT_EQ(embedding.foldedFaces, 0);
  EXPECT_LT(embedding.stress, 1e-6);
  const WeightedAverages averages(mesh, embedding);
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    const Array<double> weights{0.6, 0.5, 0.2, -0.3};
    Array<SurfacePoint> points;
    Vec3 expected = Vec3::Zero();
    for (int k = 0; k < 4; ++k) {
      const Vec3 p(random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), 0);
      points.push_back(nearestPoint(mesh, p));
      expected += weights[k] * p;
    }
    const SearchEnd center = averages.centerOfMass(points, weights, points[0]);
    EXPECT_EQ(center.status, Status::kConverged);
    EXPECT_LT((position(mesh, center.point) - expected).norm(), 1e-6);
  }
  // The expected point lies off the surface.
  const SearchEnd outside =
      averages.centerOfMass({nearestPoint(mesh, {0.1, 0.5, 0}), nearestPoint(mesh, {0.9, 0.5, 0})},
                            Array<double>{3.0, -2.0}, nearestPoint(mesh, {0.1, 0.5, 0}));
  EXPECT_EQ(outside.status, Status::kNoProgress);
}

TEST(WeightedAverages, OfTwoPointsOfTheSphereLieNearTheGreatCircle) {
  const TriangleMesh mesh = meshOf(relaxedSphere(2000, 7));
  const Geometry geometry = buildGeometry(mesh);
  EmbeddingOptions options;
  options.landmarks = 200;
  const WeightedAverages averages(mesh,
                                  embedSurface(geometry, greatCircleDistances(mesh), options));
  Random random(3);
  int tried = 0;
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint a = vertexPoint(mesh, random.index(mesh.vertexCount()));
    const SurfacePoint b = vertexPoint(mesh, random.index(mesh.vertexCount()));
    const Vec3 p = position(mesh, a);
    const Vec3 q = position(mesh, b);
    const double distance = std::acos(p.dot(q));
    if (distance < 0.1 || distance > 1.5) continue;
    ++tried;
    const double t = random.uniform();
    const SearchEnd center = averages.centerOfMass({a, b}, Array<double>{1 - t, t}, a);
    ASSERT_EQ(center.status, Status::kConverged);
    const Vec3 expected =
        (std::sin((1 - t) * distance) * p + std::sin(t * distance) * q) / std::sin(distance);
    // The embedding's distances have errors of 5 %, mostly at long range.
    EXPECT_LT((position(mesh, center.point) - expected).norm(), 0.05 * distance);
  }
  EXPECT_GT(tried, 20);
}

TEST(WeightedAverages, WeightsOfAPointAverageToIt) {
  const EmbeddedBunny& bunny = embeddedBunny();
  const WeightedAverages averages(bunny.mesh, bunny.embedding);
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const SurfacePoint target = randomPoint(bunny.mesh, random);
    Array<SurfacePoint> points;
    while (points.count() < 5) {
      const SurfacePoint p = randomPoint(bunny.mesh, random);
      const double away = (position(bunny.mesh, p) - position(bunny.mesh, target)).norm();
      if (away < 4 * bunny.geometry.meanEdge) points.push_back(p);
    }
    const Array<double> weights = averages.weightsOf(points, target);
    double sum = 0;
    for (const double w : weights) sum += w;
    EXPECT_NEAR(sum, 1, 1e-9);
    const SearchEnd center = averages.centerOfMass(points, weights, target);
    ASSERT_EQ(center.status, Status::kConverged) << "seed 6, case " << i;
    EXPECT_LT((position(bunny.mesh, center.point) - position(bunny.mesh, target)).norm(),
              1e-6 * bunny.geometry.meanEdge);
  }
  const SurfacePoint target = vertexPoint(bunny.mesh, 300);
  const Array<SurfacePoint> points{vertexPoint(bunny.mesh, 10), target,
                                   vertexPoint(bunny.mesh, 400)};
  EXPECT_EQ(averages.weightsOf(points, target), (Array<double>{0, 1, 0}));
  EXPECT_THROW(averages.weightsOf({target, target}, target), Error);
}

template <class Work>
ErrorCode errorCodeOf(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "no error";
  return ErrorCode::kBadFile;
}

TEST(WeightedAverages, ReportAFailedEmbedding) {
  const TriangleMesh mesh = meshOf(relaxedSphere(300, 7));
  const Geometry geometry = buildGeometry(mesh);
  const auto distances = greatCircleDistances(mesh);
  EmbeddingOptions options;
  options.landmarks = 30;
  options.mostStress = 0.001;  // a sphere's distances exist in no Euclidean space
  EXPECT_EQ(errorCodeOf([&] { embedSurface(geometry, distances, options); }),
            ErrorCode::kNoEmbedding);
  options.landmarks = 2;
  EXPECT_EQ(errorCodeOf([&] { embedSurface(geometry, distances, options); }),
            ErrorCode::kBadArgument);
  const auto unreachable = [&](int v) {
    Array<double> row = distances(v);
    row[v == 7 ? 8 : 7] = kInfinity;
    return row;
  };
  EXPECT_EQ(errorCodeOf([&] { embedSurface(geometry, unreachable); }), ErrorCode::kUnreachable);
}

}  // namespace
}  // namespace karcher

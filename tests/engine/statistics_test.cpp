#include "rcm/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "distance_meshes.h"
#include "generators/random_points.h"
#include "intrinsic/tangent.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "rcm/mean.h"
#include "support.h"

/// The closed forms are those of `karcher/statistics` (tests/wasm/statistics.test.mjs).
namespace karcher {
namespace {

Array<SurfacePoint> pointsAt(const TriangleMesh& mesh, const Array<Vec3>& places) {
  Array<SurfacePoint> points;
  for (const Vec3& place : places) points.push_back(nearestPoint(mesh, place));
  return points;
}

const Array<Vec3> kTriangle = {Vec3(1.3, 1.2, 0), Vec3(8.1, 2.3, 0), Vec3(4.2, 7.7, 0)};

TEST(Statistics, TheMedianOfATriangleIsItsFermatPoint) {
  Surface surface(planeGrid(10, 10));
  FieldSets sets(surface);
  const RobustMean found = median(sets, pointsAt(surface.mesh(), kTriangle), {1, 1, 1});
  EXPECT_TRUE(found.converged);
  const Vec3 place = position(surface.mesh(), found.point);
  // From the median, the corners are 120 degrees apart.
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (const Vec3& corner : kTriangle) {
    sum += (corner - place).normalized();
    length += (corner - place).norm();
  }
  EXPECT_LT(sum.norm(), 1e-4);
  EXPECT_NEAR(found.value, length, 1e-9);
}

TEST(Statistics, APointThatIsHeavyEnoughOrWhereTheAngleIsWideIsTheMedian) {
  Surface surface(planeGrid(10, 10));
  FieldSets sets(surface);
  const Array<Vec3> wide = {Vec3(1.2, 2.1, 0), Vec3(5.1, 2.9, 0), Vec3(9.2, 2.2, 0)};
  const RobustMean middle = median(sets, pointsAt(surface.mesh(), wide), {1, 1, 1});
  EXPECT_LT((position(surface.mesh(), middle.point) - wide[1]).norm(), 1e-9);
  const Array<SurfacePoint> points = pointsAt(surface.mesh(), kTriangle);
  const RobustMean heavy = median(sets, points, {2.5, 1, 1});
  EXPECT_LT((position(surface.mesh(), heavy.point) - kTriangle[0]).norm(), 1e-9);
  // A search that starts at a point that is no median leaves it.
  RobustOptions from;
  from.start = points[0];
  const RobustMean there = median(sets, points, {1, 1, 1}, from);
  const RobustMean other = median(sets, points, {1, 1, 1});
  EXPECT_LT((position(surface.mesh(), there.point) - position(surface.mesh(), other.point)).norm(),
            1e-3);
}

TEST(Statistics, ASearchLeavesAPointWhoseWeightIsLittleLessThanThePullOfTheOthers) {
  Surface surface(planeGrid(10, 10));
  FieldSets sets(surface);
  const Array<SurfacePoint> right =
      pointsAt(surface.mesh(), {Vec3(1.3, 1.2, 0), Vec3(8.3, 1.2, 0), Vec3(1.3, 8.2, 0)});
  RobustOptions from;
  from.start = right[0];
  const RobustMean fermat = median(sets, right, {1, 1, 1}, from);
  EXPECT_TRUE(fermat.converged);
  // On the axis of this right triangle with legs of 7, the median is 7 (1 - 1 / sqrt(3)) / 2 from
  // both legs.
  const double leg = 7 * (1 - 1 / std::sqrt(3.0)) / 2;
  const Vec3 expected(1.3 + leg, 1.2 + leg, 0);
  EXPECT_LT((position(surface.mesh(), fermat.point) - expected).norm(), 1e-4);
  EXPECT_NEAR(fermat.value, 7 * (std::sqrt(2.0) + std::sqrt(6.0)) / 2, 1e-8);
  // The center of mass, where this search starts, is the first point.
  const RobustMean light = median(sets,
                                  pointsAt(surface.mesh(), {Vec3(5, 5, 0), Vec3(8, 5, 0),
                                                            Vec3(3.5, 6.5, 0), Vec3(3.5, 3.5, 0)}),
                                  {0.3, 1, 1, 1});
  EXPECT_TRUE(light.converged);
  // With x on the line y = 5: 2 (x - 3.5) / sqrt((x - 3.5)^2 + 1.5^2) = 1 + 0.3.
  const double x = 3.5 + 1.5 * 0.65 / std::sqrt(1 - square(0.65));
  EXPECT_LT((position(surface.mesh(), light.point) - Vec3(x, 5, 0)).norm(), 1e-4);
}

TEST(Statistics, AtACubesCornerTheMedianMovesAlongAnEdge) {
  // Corner (0, 0, 0) of the cube of side 2, and on each side of the cube 12 x 12 squares.
  constexpr int kSquares = 12;
  TriangleSoup cube;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertexAt = [&](const std::array<int, 3>& at) {
    const auto [known, isNew] = numbers.try_emplace(at, cube.positions.count());
    if (isNew) cube.positions.push_back(Vec3(at[0], at[1], at[2]) * (2.0 / kSquares));
    return known->second;
  };
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const bool isFar : {false, true}) {
      for (int square = 0; square < kSquares * kSquares; ++square) {
        const auto corner = [&](int x, int y) {
          std::array<int, 3> at{};
          at[axis] = isFar ? kSquares : 0;
          at[(axis + (isFar ? 1U : 2U)) % 3] = square % kSquares + x;
          at[(axis + (isFar ? 2U : 1U)) % 3] = square / kSquares + y;
          return vertexAt(at);
        };
        cube.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
        cube.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
      }
    }
  }
  Surface surface(meshOf(cube));
  FieldSets sets(surface);
  const Array<SurfacePoint> points =
      pointsAt(surface.mesh(), {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
  // At t along an edge the value is t w + (1 - t) + 2 sqrt(1 + t^2).
  const double t = 0.25 / std::sqrt(1 - square(0.25));
  const double least = 1 - t / 2 + 2 * std::sqrt(1 + t * t);
  RobustOptions from;
  for (const int start : {0, 1, 2, 3, -1}) {
    from.start = start < 0 ? std::nullopt : std::optional(points[start]);
    const RobustMean found = median(sets, points, {0.5, 1, 1, 1}, from);
    EXPECT_TRUE(found.converged) << "from " << start;
    // Fields smooth the creases of the cube.
    EXPECT_NEAR(found.value, least, 1e-3) << "from " << start;
    EXPECT_NEAR(position(surface.mesh(), found.point).norm(), t, 0.03) << "from " << start;
    // The pull along an edge is 1 + 2 cos(90 degrees).
    const RobustMean heavy = median(sets, points, {1.01, 1, 1, 1}, from);
    EXPECT_NEAR(heavy.value, 3, 1e-6) << "from " << start;
  }
}

TEST(Statistics, AtACornerOfTheBoundaryThatPointsInwardsTheMedianMovesAlongTheBoundary) {
  // Seen from the corner, the first two points are three quarters of a turn apart, and the third is
  // at 135 degrees from both.
  Surface surface(lShape(20));
  FieldSets sets(surface);
  const Array<Vec3> places = {Vec3(20, 21, 0), Vec3(21, 20, 0), Vec3(6, 6, 0), Vec3(20, 20, 0)};
  const Array<SurfacePoint> points = pointsAt(surface.mesh(), places);
  RobustOptions from;
  for (const int start : {0, 1, 2, 3, -1}) {
    from.start = start < 0 ? std::nullopt : std::optional(points[start]);
    // Towards the first point the others pull with 1 - 0.5 - 0.1 / sqrt(2) = 0.43.
    const RobustMean found = median(sets, points, {1, 0.5, 0.1, 0.35}, from);
    EXPECT_TRUE(found.converged) << "from " << start;
    EXPECT_NEAR(found.value, 0.5 * 2 + 0.1 * (places[2] - places[0]).norm() + 0.35, 1e-6)
        << "from " << start;
    // The sum of the pulls as vectors would exceed this weight, but points off the surface.
    const RobustMean heavy = median(sets, points, {1, 0.5, 0.1, 0.6}, from);
    EXPECT_TRUE(heavy.converged) << "from " << start;
    EXPECT_LT((position(surface.mesh(), heavy.point) - places[3]).norm(), 1e-9) << "from " << start;
  }
}

TEST(Statistics, HubersMeanIsTheClosedFormOnALineAndAMeanWhereTheThresholdIsWide) {
  Surface surface(planeGrid(10, 10));
  FieldSets sets(surface);
  const Array<Vec3> line = {Vec3(0.4, 5, 0), Vec3(0.9, 5, 0), Vec3(9.4, 5, 0)};
  // With x from the first point: x + (x - .5) = 1.
  const RobustMean onLine = huberMean(sets, pointsAt(surface.mesh(), line), {1, 1, 1}, 1);
  EXPECT_LT((position(surface.mesh(), onLine.point) - Vec3(1.15, 5, 0)).norm(), 1e-5);
  const RobustMean wide = huberMean(sets, pointsAt(surface.mesh(), kTriangle), {1, 2, 3}, 100);
  const Vec3 mean = (kTriangle[0] + 2 * kTriangle[1] + 3 * kTriangle[2]) / 6;
  EXPECT_LT((position(surface.mesh(), wide.point) - mean).norm(), 1e-6);
}

TEST(Statistics, DerivativesOnThePlaneAreTheClosedForms) {
  Surface surface(planeGrid(10, 10));
  const Geometry& geometry = surface.geometry();
  Array<Vec3> places = kTriangle;
  places.push_back(Vec3(2.2, 6.1, 0));
  const Array<double> weights = {0.5, 1, 2, 0.25};
  const Array<SurfacePoint> points = pointsAt(surface.mesh(), places);
  const Vec3 place(3.15, 4.6, 0);
  const SurfacePoint here = nearestPoint(surface.mesh(), place);
  double energy = 0;
  double total = 0;
  Vec3 gradient = Vec3::Zero();
  for (int i = 0; i < places.count(); ++i) {
    energy += weights[i] * (places[i] - place).squaredNorm();
    gradient -= 2 * weights[i] * (places[i] - place);
    total += weights[i];
  }
  const EnergyGradient found = energyAt(geometry, points, weights, here);
  EXPECT_NEAR(found.energy, energy, 1e-8);
  EXPECT_LT((tangentToSpace(geometry, here, found.gradient) - gradient).norm(), 1e-8);
  const Eigen::Matrix2d expected = 2 * total * Eigen::Matrix2d::Identity();
  EXPECT_LT((hessianAt(geometry, points, weights, here) - expected).norm(), 1e-6);
  MeanOptions options;
  options.normalize = true;
  const SurfacePoint center = centerOfMass(surface, points, weights, options).point;
  const Array<Vec2> derivatives = weightDerivatives(geometry, points, weights, center);
  for (int i = 0; i < places.count(); ++i) {
    const Vec3 moves = (places[i] - position(surface.mesh(), center)) / total;
    EXPECT_LT((tangentToSpace(geometry, center, derivatives[i]) - moves).norm(), 1e-5);
  }
  const Array<Eigen::Matrix2d> byPoints = pointDerivatives(geometry, points, weights, center);
  for (int i = 0; i < places.count(); ++i) {
    for (const Vec3& along : {Vec3(1, 0, 0), Vec3(0.6, -0.8, 0)}) {
      const Vec2 moves = byPoints[i] * tangentFromSpace(geometry, points[i], along);
      // The center of a plane moves by the point's share of the weights.
      const Vec3 share = weights[i] / total * along;
      EXPECT_LT((tangentToSpace(geometry, center, moves) - share).norm(), 1e-7);
    }
  }
}

TEST(Statistics, OnATorusTheHessianIsTheDifferenceOfEnergies) {
  Surface surface(meshOf(makeShape(Shape::kTorus, 2000)));
  const Geometry& geometry = surface.geometry();
  const uint64_t seed = 20261126;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Array<SurfacePoint> points;
  Array<double> weights;
  for (const int face : {12, 60, 150, 230, 41}) {
    points.push_back({face, Vec3(0.2, 0.3, 0.5)});
    weights.push_back(random.uniform(0.5, 1.5));
  }
  MeanOptions options;
  options.normalize = true;
  const SurfacePoint center = centerOfMass(surface, points, weights, options).point;
  const Eigen::Matrix2d hessian = hessianAt(geometry, points, weights, center);
  const EnergyGradient here = energyAt(geometry, points, weights, center);
  const double step = 1e-4 * geometry.meanEdge;
  for (int axis = 0; axis < 2; ++axis) {
    const auto energyAway = [&](double length) {
      const Vec2 there = pointInFace(geometry, center) + length * Vec2::Unit(axis);
      return energyAt(geometry, points, weights,
                      {center.face, barycentric(geometry, center.face, there)})
          .energy;
    };
    const double ahead = energyAway(step);
    const double behind = energyAway(-step);
    EXPECT_NEAR((ahead - behind) / (2 * step), here.gradient[axis], 1e-6);
    // Rounding of energies is 1e-16 of them, divided by the square of the step.
    EXPECT_NEAR((ahead - 2 * here.energy + behind) / square(step), hessian(axis, axis), 1e-3);
  }
}

TEST(Statistics, OnATorusTheCenterFollowsAPointThatMovesInItsFace) {
  Surface surface(meshOf(makeShape(Shape::kTorus, 2000)));
  const Geometry& geometry = surface.geometry();
  const uint64_t seed = 20261127;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Array<SurfacePoint> points;
  Array<double> weights;
  for (const int face : {12, 60, 150, 230, 41}) {
    points.push_back({face, Vec3(0.2, 0.3, 0.5)});
    weights.push_back(random.uniform(0.5, 1.5));
  }
  MeanOptions options;
  options.normalize = true;
  const SurfacePoint center = centerOfMass(surface, points, weights, options).point;
  const auto moved = [&](const SurfacePoint& point, const Vec2& way) {
    const Vec2 there = pointInFace(geometry, point) + way;
    return SurfacePoint{point.face, barycentric(geometry, point.face, there)};
  };
  const Array<Eigen::Matrix2d> derivatives = pointDerivatives(geometry, points, weights, center);
  const double step = 1e-4 * geometry.meanEdge;
  for (int i = 0; i < points.count(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      // The gradient of the energy stays the same as the center follows.
      const auto gradientAt = [&](double length) {
        Array<SurfacePoint> others = points;
        others[i] = moved(points[i], length * Vec2::Unit(axis));
        return energyAt(geometry, others, weights, moved(center, length * derivatives[i].col(axis)))
            .gradient;
      };
      const double left = (gradientAt(step) - gradientAt(-step)).norm();
      EXPECT_LT(left / (4 * weights[i] * step), 1e-4) << "point " << i;
    }
  }
}

TEST(Statistics, ErrorsNameTheMistake) {
  Surface surface(planeGrid(4, 4));
  FieldSets sets(surface);
  const Array<SurfacePoint> points =
      pointsAt(surface.mesh(), {Vec3(1.3, 1.2, 0), Vec3(3.1, 2.3, 0)});
  EXPECT_EQ(codeOf([&] { median(sets, points, {1, -1}); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { median(sets, points, {1}); }), ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] { huberMean(sets, points, {1, 1}, 0); }), ErrorCode::kBadArgument);
  // A start excuses nothing.
  Surface two(twoGrids());
  FieldSets ofTwo(two);
  RobustOptions from;
  from.start = nearestPoint(two.mesh(), Vec3(11, 1, 0));
  const Array<SurfacePoint> onFirst =
      pointsAt(two.mesh(), {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)});
  EXPECT_EQ(codeOf([&] { median(ofTwo, onFirst, {1, 1, 1}, from); }), ErrorCode::kUnreachable);
  EXPECT_EQ(codeOf([&] {
              huberMean(ofTwo, onFirst, {1, 1, 1}, 1, from);
            }),
            ErrorCode::kUnreachable);
  EXPECT_EQ(codeOf([&] { huberMean(ofTwo, {}, {}, 1, from); }), ErrorCode::kTooFewPoints);
  EXPECT_EQ(codeOf([&] { median(ofTwo, {}, {}, from); }), ErrorCode::kTooFewPoints);
  const SurfacePoint vertex{0, Vec3(1, 0, 0)};
  const Array<double> weights = {1, 1};
  EXPECT_EQ(codeOf([&] { hessianAt(surface.geometry(), points, weights, vertex); }),
            ErrorCode::kBadArgument);
  EXPECT_EQ(codeOf([&] {
              pointDerivatives(surface.geometry(), {vertex, vertex}, weights, points[0]);
            }),
            ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

#include <gtest/gtest.h>

#include "distance_meshes.h"
#include "generators/random_points.h"
#include "rcm/mean.h"
#include "support.h"

namespace karcher {
namespace {

TEST(GradientOperator, OfTheRingIsEq3AsPrinted) {
  // A vertex's gradient is the area-weighted mean of those of exactly the faces around it.
  const MeasuredMesh mesh(planeGrid(5, 4));
  Random random(61);
  SCOPED_TRACE("seed 61");
  Array<double> values;
  for (int v = 0; v < mesh.mesh.vertexCount(); ++v) values.push_back(random.uniform(-1, 1));
  const Array<Vec2> gradients =
      applyGradient(buildGradientOperator(mesh.geometry, Star::kRing), values);
  const Array<Vec2> wide = applyGradient(buildGradientOperator(mesh.geometry), values);
  bool differ = false;
  for (int v = 0; v < mesh.mesh.vertexCount(); ++v) {
    Vec2 sum = Vec2::Zero();
    double area = 0;
    for (const int h : outgoingHalfedges(mesh.mesh, v)) {
      const Vec3 a = mesh.mesh.positions[v];
      const Vec3 b = mesh.mesh.positions[mesh.mesh.head(h)] - a;
      const Vec3 c = mesh.mesh.positions[mesh.mesh.opposite(h)] - a;
      const double u = values[mesh.mesh.head(h)] - values[v];
      const double w = values[mesh.mesh.opposite(h)] - values[v];
      const double twice = b.x() * c.y() - b.y() * c.x();
      // The gradient of the linear function with these differences, times twice the area.
      const Vec3 slope(u * c.y() - w * b.y(), w * b.x() - u * c.x(), 0);
      sum += inVertexFrame(mesh.geometry, v, slope);
      area += twice;
    }
    EXPECT_LT((gradients[v] - sum / area).norm(), 1e-12);
    differ = differ || (wide[v] - gradients[v]).norm() > 0.1;
  }
  EXPECT_TRUE(differ);
}

TEST(Star, IsAnOptionOfThePapersMethodAlone) {
  Surface surface(meshOf(makeShape(Shape::kTorus, 2000)));
  Random random(62);
  SCOPED_TRACE("seed 62");
  const SurfacePoint middle = randomPoint(surface.mesh(), random);
  Array<SurfacePoint> points;
  for (int k = 0; k < 3; ++k) {
    const Vec2 way = 0.3 * unitVector(2 * kPi / 3 * k);
    points.push_back(traceStraightest(surface.geometry(), middle, way).path.end());
  }
  const Array<double> weights{0.5, 0.3, 0.2};
  MeanOptions options;
  options.field = {Method::kPaper, Solver::kExact};
  const Mean wide = centerOfMass(surface, points, weights, options);
  options.field.star = Star::kRing;
  const Mean ring = centerOfMass(surface, points, weights, options);
  const double apart =
      (position(surface.mesh(), wide.point) - position(surface.mesh(), ring.point)).norm();
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, 0.3 * surface.geometry().meanEdge);
  // The summed field has the same star.
  options.mostValues = 0;
  const Mean summed = centerOfMass(surface, points, weights, options);
  EXPECT_LT((position(surface.mesh(), summed.point) - position(surface.mesh(), ring.point)).norm(),
            1e-6 * surface.geometry().meanEdge);
  options.field.method = Method::kKarcher;
  EXPECT_EQ(codeOf([&] { centerOfMass(surface, points, weights, options); }),
            ErrorCode::kBadArgument);
}

}  // namespace
}  // namespace karcher

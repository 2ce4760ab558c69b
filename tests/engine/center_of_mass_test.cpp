#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "cases.h"
#include "generators/gallery.h"
#include "generators/random_points.h"
#include "mesh/shapes.h"
#include "rcm/gradient_operator.h"
#include "rcm/mean.h"
#include "rcm/paper_method.h"
#include "rcm/walk_to_center.h"
#include "support.h"

namespace karcher {
namespace {

/// The field of a point p of a flat mesh: the gradient of |x - p|^2 is 2 (x - p).
std::unique_ptr<ControlField> flatField(const Geometry& geometry, const Vec3& p) {
  auto field = std::make_unique<ControlField>();
  field->reset([&geometry, p](int v) {
    const Vec3 away = geometry.mesh->positions[v] - p;
    return FieldValue{inVertexFrame(geometry, v, 2 * away), away.squaredNorm()};
  });
  return field;
}

struct FlatCase {
  TriangleMesh mesh = planeGrid(12, 9);
  Geometry geometry = buildGeometry(mesh);
  Array<std::unique_ptr<ControlField>> fields;
  Array<Vec3> points;

  explicit FlatCase(const Array<Vec3>& controlPoints) : points(controlPoints) {
    for (const Vec3& p : points) fields.push_back(flatField(geometry, p));
  }
  FieldBlend blend() const {
    Array<ControlField*> pointers;
    for (const auto& field : fields) pointers.push_back(field.get());
    return FieldBlend(geometry, pointers);
  }
  Vec3 average(const Array<double>& weights) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < points.count(); ++i) sum += weights[i] * points[i];
    return sum;
  }
};

using Search = SearchEnd (*)(FieldBlend&, Weights, const SurfacePoint&);

class CenterOfMassOnThePlane : public testing::TestWithParam<Search> {};

TEST_P(CenterOfMassOnThePlane, IsTheAffineAverage) {
  const uint64_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    Array<Vec3> points;
    for (int k = 0; k < 4; ++k) {
      const double x = random.uniform(3, 9);
      points.emplace_back(x, random.uniform(2, 7), 0);
    }
    const FlatCase plane(points);
    // One weight may be negative: only the sum must be positive.
    Array<double> weights;
    for (int k = 0; k < 3; ++k) weights.push_back(random.uniform());
    weights.push_back(random.uniform(-0.3, 0));
    const double sum = weights[0] + weights[1] + weights[2] + weights[3];
    for (double& w : weights) w /= sum;
    const Vec3 expected = plane.average(weights);
    if (sum < 0.5 || expected.x() < 0.1 || expected.x() > 11.9 || expected.y() < 0.1 ||
        expected.y() > 8.9) {
      continue;
    }
    FieldBlend blend = plane.blend();
    const SearchEnd center = GetParam()(blend, weights, nearestPoint(plane.mesh, points[0]));
    EXPECT_EQ(center.status, Status::kConverged);
    EXPECT_LT((position(plane.mesh, center.point) - expected).norm(), 1e-12);
    double energy = 0;
    for (int k = 0; k < 4; ++k) energy += weights[k] * (points[k] - expected).squaredNorm();
    EXPECT_NEAR(blend.energy(center.point, weights), energy, 1e-11);
    ++checked;
  }
  // In the other cases the sum is too small, or the average lies off the plane.
  EXPECT_GT(checked, 150);
}

TEST_P(CenterOfMassOnThePlane, OfOnePointIsThePointEvenAtAVertexOrOnAnEdge) {
  for (const Vec3& p : {Vec3(4, 5, 0), Vec3(4.5, 5, 0), Vec3(4.25, 5.25, 0), Vec3(4.3, 5.1, 0)}) {
    const FlatCase plane({p});
    FieldBlend blend = plane.blend();
    const SearchEnd center =
        GetParam()(blend, Array<double>{1.0}, nearestPoint(plane.mesh, Vec3(9.7, 1.2, 0)));
    EXPECT_EQ(center.status, Status::kConverged);
    EXPECT_LT((position(plane.mesh, center.point) - p).norm(), 1e-12);
  }
}

TEST_P(CenterOfMassOnThePlane, ReportsTheBoundary) {
  const FlatCase plane({Vec3(1, 4, 0), Vec3(5, 4.3, 0)});
  FieldBlend blend = plane.blend();
  // The affine average, at (-3, 3.7), lies off the surface.
  const SearchEnd center =
      GetParam()(blend, Array<double>{2.0, -1.0}, nearestPoint(plane.mesh, Vec3(1.2, 4.4, 0)));
  EXPECT_EQ(center.status, Status::kBoundary);
}

TEST_P(CenterOfMassOnThePlane, RefusesAMaximum) {
  const FlatCase plane({Vec3(5, 4, 0)});
  FieldBlend blend = plane.blend();
  const SearchEnd center =
      GetParam()(blend, Array<double>{-1.0}, nearestPoint(plane.mesh, Vec3(5.2, 4.1, 0)));
  EXPECT_EQ(center.status, Status::kIndefinite);
}

INSTANTIATE_TEST_SUITE_P(BothSearches, CenterOfMassOnThePlane,
                         testing::Values(Search(newtonCenter), Search(walkToCenter)),
                         [](const testing::TestParamInfo<Search>& search) {
                           return search.index == 0 ? "Newton" : "Walk";
                         });

TEST(NewtonCenter, ReportsItsSteps) {
  // On a plane with one Hessian everywhere a step leads to the zero: no step is shortened or stuck.
  const FlatCase plane({Vec3(1, 4, 0), Vec3(5, 4.3, 0), Vec3(6.2, 1.1, 0)});
  const Array<double> weights{0.2, 0.5, 0.3};
  FieldBlend blend = plane.blend();
  NewtonSteps steps;
  const SearchEnd center =
      newtonCenter(blend, weights, nearestPoint(plane.mesh, Vec3(1.2, 6.4, 0)), steps);
  EXPECT_EQ(center.status, Status::kConverged);
  EXPECT_EQ(steps.traced, 1);
  EXPECT_EQ(steps.shortened + steps.needed + steps.stuck, 0);
  EXPECT_TRUE(steps.inside);
  EXPECT_LT(steps.gradients[0], 1e-12);
  EXPECT_GT(steps.gradients[1], 1);
  EXPECT_EQ(steps.gradients[2], 0);

  // A search from the zero itself takes no step.
  newtonCenter(blend, weights, center.point, steps);
  EXPECT_EQ(steps.traced, 0);
  EXPECT_TRUE(steps.inside);

  // Beyond the boundary every joint is worse: the search is stuck where the surface ends.
  newtonCenter(blend, Array<double>{4.0, -3.0, 0.0}, nearestPoint(plane.mesh, Vec3(1.2, 4.4, 0)),
               steps);
  EXPECT_GT(steps.stuck, 0);
  EXPECT_FALSE(steps.inside);
}

TEST(NewtonCenter, StopsAtAnEdgeBetweenFacesThatPointAtEachOther) {
  // On coarse curved meshes the field jumps at edges: each face may put the zero just behind one.
  struct Case {
    TriangleSoup soup;
    double reach;  // the largest distance between points
  };
  const Case cases[] = {{icosphere(4), 1}, {icosphere(7), 1}, {ringTube(0.4, 8, 16), 1.2}};
  const uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  int onEdge = 0;
  for (const Case& example : cases) {
    Surface surface(meshOf(example.soup));
    const TriangleMesh& mesh = surface.mesh();
    const int count = longRun() ? 20'000 : casesOf(400, 60);
    for (int i = 0; i < count; ++i) {
      Array<SurfacePoint> points{randomPoint(mesh, random)};
      while (points.count() < 3) {
        const SurfacePoint point = randomPoint(mesh, random);
        const double apart = (position(mesh, point) - position(mesh, points[0])).norm();
        if (apart < example.reach) points.push_back(point);
      }
      const double a = random.uniform();
      const double b = (1 - a) * random.uniform();
      MeanOptions options;
      options.field = {Method::kPaper, Solver::kExact, 6};
      const Mean mean = centerOfMass(surface, points, {a, b, 1 - a - b}, options);
      EXPECT_NE(mean.status, Status::kLimit) << "case " << i;
      onEdge += mean.status == Status::kConverged && mean.point.bary.minCoeff() == 0;
    }
  }
  EXPECT_GT(onEdge, 0);
}

TEST(NewtonCenter, GivesUpAtAVertexOnlyIfNoFaceAroundItLeadsOn) {
  // The field of a point plus noise has zeros that the search can reach from some faces alone.
  const TriangleMesh mesh = planeGrid(12, 9);
  const Geometry geometry = buildGeometry(mesh);
  const uint64_t seed = 23;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const Array<double> one{1};
  int checked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 p(random.uniform(1, 11), random.uniform(1, 8), 0);
    Array<FieldValue> values;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Vec3 away = mesh.positions[v] - p;
      const Vec3 noise(random.uniform(-1, 1), random.uniform(-1, 1), 0);
      values.push_back({inVertexFrame(geometry, v, 2 * away + noise), away.squaredNorm()});
    }
    ControlField field;
    field.reset([&](int v) { return values[v]; });
    FieldBlend blend(geometry, {&field});
    // The starts are one point, which each of the faces around it names.
    const int vertex = random.index(mesh.vertexCount());
    const SurfacePoint there = edgePoint(mesh.outgoing[vertex], 0);
    int leading = 0;
    int gaveUp = 0;
    for (const int h : outgoingHalfedges(mesh, vertex)) {
      const SearchEnd center = newtonCenter(blend, one, edgePoint(h, 0));
      const bool stayed = position(mesh, center.point) == position(mesh, there);
      gaveUp += stayed && center.status == Status::kNoProgress;
      leading += !stayed;
    }
    if (leading == 0) continue;
    ++checked;
    EXPECT_EQ(gaveUp, 0) << "case " << i << ": " << leading << " faces lead on";
  }
  EXPECT_GT(checked, 0);
}

TEST(FieldBlend, FindsTheSameZeroOnAnEdgeFromBothSides) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  Random random(11);
  Array<Vec2> values;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const double x = random.uniform(-1, 1);
    values.emplace_back(x, random.uniform(-1, 1));
  }
  ControlField field;
  field.reset([&](int v) { return FieldValue{values[v], 0}; });
  FieldBlend blend(geometry, {&field});
  const Array<double> one{1};
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const double s = blend.zeroAlongEdge(h, one);
    EXPECT_NEAR(s, 1 - blend.zeroAlongEdge(mesh.twin[h], one), 1e-9);
  }
}

TEST(GradientOperator, IsExactForLinearFunctionsOnThePlane) {
  const TriangleMesh mesh = planeGrid(6, 5);
  const Geometry geometry = buildGeometry(mesh);
  const Vec3 slope(1.5, -0.7, 0);
  Array<double> values;
  for (const Vec3& p : mesh.positions) values.push_back(slope.dot(p) + 3);
  const Array<Vec2> gradients = applyGradient(buildGradientOperator(geometry), values);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_LT((gradients[v] - inVertexFrame(geometry, v, slope)).norm(), 1e-13);
  }
}

TEST(GradientOperator, OfASquaredDistanceIsExactInsideARegularGrid) {
  // On a face the gradient of the interpolated |x - p|^2 is 2 (circumcenter - p): the mean of the
  // circumcenters of a star is its vertex where the star is symmetric.
  const TriangleMesh mesh = planeGrid(6, 6);
  const Geometry geometry = buildGeometry(mesh);
  const Vec3 p(2.3, 3.4, 0);
  Array<double> values;
  for (const Vec3& x : mesh.positions) values.push_back((x - p).squaredNorm());
  const Array<Vec2> gradients = applyGradient(buildGradientOperator(geometry), values);
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3& x = mesh.positions[v];
    if (x.x() < 1.5 || x.x() > 4.5 || x.y() < 1.5 || x.y() > 4.5) continue;
    EXPECT_LT((gradients[v] - inVertexFrame(geometry, v, 2 * (x - p))).norm(), 1e-12);
  }
}

TEST(ControlField, ReadsEachVertexOnceAndForgetsOnReset) {
  ControlField field;
  int calls = 0;
  field.reset([&](int v) {
    ++calls;
    return FieldValue{Vec2(v, 0), 1.0};
  });
  EXPECT_EQ(field.at(999).gradient.x(), 999);
  EXPECT_EQ(field.at(999).gradient.x(), 999);
  EXPECT_EQ(field.at(3).gradient.x(), 3);
  EXPECT_EQ(calls, 2);
  field.reset([&](int v) { return FieldValue{Vec2(-v, 0), 1.0}; });
  EXPECT_EQ(field.at(999).gradient.x(), -999);
}

}  // namespace
}  // namespace karcher

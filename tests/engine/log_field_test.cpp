#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "curves/curve.h"
#include "curves/spec/bases.h"
#include "distance/window_distance.h"
#include "generators/curve_shapes.h"
#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "generators/random_points.h"
#include "measures/allocations.h"
#include "mesh/mesh_import.h"
#include "peers/timed_field.h"
#include "rcm/walk_to_center.h"
#include "support.h"

namespace karcher {
namespace {

class LogFields : public testing::TestWithParam<Solver> {
 protected:
  FieldOptions options() const { return {Method::kKarcher, GetParam(), 6}; }
};

TEST_P(LogFields, GiveTheBSplineOfThePlaneOnAnyTessellation) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
    Surface surface(importMesh(tessellatedPlane(tessellation, 3000, 9)).mesh);
    Array<SurfacePoint> points;
    for (const Vec2& p :
         {Vec2(0.3, 0.35), Vec2(0.42, 0.62), Vec2(0.52, 0.4), Vec2(0.7, 0.66), Vec2(0.74, 0.45)}) {
      points.push_back(nearestPoint(surface.mesh(), Vec3(p.x() + shear * p.y(), p.y(), 0)));
    }
    Curve curve(surface, ofLevelZero({CurveKind::kBSpline}, 40, options()), points);
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const CurveSample& sample : curve.samples(j)) {
        const Array<double> weights = uniformCubicBasis(sample.t);
        Vec3 expected = Vec3::Zero();
        for (int k = 0; k < 4; ++k) {
          expected += weights[k] * position(surface.mesh(), points[j + k]);
        }
        EXPECT_EQ(sample.status, SampleStatus::kConverged);
        EXPECT_LT((position(surface.mesh(), sample.point) - expected).norm(), 1e-12);
      }
    }
  }
}

TEST_P(LogFields, LeaveAnEditedCurveAsTracedAnew) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  Array<SurfacePoint> points;
  for (int i = 0; i < 7; ++i) {
    points.push_back(nearestPoint(mesh, Vec3(-3 + 0.9 * i, 7.5 + (i % 2), 4)));
  }
  const CurveOptions curveOptions = ofLevelZero({CurveKind::kBSpline}, 32, options());
  Curve edited(surface, curveOptions, points);
  for (int edit = 0; edit < 10; ++edit) {
    const int i = (3 * edit) % points.count();
    points[i] = vertexPoint(mesh, mesh.head(mesh.outgoing[mesh.corner(points[i].face, edit % 3)]));
    edited.movePoint(i, points[i]);
  }
  Curve anew(surface, curveOptions, points);
  for (int j = 0; j < anew.segmentCount(); ++j) {
    for (int i = 0; i < anew.samples(j).count(); ++i) {
      EXPECT_EQ(edited.samples(j)[i].status, SampleStatus::kConverged);
      EXPECT_LE(
          (position(mesh, edited.samples(j)[i].point) - position(mesh, anew.samples(j)[i].point))
              .norm(),
          1e-9 * surface.geometry().diagonal);
    }
  }
}

/// The mesh has 3,674 triangles, so that the points' neighbourhoods bend: 8 curves of 4 segments.
TEST_P(LogFields, FindEverySampleOnTheBunny) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  const uint64_t seed = 21;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int curveNumber = 0; curveNumber < 8; ++curveNumber) {
    Array<SurfacePoint> points;
    Vec3 place = mesh.positions[random.index(mesh.vertexCount())];
    const double x = random.uniform(-1, 1);
    const Vec3 step = 0.04 * surface.geometry().diagonal * Vec3(x, random.uniform(-1, 1), 0.5);
    for (int i = 0; i < 7; ++i) {
      points.push_back(nearestPoint(mesh, place));
      if (curveNumber % 2 == 1) {
        points.back() = vertexPoint(mesh, mesh.corner(points.back().face, 0));
      }
      place = position(mesh, points.back()) + step;
    }
    Curve curve(surface, ofLevelZero({CurveKind::kBSpline}, 256, options()), points);
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const CurveSample& sample : curve.samples(j)) {
        EXPECT_EQ(sample.status, SampleStatus::kConverged) << curveNumber << " at " << j + sample.t;
      }
    }
  }
}

/// A field with the values of another, which counts the vertices whose values are read.
ControlField countingField(ControlField& field, int& count) {
  ControlField::EvaluateMidpoint midpoint;
  if (field.hasMidpoints()) {
    midpoint = [&](int halfedge) { return field.midpointCorrection(halfedge); };
  }
  ControlField result;
  result.reset(
      [&](int vertex) {
        ++count;
        return field.at(vertex);
      },
      std::move(midpoint));
  return result;
}

TEST_P(LogFields, AreReadInTheNeighbourhoodOnly) {
  Surface surface(planeGrid(300, 300));
  const SurfacePoint point = nearestPoint(surface.mesh(), Vec3(150.3, 150.2, 0));
  EXPECT_LT(TimedField(surface, options(), point, 10).vertexCount(), 400);
  EXPECT_GT(TimedField(surface, options(), point, 10).vertexCount(), 300);

  PointField near(surface, options());
  near.setPoint(point);
  PointField far(surface, options());
  far.setPoint(nearestPoint(surface.mesh(), Vec3(158.1, 144.2, 0)));
  int nearValues = 0;
  int farValues = 0;
  ControlField nearField = countingField(near.field(), nearValues);
  ControlField farField = countingField(far.field(), farValues);
  FieldBlend fields(surface.geometry(), {&nearField, &farField});
  EXPECT_EQ(walkToCenter(fields, Array<double>{0.5, 0.5}, point).status, Status::kConverged);
  EXPECT_LT(nearValues, 500);
  EXPECT_LT(farValues, 500);
}

std::string solverName(const testing::TestParamInfo<Solver>& solver) {
  return solver.param == Solver::kFast ? "Fast" : "Exact";
}

INSTANTIATE_TEST_SUITE_P(Solvers, LogFields, testing::Values(Solver::kFast, Solver::kExact),
                         solverName);

TEST(NearFields, AreExactOnPlanes) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
    Surface surface(importMesh(tessellatedPlane(tessellation, 3000, 9)).mesh);
    const TriangleMesh& mesh = surface.mesh();
    const SurfacePoint inFace = nearestPoint(mesh, Vec3(0.48 + shear * 0.52, 0.52, 0));
    int corner = 0;
    inFace.bary.maxCoeff(&corner);
    const SurfacePoint atVertex = vertexPoint(mesh, mesh.corner(inFace.face, corner));
    const SurfacePoint onEdge = edgePoint(3 * inFace.face + corner, 0.3);
    for (const SurfacePoint& source : {inFace, onEdge, atVertex}) {
      const Vec3 from = position(mesh, source);
      PointField near(surface, {});
      near.setPoint(source, true);
      int count = 0;
      for (int v = 0; v < mesh.vertexCount(); v += 3) {
        const Vec3 off = mesh.positions[v] - from;
        if (off.norm() > 0.2) continue;
        ++count;
        EXPECT_NEAR(std::sqrt(near.field().at(v).squaredDistance), off.norm(), 1e-9);
      }
      EXPECT_GT(count, 10);
    }
  }
}

/// Vertices within this many mean edges of a point, in a straight line.
Array<int> verticesNear(const Surface& surface, const SurfacePoint& point, double edges) {
  const TriangleMesh& mesh = surface.mesh();
  const Vec3 from = position(mesh, point);
  Array<int> vertices;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    if ((mesh.positions[v] - from).norm() < edges * surface.geometry().meanEdge) {
      vertices.push_back(v);
    }
  }
  return vertices;
}

TEST(NearFields, DoNotDependOnEarlierReads) {
  Surface surface(bunnyMesh());
  const SurfacePoint source = nearestPoint(surface.mesh(), Vec3(-1, 8, 4));
  const Array<int> vertices = verticesNear(surface, source, 6);
  PointField forwards(surface, {});
  PointField backwards(surface, {});
  forwards.setPoint(source, true);
  backwards.setPoint(source, true);
  for (int i = 0; i < vertices.count(); ++i) {
    forwards.field().at(vertices[i]);
    backwards.field().at(vertices[vertices.count() - 1 - i]);
  }
  for (const int v : vertices) {
    EXPECT_EQ(forwards.field().at(v).gradient, backwards.field().at(v).gradient);
    EXPECT_EQ(forwards.field().at(v).squaredDistance, backwards.field().at(v).squaredDistance);
  }
}

TEST(NearFields, HaveExactDistancesOnRequest) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  WindowDistance exact(surface.geometry());
  PointField near(surface, {.solver = Solver::kExact});
  Random random(20261125);
  for (int i = 0; i < 10; ++i) {
    SCOPED_TRACE("seed 20261125, point " + std::to_string(i));
    const SurfacePoint source = randomPoint(mesh, random);
    near.setPoint(source, true);
    exact.setSource(source);
    const Array<int> vertices = verticesNear(surface, source, 4);
    for (const int v : vertices) {
      const double distance = exact.growTo(v);
      EXPECT_NEAR(std::sqrt(near.field().at(v).squaredDistance), distance, 1e-9 * distance);
    }
  }
}

/// Beside a hub of sharp folds, where paths cross ridges or pass the hub, no path is longer than
/// the shortest, in either direction.
TEST(NearFields, AreShortestPathsBesideHubs) {
  TriangleSoup soup = wheel(300, 0, 0.5);
  for (size_t i = 1; i < soup.positions.size(); ++i)
    soup.positions[i].z() = i % 2 == 0 ? 0.2 : -0.2;
  Surface surface(importMesh(std::move(soup)).mesh);
  const TriangleMesh& mesh = surface.mesh();
  ASSERT_EQ(mesh.vertexCount(), 301);
  WindowDistance exact(surface.geometry());
  PointField forwards(surface, {});
  PointField backwards(surface, {});
  Random random(20261126);
  for (int i = 0; i < 5; ++i) {
    SCOPED_TRACE(i);
    const SurfacePoint source = randomPoint(mesh, random);
    exact.setSource(source);
    forwards.setPoint(source, true);
    backwards.setPoint(source, true);
    for (int v = mesh.vertexCount() - 1; v >= 0; --v) backwards.field().at(v);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double distance = exact.growTo(v);
      const FieldValue& found = forwards.field().at(v);
      EXPECT_NEAR(std::sqrt(found.squaredDistance), distance, 1e-9 * distance);
      EXPECT_EQ(found.squaredDistance, backwards.field().at(v).squaredDistance);
      EXPECT_EQ(found.gradient, backwards.field().at(v).gradient);
    }
  }
}

/// Sight beside a hub costs only what lies between, as elsewhere: a wavefront would need memory for
/// each of the hub's many faces.
TEST(NearFields, SeeBesideHubsWithoutAWavefront) {
  Surface surface(importMesh(wheel(5000, 0, 0.5)).mesh);
  const TriangleMesh& mesh = surface.mesh();
  ASSERT_TRUE(surface.isBesideHub(0));
  PointField near(surface, {});
  near.setPoint({17, Vec3(0.2, 0.3, 0.5)}, true);
  const int64_t before = bytesTakenSoFar();
  for (int k = 0; k < 3; ++k) near.field().at(mesh.corner(17, k));
  EXPECT_LT(bytesTakenSoFar() - before, mesh.vertexCount());
}

/// Near fields at vertices also find the shortest path almost everywhere: no path is shorter than
/// an exact one, and few are longer.
TEST(NearFields, AreSeldomLongerThanShortestPaths) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  WindowDistance exact(surface.geometry());
  PointField near(surface, {});
  int count = 0;
  int longer = 0;
  for (int vertex = 0; vertex < mesh.vertexCount(); vertex += 97) {
    near.setPoint(vertexPoint(mesh, vertex), true);
    exact.setSource(vertexPoint(mesh, vertex));
    const Array<int> vertices = verticesNear(surface, vertexPoint(mesh, vertex), 4);
    for (const int v : vertices) {
      const double distance = exact.growTo(v);
      const double found = std::sqrt(near.field().at(v).squaredDistance);
      EXPECT_GE(found, distance * (1 - 1e-9));
      ++count;
      if (found > 1.001 * distance) ++longer;
    }
  }
  EXPECT_GT(count, 300);
  EXPECT_LE(longer, count / 50);
}

}  // namespace
}  // namespace karcher

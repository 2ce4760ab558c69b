#include "curves/trace/edge_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/curve_shapes.h"
#include "generators/plane.h"
#include "mesh/mesh_import.h"
#include "support.h"

namespace karcher {
namespace {

CurveOptions exactOptions(int samples) {
  CurveOptions options = ofLevelZero({CurveKind::kBSpline}, samples, kFast);
  options.geometry = CurveGeometry::kExact;
  return options;
}

/// The crossings that lie inside edges, with their parameters.
Array<CurveSample> crossingsOf(Curve& curve, int segment, int* left) {
  const BasisWriter basis = [&](double t, Array<double>& weights) {
    weights = curve.weights(segment, t);
  };
  SegmentFields fields(curve.surface(), curve.fieldsOf(segment));
  CrossingWorkspace workspace;
  EdgeCrossings crossings(fields, basis, Method::kKarcher, workspace);
  Array<CurveSample> result;
  const Array<CurveSample>& samples = curve.samples(segment);
  for (int i = 1; i < samples.count(); ++i) {
    Array<SurfacePoint> path;
    if (!crossings.append(samples[i - 1], samples[i], path)) ++*left;
    for (const CurveSample& found : crossings.found()) {
      const Simplex simplex = locate(curve.surface().mesh(), found.point).simplex;
      if (simplex == Simplex::kEdge && found.t != samples[i].t) result.push_back(found);
    }
  }
  return result;
}

TEST(EdgeCrossings, LieOnTheTrueCurveOfThePlane) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
    Surface surface(importMesh(tessellatedPlane(tessellation, 1000, 9)).mesh);
    Array<Vec3> places;
    for (const Vec2& p : {Vec2(0.3, 0.35), Vec2(0.42, 0.62), Vec2(0.52, 0.4), Vec2(0.7, 0.66)}) {
      places.emplace_back(p.x() + shear * p.y(), p.y(), 0);
    }
    Curve curve(surface, exactOptions(16), pointsNear(surface.mesh(), places));
    int left = 0;
    const Array<CurveSample> crossings = crossingsOf(curve, 0, &left);
    EXPECT_GT(crossings.count(), 4);
    EXPECT_EQ(left, 0);
    for (const CurveSample& crossing : crossings) {
      const Array<double> weights = curve.weights(0, crossing.t);
      Vec3 expected = Vec3::Zero();
      for (int k = 0; k < 4; ++k) {
        expected += weights[k] * position(surface.mesh(), curve.point(k));
      }
      EXPECT_LT((position(surface.mesh(), crossing.point) - expected).norm(), 1e-11);
    }
  }
}

TEST(EdgeCrossings, DoNotDependOnTheSamples) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  Array<Vec3> places;
  for (int i = 0; i < 6; ++i) places.emplace_back(-3 + 0.9 * i, 7.5 + (i % 2), 4);
  const Array<SurfacePoint> points = pointsNear(mesh, places);
  Array<Array<CurveSample>> found;
  Array<Array<CurveSample>> onEdges;
  double lengths[2] = {0, 0};
  for (int k = 0; k < 2; ++k) {
    Curve curve(surface, exactOptions(k == 0 ? 64 : 201), points);
    Array<CurveSample>& all = found.emplace_back();
    int left = 0;
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const CurveSample& crossing : crossingsOf(curve, j, &left)) all.push_back(crossing);
      lengths[k] += curve.path(j).line.length();
    }
    EXPECT_EQ(left, 0);
    Array<CurveSample>& atEdges = onEdges.emplace_back();
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const CurveSample& sample : curve.samples(j)) {
        if (locate(mesh, sample.point).simplex == Simplex::kEdge) atEdges.push_back(sample);
      }
    }
  }
  EXPECT_GT(found[0].count(), 20);
  const auto isIn = [&](const Array<CurveSample>& others, const CurveSample& one, double within) {
    return std::any_of(others.begin(), others.end(), [&](const CurveSample& other) {
      return (position(mesh, one.point) - position(mesh, other.point)).norm() <= within;
    });
  };
  // A sample within the gap between two faces' fields, or its parameter, replaces the crossing.
  const double same = 1e-9 * surface.geometry().diagonal;
  const double gap = 0.01 * surface.geometry().meanEdge;
  for (int k = 0; k < 2; ++k) {
    int equal = 0;
    for (const CurveSample& crossing : found[k]) {
      equal += isIn(found[1 - k], crossing, same);
      EXPECT_TRUE(isIn(found[1 - k], crossing, gap) || isIn(onEdges[1 - k], crossing, gap));
    }
    EXPECT_GE(equal, 0.75 * found[k].count());
  }
  // Chords in faces are shorter than the curve by the square of the samples' distance.
  EXPECT_NEAR(lengths[0], lengths[1], 1e-3 * lengths[1]);
}

}  // namespace
}  // namespace karcher

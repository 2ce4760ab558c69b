#include "generators/accuracy.h"

#include <cmath>
#include <utility>

#include "curves/curve.h"
#include "curves/spec/bases.h"
#include "generators/curve_shapes.h"
#include "generators/plane.h"
#include "generators/sphere.h"
#include "generators/torus.h"
#include "mesh/mesh_import.h"

namespace karcher {
namespace {

constexpr uint64_t kSeed = 5;
constexpr int kSamples = 128;

/// The turning angles of a sampled curve, positive to the left seen from outside.
Array<double> turningAngles(const SmoothSurface& surface, const Array<Vec3>& points) {
  Array<double> angles;
  for (int i = 1; i + 1 < points.count(); ++i) {
    const Vec3 before = points[i] - points[i - 1];
    const Vec3 after = points[i + 1] - points[i];
    angles.push_back(
        std::atan2(surface.normal(points[i]).dot(before.cross(after)), before.dot(after)));
  }
  return angles;
}

/// The true curve at the samples of each segment.
Array<Vec3> trueCurve(const SmoothSurface& surface, const Array<Vec3>& points) {
  Array<Vec3> curve;
  Vec3 start = points[1];
  for (int j = 0; j + 4 <= points.count(); ++j) {
    const Array<Vec3> four(points.begin() + j, points.begin() + j + 4);
    for (int i = 0; i < kSamples; ++i) {
      start = smoothCenter(surface, four,
                           uniformCubicBasis(static_cast<double>(i) / (kSamples - 1)), start);
      curve.push_back(start);
    }
  }
  return curve;
}

SmoothSurface smoothPlane() {
  return {[](const Vec3& x) { return Vec3(x.x(), x.y(), 0); },
          [](const Vec3&) { return Vec3(0, 0, 1); },
          [](const Vec3& p, const Vec3& v) { return Vec3(p + v); },
          [](const Vec3& p, const Vec3& q) { return Vec3(q - p); }};
}

}  // namespace

Array<AccuracyFamily> accuracyFamilies() {
  Array<AccuracyFamily> result;
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    const double shear = tessellation == PlaneTessellation::kStretchedSheared ? 1 : 0;
    Array<Vec3> points;
    for (const Vec2& p : {Vec2(0.3, 0.35), Vec2(0.4, 0.62), Vec2(0.48, 0.4), Vec2(0.6, 0.66),
                          Vec2(0.68, 0.38), Vec2(0.74, 0.55)}) {
      points.emplace_back(p.x() + shear * p.y(), p.y(), 0);
    }
    result.push_back({std::string("plane: ") + tessellationName(tessellation),
                      [tessellation](int n) { return tessellatedPlane(tessellation, n, kSeed); },
                      smoothPlane(), points});
  }
  const SmoothSurface sphere = smoothSphere();
  Array<Vec3> onSphere;
  for (int i = 0; i < 6; ++i) {
    onSphere.push_back(sphere.project(Vec3(-0.6 + 0.25 * i, i % 2 ? 0.2 : -0.25, 0.9)));
  }
  result.push_back({"sphere: relaxed random points", [](int n) { return relaxedSphere(n, kSeed); },
                    sphere, onSphere});
  result.push_back({"sphere: random points, convex hull",
                    [](int n) { return randomSphere(n, kSeed); }, sphere, onSphere});
  result.push_back(
      {"sphere: jittered UV", [](int n) { return jitteredUvSphere(n, kSeed); }, sphere, onSphere});
  const SmoothSurface torus = smoothTorus(kTorusMajor, kTorusMinor);
  Array<Vec3> onTorus;
  for (int i = 0; i < 6; ++i) {
    const double u = 0.2 * i;
    const double v = i % 2 ? 0.35 : -0.3;
    const double ring = kTorusMajor + kTorusMinor * std::cos(v);
    onTorus.emplace_back(ring * std::cos(u), ring * std::sin(u), kTorusMinor * std::sin(v));
  }
  result.push_back({"torus: isotropic irregular", [](int n) { return irregularTorus(n, 1, kSeed); },
                    torus, onTorus});
  result.push_back(
      {"torus: stretched 8:1", [](int n) { return irregularTorus(n, 8, kSeed); }, torus, onTorus});
  return result;
}

AccuracyCase::AccuracyCase(const AccuracyFamily& family, int triangles)
    : smooth(family.surface), surface(importMesh(family.mesh(triangles)).mesh) {
  Array<Vec3> onSurface;
  for (const Vec3& p : family.points) {
    points.push_back(nearestPoint(surface.mesh(), p));
    onSurface.push_back(smooth.project(position(surface.mesh(), points.back())));
  }
  truth = trueCurve(smooth, onSurface);
}

namespace {

Accuracy measured(const AccuracyCase& example, const Array<Array<CurveSample>>& segments,
                  bool withLost) {
  const SmoothSurface& smooth = example.smooth;
  const Geometry& geometry = example.surface.geometry();
  Accuracy result;
  result.meanEdge = geometry.meanEdge;
  result.diagonal = geometry.diagonal;
  double squares = 0;
  int count = 0;
  double noise = 0;
  int turns = 0;
  for (int j = 0; j < segments.count(); ++j) {
    Array<Vec3> found;
    Array<uint8_t> counts;
    for (const CurveSample& sample : segments[j]) {
      const bool isLost = sample.status != SampleStatus::kConverged;
      result.lost += isLost;
      counts.push_back(withLost || !isLost);
      found.push_back(smooth.project(position(example.surface.mesh(), sample.point)));
    }
    const Array<Vec3> expected(example.truth.begin() + j * kSamples,
                               example.truth.begin() + (j + 1) * kSamples);
    for (int i = 0; i < kSamples; ++i) {
      if (counts[i] == 0) continue;
      const double error = (found[i] - expected[i]).norm();
      squares += error * error;
      ++count;
      result.maximum = std::max(result.maximum, error);
    }
    const Array<double> foundTurns = turningAngles(smooth, found);
    const Array<double> trueTurns = turningAngles(smooth, expected);
    for (int i = 0; i < foundTurns.count(); ++i) {
      if (counts[i] == 0 || counts[i + 1] == 0 || counts[i + 2] == 0) continue;
      noise += std::pow(foundTurns[i] - trueTurns[i], 2);
      ++turns;
    }
  }
  result.rms = std::sqrt(squares / count);
  result.turningNoise = std::sqrt(noise / turns);
  return result;
}

}  // namespace

Accuracy measureAccuracy(AccuracyCase& example, const FieldOptions& options, int levels) {
  CurveOptions curveOptions = ofLevelZero({CurveKind::kBSpline}, kSamples, options);
  curveOptions.levels = levels;
  const Curve curve(example.surface, curveOptions, example.points);
  Array<Array<CurveSample>> segments;
  for (int j = 0; j < curve.segmentCount(); ++j) segments.push_back(curve.samples(j));
  return measured(example, segments, true);
}

Accuracy accuracyOfFound(const AccuracyCase& example, const Array<Array<CurveSample>>& segments) {
  return measured(example, segments, false);
}

}  // namespace karcher

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "curves/curve.h"
#include "curves/query/evaluate.h"
#include "generators/random_points.h"
#include "mesh/error.h"
#include "mesh/mesh_import.h"
#include "random_surfaces.h"
#include "support.h"

/// Curves of random points on small random meshes: an edited curve equals a new one, and open
/// curves begin and end at their points.
namespace karcher {
namespace {

constexpr double kSame = 1e-9;  ///< the tolerance, as a part of the diagonal

CurveOptions randomOptions(Random& random) {
  CurveOptions options;
  options.shape.kind = kCurveKinds[random.index(6)];  // not kOwn, which needs a basis
  options.shape.closed = random.index(4) == 0;
  options.shape.degree = 1 + random.index(kMostSplineDegree);
  if (random.index(2) == 0) options.shape.knotRule = KnotRule::kClamped;
  if (options.shape.kind != CurveKind::kBSpline) options.shape.knotRule = KnotRule::kUniform;
  options.shape.centripetal = random.index(2) == 0;
  options.samples = 2 + random.index(8);
  constexpr int kLevels[] = {0, 1, 2, kAutomaticLevels, kAutomaticLevels};
  options.levels = kLevels[random.index(5)];
  if (random.index(4) == 0) options.field.solver = Solver::kExact;
  return options;
}

class RandomCurve {
 public:
  RandomCurve(Surface& surface, Random& random, Checks& checks)
      : surface_(surface),
        random_(random),
        checks_(checks),
        near_(kSame * surface.geometry().diagonal) {}

  void run(int edits) {
    Array<SurfacePoint> points;
    const int count = 2 + random_.index(5);
    for (int i = 0; i < count; ++i) points.push_back(place());
    std::unique_ptr<Curve> curve;
    // Invalid curves, such as those with too few points for a degree, are refused; other tests
    // check why.
    try {
      curve = std::make_unique<Curve>(surface_, randomOptions(random_), points);
    } catch (const Error&) {
      return;
    }
    expectEnds(*curve);
    for (int i = 0; i < edits; ++i) {
      try {
        edit(*curve);
      } catch (const Error&) {
      }
      expectEnds(*curve);
      expectAsAnew(*curve);
    }
  }

 private:
  SurfacePoint place() { return randomPlace(surface_.mesh(), random_); }

  double apart(const SurfacePoint& a, const SurfacePoint& b) const {
    return (position(surface_.mesh(), a) - position(surface_.mesh(), b)).norm();
  }

  /// Checks that the mean is a control point with all the weight, whatever its field estimates.
  void expectEnds(Curve& curve) {
    const CurveShape& shape = curve.shape();
    const bool endsAtPoints =
        shape.kind != CurveKind::kBSpline || shape.knotRule == KnotRule::kClamped;
    if (shape.closed || !endsAtPoints || curve.segmentCount() == 0) return;
    const SurfacePoint* points[] = {&curve.point(0), &curve.point(curve.pointCount() - 1)};
    for (int end = 0; end < 2; ++end) {
      const CurvePoint at = pointAt(curve, end * curve.segmentCount());
      ++checks_.count;
      EXPECT_LE(apart(at.point, *points[end]), near_)
          << curveKindName(shape.kind) << ", end " << end << " of " << curve.pointCount()
          << " points";
      EXPECT_EQ(at.status, SampleStatus::kConverged);
    }
  }

  void expectAsAnew(const Curve& curve) {
    CurveValue value = curve.value();
    // A curve keeps numbers that only another kind uses, but a caller cannot set them.
    CurveShape& shape = value.options.shape;
    if (!takesWeights(shape.kind)) shape.weights.clear();
    if (!takesBetas(shape.kind)) shape.betas.clear();
    if (shape.kind != CurveKind::kBSpline) shape.knotRule = KnotRule::kUniform;
    const Curve anew(surface_, value);
    ASSERT_EQ(anew.segmentCount(), curve.segmentCount());
    for (int j = 0; j < curve.segmentCount(); ++j) {
      const Array<CurveSample>& edited = curve.samples(j);
      const Array<CurveSample>& made = anew.samples(j);
      ASSERT_EQ(edited.count(), made.count());
      for (int i = 0; i < edited.count(); ++i) {
        ++checks_.count;
        EXPECT_LE(apart(edited[i].point, made[i].point), near_)
            << curveKindName(shape.kind) << ", sample " << i << " of segment " << j;
      }
    }
  }

  void edit(Curve& curve) {
    const int i = random_.index(curve.pointCount());
    switch (random_.index(9)) {
      case 0:
        return curve.insertPoint(i, place());
      case 1:
        return curve.removePoint(i);
      case 2:
        return curve.movePointInOrder(i, random_.index(curve.pointCount()));
      case 3:
        return curve.reverse();
      case 4:
        return curve.setKind(kCurveKinds[random_.index(6)]);
      case 5:
        return curve.setClosed(!curve.shape().closed);
      case 6:
        return curve.setWeight(i, std::pow(10, random_.uniform(-2, 2)));
      case 7:
        return curve.dragPoint(i, place());
      default:
        return curve.movePoint(i, place());
    }
  }

  Surface& surface_;
  Random& random_;
  Checks& checks_;
  double near_;
};

TEST(RandomCurves, AfterEditsEqualNewCurvesAndEndAtTheirPoints) {
  Checks checks;
  const int count = longRun() ? 2200 : 40;
  for (int i = 0; i < count; ++i) {
    const uint64_t seed = seedOf(9000, i);
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Surface surface(importMesh(randomSurface(random)).mesh);
    for (int k = 0; k < 2; ++k) RandomCurve(surface, random, checks).run(3);
  }
}

}  // namespace
}  // namespace karcher

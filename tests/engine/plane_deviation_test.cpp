#include "measures/plane_deviation.h"

#include <gtest/gtest.h>

#include "generators/accuracy.h"
#include "generators/curve_shapes.h"
#include "support.h"

namespace karcher {
namespace {

TEST(Levels, OfEveryTessellationOfThePlaneGiveTheEuclideanCurve) {
  SKIP_WHERE_SANITIZED();
  for (const AccuracyFamily& family : accuracyFamilies()) {
    if (family.name.rfind("plane", 0) != 0) continue;
    SCOPED_TRACE(family.name);
    Surface surface(meshOf(family.mesh(1000)));
    Array<SurfacePoint> points;
    for (const Vec3& p : family.points) points.push_back(nearestPoint(surface.mesh(), p));
    for (const CurveShape& shape : everyShape(points.count())) {
      if (!takesLevels(shape.kind)) continue;
      SCOPED_TRACE(describe(shape));
      for (const int levels : {1, 4}) {
        CurveOptions options = ofLevelZero(shape, 9, {});
        options.levels = levels;
        EXPECT_LE(planeDeviation(surface, options, points), 1e-12 * surface.geometry().diagonal)
            << levels;
      }
    }
  }
}

}  // namespace
}  // namespace karcher

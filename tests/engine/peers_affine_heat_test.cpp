#include <gtest/gtest.h>

#include "generators/plane.h"
#include "generators/sphere.h"
#include "log_maps.h"
#include "peers/affine_heat.h"
#include "support.h"

namespace karcher {
namespace {

constexpr AffineVariant kVariants[] = {AffineVariant::kLocal, AffineVariant::kAdaptive};

LogMap logMap(const HeatOperators& operators, const SurfacePoint& source, AffineVariant variant) {
  return logMapFromPoint(
      operators.geometry(), [&](int v) { return affineHeatLogMap(operators, v, variant); }, source);
}

TEST(AffineHeat, IsExactOnThePlane) {
  // With u (x - p) as vectors and u as heat, the system is the heat flow of u. Heat must not fall
  // below 0, which costs digits. So flips make edges Delaunay; the sheared piece is missing, since
  // its boundary edges face obtuse angles and cannot flip.
  for (const AffineVariant variant : kVariants) {
    for (const PlaneTessellation tessellation : kPlaneTessellations) {
      if (tessellation == PlaneTessellation::kStretchedSheared) continue;
      SCOPED_TRACE(tessellationName(tessellation));
      const TriangleMesh mesh = meshOf(tessellatedPlane(tessellation, 1000, 8));
      const Geometry geometry = buildGeometry(mesh);
      HeatOptions options;
      options.delaunay = true;
      const HeatOperators operators(geometry, options);
      for (const SurfacePoint& source :
           {SurfacePoint{500, Vec3(0.2, 0.5, 0.3)}, edgePoint(900, 0.25), edgePoint(1200, 0)}) {
        const LogMap logs = logMap(operators, source, variant);
        const Vec3 p = position(mesh, source);
        double worst = 0;
        for (int v = 0; v < mesh.vertexCount(); ++v) {
          const Vec2 expected = toFace(geometry, source.face, mesh.positions[v] - p);
          worst = std::max(worst, (logs[v] - expected).norm());
        }
        EXPECT_LT(worst, 1e-12);
      }
    }
  }
}

TEST(AffineHeat, IsNearTheLogarithmOfTheSphere) {
  const TriangleMesh mesh = meshOf(relaxedSphere(8000, 4));
  const Geometry geometry = buildGeometry(mesh);
  const HeatOperators operators(geometry);
  const int source = 17;
  const Vec3& from = mesh.positions[source];
  for (const AffineVariant variant : kVariants) {
    const LogMap logs = affineHeatLogMap(operators, source, variant);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const double distance = std::acos(std::clamp(from.dot(mesh.positions[v]), -1.0, 1.0));
      if (distance > 1.5) continue;
      // Heat spreads over many paths, and curvature bends these away from the shortest.
      const double tolerance = distance < 0.5 ? 0.3 : 1;
      EXPECT_NEAR(logs[v].norm(), distance, tolerance * geometry.meanEdge);
    }
  }
}

}  // namespace
}  // namespace karcher

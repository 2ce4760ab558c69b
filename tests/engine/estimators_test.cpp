#include "rcm/estimators.h"

#include <gtest/gtest.h>

#include <string>

#include "generators/gallery.h"
#include "generators/plane.h"
#include "generators/random.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "support.h"

namespace karcher {
namespace {

/// The estimate at a vertex from the exact log vectors and squared distances of a point p of the
/// plane.
Vec2 estimate(const Geometry& geometry, StencilTable& table, int vertex, const Vec3& p) {
  const TriangleMesh& mesh = *geometry.mesh;
  const auto away = [&](int v) { return Vec3(mesh.positions[v] - p); };
  return table.at(vertex).apply(
      away(vertex).squaredNorm(), [&](int v) { return inVertexFrame(geometry, v, 2 * away(v)); },
      [&](int v) { return away(v).squaredNorm(); });
}

class EstimatorOnThePlane : public testing::TestWithParam<Estimator> {};

TEST_P(EstimatorOnThePlane, IsExactOnAnyTessellation) {
  const Vec3 p(0.41, 0.53, 0);
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const TriangleMesh mesh = importMesh(tessellatedPlane(tessellation, 2000, 3)).mesh;
    const Geometry geometry = buildGeometry(mesh);
    StencilTable table(geometry, GetParam());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Vec2 expected = inVertexFrame(geometry, v, 2 * (mesh.positions[v] - p));
      // Boundary slivers of random points' Delaunay triangulations are as inaccurate as the
      // rounding of their vertices.
      EXPECT_LT((estimate(geometry, table, v, p) - expected).norm(), 1e-9) << "vertex " << v;
    }
  }
}

std::string nameOf(const testing::TestParamInfo<Estimator>& estimator) {
  const char* const names[] = {"Linear1", "Linear2", "Quadratic2"};
  return names[estimator.index];
}

INSTANTIATE_TEST_SUITE_P(All, EstimatorOnThePlane,
                         testing::Values(Estimator::kLinear1, Estimator::kLinear2,
                                         Estimator::kQuadratic2),
                         nameOf);

TEST(StencilTable, ReturnsTheSameStencilAgain) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  StencilTable forward(geometry, Estimator::kQuadratic2);
  StencilTable backward(geometry, Estimator::kQuadratic2);
  for (int v = 0; v < 300; ++v) forward.at(v);
  for (int v = 299; v >= 0; --v) {
    const Stencil a = backward.at(v);
    const Stencil b = forward.at(v);
    ASSERT_EQ(a.end - a.begin, b.end - b.begin);
    for (ptrdiff_t i = 0; i < a.end - a.begin; ++i) {
      EXPECT_EQ(a.begin[i].vertex, b.begin[i].vertex);
      EXPECT_EQ(a.begin[i].x, b.begin[i].x);
      EXPECT_EQ(a.begin[i].y, b.begin[i].y);
    }
  }
}

/// The vertex's own part of an estimate from distances alone; log vectors have no other part.
double ownShare(StencilTable& table, int vertex) {
  const Stencil stencil = table.at(vertex);
  EXPECT_EQ(stencil.ofDistances - stencil.begin, 1);
  EXPECT_EQ(stencil.begin->vertex, vertex);
  EXPECT_EQ(stencil.begin->y, 0);
  return stencil.begin->x;
}

TEST(StencilTable, KeepsTheFitOnAnEvenSurface) {
  const TriangleMesh mesh = importMesh(icosphere(32)).mesh;
  const Geometry geometry = buildGeometry(mesh);
  StencilTable table(geometry, Estimator::kQuadratic2);
  for (int v = 0; v < mesh.vertexCount(); ++v) EXPECT_LT(ownShare(table, v), 0.05) << v;
}

TEST(StencilTable, YieldsToTheOwnLogVectorOnARoughSurface) {
  TriangleMesh mesh = planeGrid(12, 12);
  const uint64_t seed = 8;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (Vec3& p : mesh.positions) p.z() = random.uniform(-0.5, 0.5);
  const Geometry geometry = buildGeometry(mesh);
  StencilTable quadratic(geometry, Estimator::kQuadratic2);
  StencilTable linear(geometry, Estimator::kLinear1);
  double sum = 0;
  int inner = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    if (mesh.onBoundary[v]) continue;
    const double share = ownShare(quadratic, v);
    sum += share;
    ++inner;
    const Stencil stencil = linear.at(v);
    EXPECT_EQ(stencil.ofDistances, stencil.end);
    EXPECT_EQ(stencil.begin->vertex, v);
    EXPECT_GE(stencil.begin->x, share);
  }
  // The other vertices have defects that happen to have one sign.
  EXPECT_GT(sum / inner, 0.8);
}

TEST(StencilTable, DoesNotGoThroughAHub) {
  // The mesh is a disc around one vertex: all others are two edges apart through it.
  const TriangleSoup disc = wheel(3'000, 0, 0);
  const TriangleMesh mesh = buildMesh(disc.positions, disc.triangles);
  const Geometry geometry = buildGeometry(mesh);
  const Vec3 p(0.3, -0.2, 0);
  for (const Estimator estimator :
       {Estimator::kLinear1, Estimator::kLinear2, Estimator::kQuadratic2}) {
    StencilTable table(geometry, estimator);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
      const Stencil stencil = table.at(v);
      ASSERT_LE(stencil.end - stencil.begin, 64) << "vertex " << v;
      const Vec2 expected = inVertexFrame(geometry, v, 2 * (mesh.positions[v] - p));
      ASSERT_LT((estimate(geometry, table, v, p) - expected).norm(), 1e-9) << "vertex " << v;
    }
  }
}

}  // namespace
}  // namespace karcher

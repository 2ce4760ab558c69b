#include "rcm/estimators.h"

#include <gtest/gtest.h>

#include <string>

#include "generators/plane.h"
#include "mesh/mesh_import.h"
#include "support.h"

namespace karcher {
namespace {

/// The estimate at a vertex from the exact log vectors and squared distances of a point p of the
/// plane.
Vec2 estimate(const Geometry& geometry, StencilTable& table, int vertex, const Vec3& p) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Stencil stencil = table.at(vertex);
  const double own = (mesh.positions[vertex] - p).squaredNorm();
  Vec2 sum = Vec2::Zero();
  for (const StencilTerm* term = stencil.begin; term != stencil.end; ++term) {
    const Vec3 away = mesh.positions[term->vertex] - p;
    if (stencil.ofDistances) {
      sum += (away.squaredNorm() - own) * term->coefficient;
    } else {
      sum += rotate(term->coefficient, inVertexFrame(geometry, term->vertex, 2 * away));
    }
  }
  return sum;
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
      // Boundary slivers of random points' Delaunay triangulations are placed with their rounding.
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

TEST(StencilTable, GivesTheSameStencilAgain) {
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
      EXPECT_EQ(a.begin[i].coefficient, b.begin[i].coefficient);
    }
  }
}

}  // namespace
}  // namespace karcher

#include "rcm/field_set.h"

#include <gtest/gtest.h>

#include <utility>

#include "curve_support.h"
#include "curves/curve.h"
#include "measures/allocations.h"
#include "mesh/error.h"
#include "mesh/shapes.h"
#include "mesh/surface_point.h"
#include "support.h"

namespace karcher {
namespace {

using Held = Array<std::shared_ptr<PointField>>;

Held fieldsAt(FieldSet& set, const Array<SurfacePoint>& points) {
  Held fields;
  for (const SurfacePoint& point : points) fields.push_back(set.at(point));
  return fields;
}

/// The mesh's vertices in order.
Array<SurfacePoint> someVertices(const TriangleMesh& mesh, int count) {
  Array<SurfacePoint> points;
  for (int vertex = 0; vertex < count; ++vertex) points.push_back(vertexPoint(mesh, 3 * vertex));
  return points;
}

TEST(FieldSet, AMovedSpareIsFoundAtItsNewPlace) {
  Surface surface(planeGrid(8, 8));
  const TriangleMesh& mesh = surface.mesh();
  FieldSet set(surface, kFast);
  fieldsAt(set, {vertexPoint(mesh, 10), vertexPoint(mesh, 20)});
  const Held held = fieldsAt(set, {vertexPoint(mesh, 30)});
  EXPECT_EQ(set.count(), 2);
  EXPECT_EQ(set.made(), 3);
  EXPECT_EQ(set.find(vertexPoint(mesh, 30)), held[0]);
  EXPECT_NE(set.find(vertexPoint(mesh, 20)), nullptr);
  EXPECT_EQ(set.find(vertexPoint(mesh, 10)), nullptr);
}

/// If a set holds too many fields, the longest unused ones rest. After a rest they return the same
/// values.
TEST(FieldSet, UnusedFieldsBeyondTheBudgetRest) {
  for (const FieldOptions& options : {kFast, kExact, FieldOptions{.solver = Solver::kGraph}}) {
    Surface surface(bunnyMesh());
    const TriangleMesh& mesh = surface.mesh();
    FieldSet set(surface, options);
    const Held held = fieldsAt(set, someVertices(mesh, 3));
    Array<FieldValue> values;
    for (const auto& field : held) values.push_back(field->field().at(900));
    const int64_t all =
        held[0]->bytesOfSolver() + held[1]->bytesOfSolver() + held[2]->bytesOfSolver();
    set.use(*held[1]);
    set.restUnused(all);
    EXPECT_GT(held[0]->bytesOfSolver(), 0);
    set.use(*held[0]);
    set.restUnused(all);
    set.use(*held[2]);
    set.restUnused(all - 1);
    EXPECT_GT(held[0]->bytesOfSolver(), 0);
    EXPECT_EQ(held[1]->bytesOfSolver(), 0);
    set.use(*held[2]);
    set.restUnused(0);
    EXPECT_EQ(held[0]->bytesOfSolver(), 0);
    EXPECT_GT(held[2]->bytesOfSolver(), 0) << "it is in use";
    for (int i = 0; i < held.count(); ++i) {
      EXPECT_EQ(held[i]->field().at(900).gradient, values[i].gradient);
    }
    EXPECT_EQ(held[0]->bytesOfSolver(), 0) << "values that were read stay";
    PointField anew(surface, options);
    anew.setPoint(held[0]->point());
    for (const int vertex : {800, 1100, 500}) {
      const FieldValue& value = held[0]->field().at(vertex);
      EXPECT_EQ(value.gradient, anew.field().at(vertex).gradient);
      EXPECT_EQ(value.squaredDistance, anew.field().at(vertex).squaredDistance);
    }
  }
}

TEST(FieldSet, IsConsistentAfterAFieldFails) {
  Surface surface(planeGrid(8, 8));
  const TriangleMesh& mesh = surface.mesh();
  FieldSet set(surface, kPaperExact);
  {
    const Held three =
        fieldsAt(set, {vertexPoint(mesh, 10), vertexPoint(mesh, 20), vertexPoint(mesh, 30)});
  }
  set.at(vertexPoint(mesh, 40));
  // The second place is tested next; the third would follow, but is gone by then.
  {
    // The mesh is temporarily one that exact distances refuse.
    double& longest = const_cast<Geometry&>(surface.geometry()).longestEdge;
    const double before = std::exchange(longest, 1e300);
    EXPECT_THROW(set.at(vertexPoint(mesh, 70)), Error);
    longest = before;
  }
  EXPECT_EQ(set.find(vertexPoint(mesh, 70)), nullptr);
  EXPECT_EQ(set.count(), 2);
  const int made = set.made();
  const Held held = fieldsAt(set, {vertexPoint(mesh, 40), vertexPoint(mesh, 50),
                                   vertexPoint(mesh, 60), vertexPoint(mesh, 30)});
  EXPECT_EQ(set.made(), made + 3) << "40 was there";
  for (const int vertex : {30, 40, 50, 60}) {
    const auto found = set.find(vertexPoint(mesh, vertex));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->point().face, vertexPoint(mesh, vertex).face);
    EXPECT_EQ(found->point().bary, vertexPoint(mesh, vertex).bary);
  }
}

TEST(FieldSet, DropsSparesAndKeepsHeldFields) {
  Surface surface(planeGrid(8, 8));
  const TriangleMesh& mesh = surface.mesh();
  FieldSet set(surface, kFast);
  Held held;
  for (int vertex = 0; vertex < 20; ++vertex) held.push_back(set.at(vertexPoint(mesh, vertex)));
  for (int vertex = 0; vertex < 15; ++vertex) held[vertex].reset();
  set.trim();
  EXPECT_EQ(set.count(), 10) << "five are held, and as many are spare";
  set.dropSpare(2);
  EXPECT_EQ(set.count(), 7);
  set.dropSpare();
  EXPECT_EQ(set.count(), 5);
  for (int vertex = 15; vertex < 20; ++vertex) {
    EXPECT_EQ(set.find(vertexPoint(mesh, vertex)), held[vertex]);
  }
  EXPECT_EQ(set.find(vertexPoint(mesh, 3)), nullptr);
}

TEST(FieldSet, ADestroyedCurveLeavesNoMoreSparesThanTheOthersHold) {
  Surface surface(planeGrid(16, 16));
  const TriangleMesh& mesh = surface.mesh();
  const auto sets = std::make_shared<FieldSets>(surface);
  CurveValue small;
  small.options.field = kFast;
  small.options.samples = 4;
  small.points = someVertices(mesh, 4);
  CurveValue large = small;
  large.points = someVertices(mesh, 60);
  Curve stays(sets, small);
  const int few = sets->of(kFast)->count();
  const auto expectFew = [&] { EXPECT_LE(sets->of(kFast)->count(), 2 * few); };
  {
    Curve goes(sets, large);
    EXPECT_GT(sets->of(kFast)->count(), 5 * few);
  }
  expectFew();
  stays.set(large);
  stays.set(small);
  expectFew();
  // After a change of options the old fields are spare, too.
  Curve other(sets, large);
  CurveValue exact = small;
  exact.options.field = kExact;
  other.set(exact);
  expectFew();
}

TEST(FieldSet, AFieldHasTheSameValuesAfterMemoryRanOut) {
  const TriangleMesh mesh = meshOf(makeShape(Shape::kTorus, 500));
  const SurfacePoint point{7, Vec3(0.2, 0.3, 0.5)};
  const int far = mesh.vertexCount() / 2;
  for (const FieldOptions& options : {kFast, kExact}) {
    Surface surface(mesh);
    PointField whole(surface, options);
    whole.setPoint(point);
    int failures = 0;
    for (bool isDone = false; !isDone; ++failures) {
      Surface other(mesh);
      PointField field(other, options);
      field.setPoint(point);
      field.rest();
      failAllocationAfter(failures);
      try {
        field.field().at(far);
        isDone = true;
      } catch (const std::bad_alloc&) {
      }
      failAllocationAfter(-1);
      for (int v = 0; v < mesh.vertexCount(); v += 5) {
        const FieldValue& expected = whole.field().at(v);
        const FieldValue& found = field.field().at(v);
        ASSERT_EQ(found.squaredDistance, expected.squaredDistance) << failures << ", vertex " << v;
        ASSERT_EQ(found.gradient, expected.gradient) << failures << ", vertex " << v;
      }
    }
  }
}

}  // namespace
}  // namespace karcher

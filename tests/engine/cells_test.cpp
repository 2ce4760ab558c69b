#include "rcm/cells.h"

#include <gtest/gtest.h>

#include "curve_support.h"
#include "distance/window_distance.h"
#include "generators/random_points.h"
#include "mesh/mesh_import.h"
#include "mesh/shapes.h"
#include "rcm/field_blend.h"
#include "rcm/point_field.h"
#include "support.h"

/// Faces cut by the midpoints of their edges, and fields with values there.
namespace karcher {
namespace {

TEST(Cells, OfCutFacesFitTogether) {
  for (const TriangleMesh& mesh :
       {importMesh(icosphere(3)).mesh, importMesh(makeShape(Shape::kOpenSheet, 500)).mesh}) {
    const Cells cells(mesh, true);
    int boundary = 0;
    for (int h = 0; h < 12 * mesh.faceCount(); ++h) {
      for (const double s : {0.0, 0.3, 1.0}) {
        const SurfacePoint point = cells.pointOnEdge(h, s);
        const int t = cells.twin(h);
        if (t < 0) continue;
        ASSERT_EQ(cells.twin(t), h);
        EXPECT_LT((position(mesh, point) - position(mesh, cells.pointOnEdge(t, 1 - s))).norm(),
                  1e-14);
      }
      boundary += cells.twin(h) < 0;
    }
    int expected = 0;
    for (const int t : mesh.twin) expected += t < 0;
    EXPECT_EQ(boundary, 2 * expected);
  }
}

TEST(Cells, HoldEachPointExactlyOnce) {
  const TriangleMesh mesh = importMesh(icosphere(2)).mesh;
  const Cells cells(mesh, true);
  Random random(7);
  for (int i = 0; i < 1000; ++i) {
    const SurfacePoint point = randomPlace(mesh, random);
    const CellPoint place = cells.at(point);
    EXPECT_EQ(place.cell / 4, point.face);
    EXPECT_GE(place.bary.minCoeff(), -1e-15);
    EXPECT_LT((cells.point(place.cell, place.bary).bary - point.bary).norm(), 1e-14);
  }
}

TEST(Cells, AroundAPointStartAtTheSameHalfedge) {
  const TriangleMesh mesh = importMesh(makeShape(Shape::kOpenSheet, 500)).mesh;
  const Cells cells(mesh, true);
  for (int h = 0; h < 12 * mesh.faceCount(); ++h) {
    const int first = cells.firstAround(h);
    const Vec3 tail = position(mesh, cells.tailOf(h));
    EXPECT_LT((tail - position(mesh, cells.pointOnEdge(h, 0))).norm(), 1e-14);
    bool found = false;
    for (const int around : cells.around(h)) {
      found = found || around == h;
      EXPECT_EQ(cells.firstAround(around), first);
    }
    EXPECT_TRUE(found);
  }
}

/// If all faces are cut and stay flat, distances to the midpoints of edges are those to the
/// vertices there.
TEST(WindowDistance, ToTheMidpointsOfEdgesIsThatOfTheCutMesh) {
  const TriangleMesh mesh = bunnyMesh();
  const Geometry geometry = buildGeometry(mesh);
  Array<Vec3> positions = mesh.positions;
  Array<int> middle(static_cast<size_t>(mesh.halfedgeCount()));
  for (int h = 0; h < mesh.halfedgeCount(); ++h) {
    const int t = mesh.twin[h];
    if (t >= 0 && t < h) {
      middle[h] = middle[t];
      continue;
    }
    middle[h] = positions.count();
    positions.emplace_back((mesh.positions[mesh.tail(h)] + mesh.positions[mesh.head(h)]) / 2);
  }
  Array<Triangle> faces;
  for (int f = 0; f < mesh.faceCount(); ++f) {
    for (int k = 0; k < 3; ++k) {
      faces.push_back({mesh.corner(f, k), middle[3 * f + k], middle[3 * f + (k + 2) % 3]});
    }
    faces.push_back({middle[3 * f], middle[3 * f + 1], middle[3 * f + 2]});
  }
  const TriangleMesh cut = buildMesh(positions, faces);
  const Geometry cutGeometry = buildGeometry(cut);
  const Cells cells(mesh, true);
  Random random(11);
  WindowDistance solver(geometry);
  solver.keepMidpoints();
  WindowDistance ofCut(cutGeometry);
  for (int i = 0; i < 6; ++i) {
    const SurfacePoint source = randomPlace(mesh, random);
    const CellPoint place = cells.at(source);
    solver.setSource(source);
    solver.grow(kInfinity);
    ofCut.setSource(clampedPoint(place.cell, place.bary));
    ofCut.grow(kInfinity);
    for (int h = 0; h < mesh.halfedgeCount(); ++h) {
      if (mesh.twin[h] < 0) continue;
      const MidpointArrival arrival = solver.midpointOf(h);
      const double expected = ofCut.distance(middle[h]);
      ASSERT_NEAR(arrival.distance, expected, 1e-9 * geometry.diagonal) << "half-edge " << h;
      EXPECT_NEAR(arrival.toSource.norm(), 1, 1e-12);
      const MidpointArrival other = solver.midpointOf(mesh.twin[h]);
      EXPECT_EQ(arrival.distance, other.distance);
      EXPECT_LT((arrival.toSource + other.toSource).norm(), 1e-12);
    }
  }
}

/// At the midpoints of edges fields do not jump from face to face, as they may at other points.
TEST(FieldBlend, WithMidpointsIsTheSameFromBothSidesOfAnEdge) {
  Surface surface(bunnyMesh());
  const TriangleMesh& mesh = surface.mesh();
  PointField field(surface, kExact);
  Random random(3);
  field.setPoint(randomPoint(mesh, random));
  FieldBlend blend(surface.geometry(), {&field.field()});
  ASSERT_TRUE(blend.cells().cut());
  constexpr double kOne[] = {1};
  for (int h = 0; h < mesh.halfedgeCount(); h += 7) {
    const int t = mesh.twin[h];
    if (t < 0) continue;
    const Vec2 here = blend.at(edgePoint(h, 0.5), kOne);
    const Vec2 there = blend.at(edgePoint(t, 0.5), kOne);
    EXPECT_LT((acrossEdge(surface.geometry(), h, here) - there).norm(),
              1e-12 * surface.geometry().diagonal);
  }
}

}  // namespace
}  // namespace karcher

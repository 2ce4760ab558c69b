#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "generators/control_polygons.h"
#include "generators/gallery.h"
#include "support.h"

/// Values of near fields that sight does not find. Each takes a path search; a curve needs few of
/// them, however fine the mesh is and whatever its levels are.
namespace karcher {
namespace {

/// A ring tube as wide as a torus, of about this many nearly square triangles.
TriangleMesh fineRing(int triangles) {
  const int around = static_cast<int>(std::lround(std::sqrt(triangles / 4.0)));
  return meshOf(ringTube(0.4, around, 2 * around));
}

struct Reads {
  int all = 0;
  int searches = 0;
};

/// The values of near fields that a traced curve's samples need: those at the corners of the faces
/// that contain samples of each piece.
Reads readsOf(Curve& curve) {
  const Geometry& geometry = curve.surface().geometry();
  std::map<const PointField*, std::set<int>> read;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (int k = 0; k < curve.piecesPerSegment(); ++k) {
      if (curve.piece(j, k).isSubdivided()) continue;
      for (const PointField* field : curve.fieldsOf(j, k)) {
        if (!field->isNear()) continue;
        for (const CurveSample& sample : curve.piece(j, k).samples()) {
          for (int c = 0; c < 3; ++c) {
            read[field].insert(geometry.mesh->corner(sample.point.face, c));
          }
        }
      }
    }
  }
  Reads result;
  for (const auto& [field, vertices] : read) {
    for (const int vertex : vertices) {
      ++result.all;
      if (!field->sees(vertex)) ++result.searches;
    }
  }
  return result;
}

struct Case {
  CurveShape shape;
  int points;
  double spacing;
  int levels;  ///< the number of levels, or kAutomaticLevels
  int leastLevels;
};

TEST(NearFields, AreReadWhereTheyAreInSight) {
  Random random(11);
  Surface surface(fineRing(100'000));
  const Case cases[] = {
      {{CurveKind::kBezier}, 4, 0.3, 1, 0},
      {{CurveKind::kBezier}, 4, 0.3, 2, 0},
      {{CurveKind::kBezier}, 4, 0.1, 1, 0},
      {{CurveKind::kBezier}, 4, 0.1, kAutomaticLevels, 1},
      {{CurveKind::kBezier}, 4, 0.3, kAutomaticLevels, 0},
      {{CurveKind::kBezier}, 12, 0.05, kAutomaticLevels, 1},
      {{CurveKind::kBezier}, 20, 0.02, kAutomaticLevels, 1},
      {{CurveKind::kBSpline}, 6, 0.3, 1, 0},
      {{CurveKind::kCatmullRom}, 5, 0.3, 1, 0},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(std::to_string(each.points) + " points " + std::to_string(each.spacing) +
                 " apart, levels " + std::to_string(each.levels));
    CurveOptions options;
    options.shape = each.shape;
    options.samples = 33;
    options.levels = each.levels;
    options.leastLevels = each.leastLevels;
    for (int i = 0; i < 2; ++i) {
      Curve curve(surface, options,
                  randomControlPolygon(surface.geometry(), random,
                                       {.points = each.points, .spacing = each.spacing}));
      const Reads reads = readsOf(curve);
      EXPECT_LE(reads.searches, 0.02 * reads.all) << curve.levels() << " levels";
    }
  }
}

/// The largest distance between samples of two curves of one segment and equal parameters.
double largestDistance(const Curve& a, const Curve& b) {
  const TriangleMesh& mesh = a.surface().mesh();
  double largest = 0;
  for (int i = 0; i < a.samples(0).count(); ++i) {
    largest = std::max(
        largest,
        (position(mesh, a.samples(0)[i].point) - position(mesh, b.samples(0)[i].point)).norm());
  }
  return largest;
}

TEST(NearFields, GiveTheCurveThatWholeFieldsGive) {
  Random random(12);
  Surface surface(fineRing(20'000));
  // From the second level on the pieces are in sight.
  for (const int levels : {1, 2, 3}) {
    CurveOptions options;
    options.shape = {CurveKind::kBezier};
    options.samples = 33;
    options.levels = levels;
    const Array<SurfacePoint> points =
        randomControlPolygon(surface.geometry(), random, {.spacing = 0.2});
    Curve curve(surface, options, points);
    EXPECT_EQ(curve.fieldsOf(0)[0]->isNear(), levels > 1);
    options.field.solver = Solver::kExact;
    Curve exact(surface, options, points);
    EXPECT_LE(largestDistance(curve, exact), 0.02 * surface.geometry().meanEdge) << levels;
  }
}

/// A curve depends only on its value, even if an edit brings its pieces into or out of sight.
TEST(NearFields, AfterEditsAreThoseOfTheValue) {
  Random random(13);
  Surface surface(fineRing(20'000));
  CurveOptions options;
  options.shape = {CurveKind::kBSpline};
  options.samples = 17;
  options.levels = 1;
  Array<SurfacePoint> points =
      randomControlPolygon(surface.geometry(), random, {.points = 6, .spacing = 0.1});
  Curve curve(surface, options, points);
  ASSERT_TRUE(curve.fieldsOf(0)[0]->isNear());
  const SurfacePoint first = points.back();
  // The second point lies across the hole.
  const SurfacePoint far = nearestPoint(surface.mesh(), -position(surface.mesh(), first));
  bool wasFar = false;
  for (const SurfacePoint& place : {far, first, far}) {
    points.back() = place;
    curve.movePoint(points.count() - 1, place);
    wasFar = wasFar || !curve.fieldsOf(0)[0]->isNear();
    Curve anew(surface, options, points);
    EXPECT_EQ(curve.fieldsOf(0)[0]->isNear(), anew.fieldsOf(0)[0]->isNear());
    EXPECT_LE(largestDistance(curve, anew), 0);
  }
  EXPECT_TRUE(wasFar);
}

}  // namespace
}  // namespace karcher

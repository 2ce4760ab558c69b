#include "intrinsic/surface_path.h"

#include <gtest/gtest.h>

#include "distance_meshes.h"
#include "generators/flat.h"
#include "generators/plane.h"
#include "generators/rough.h"
#include "intrinsic/local_path.h"
#include "intrinsic/straighten.h"
#include "intrinsic/straightest.h"
#include "support.h"

namespace karcher {
namespace {

bool sameBits(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && a.bary == b.bary;
}

double chord(const TriangleMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return (position(mesh, a) - position(mesh, b)).norm();
}

/// The largest distance between points of two paths at equal parts of their lengths.
double apart(const TriangleMesh& mesh, const SurfacePath& a, const SurfacePath& b) {
  double largest = std::abs(a.length() - b.length());
  for (int i = 0; i < a.points.count(); ++i) {
    const double part = a.length() > 0 ? a.lengths[i] / a.length() : 0;
    largest = std::max(largest, chord(mesh, a.points[i], pointAlong(mesh, b, part * b.length())));
  }
  return largest;
}

SurfacePath localPath(const Geometry& geometry, const SurfacePoint& from, const SurfacePoint& to) {
  StripWorkspace workspace;
  Array<SurfacePoint> points{from};
  EXPECT_TRUE(appendLocalPath(geometry, from, to, workspace, points,
                              {.maxFaces = 2 * geometry.mesh->faceCount()}));
  return pathThrough(*geometry.mesh, std::move(points));
}

/// Two paths joined into one.
SurfacePath joined(const TriangleMesh& mesh, const SurfacePath& a, const SurfacePath& b) {
  SurfacePath both = a;
  appendPart(mesh, b, 0, b.length(), both);
  return both;
}

SurfacePath tight(const Geometry& geometry, SurfacePath path) {
  StripWorkspace workspace;
  straighten(geometry, path, workspace);
  return path;
}

/// The angles on both sides of an inner point of a path at a vertex.
struct Sides {
  double left;
  double right;
};
Sides sidesAt(const Geometry& geometry, const SurfacePath& path, int k, int vertex) {
  const TriangleMesh& mesh = *geometry.mesh;
  const auto directionTo = [&](const SurfacePoint& neighbor) {
    const PointLocation location = locate(mesh, neighbor);
    int h = mesh.outgoing[vertex];
    while (!liesInFace(mesh, location, faceOf(h))) h = rotateLeft(mesh, h);
    const SurfacePoint there = inFace(mesh, neighbor, faceOf(h));
    return directionAtTail(
        geometry, h, pointInFace(geometry, there) - cornerInFace(geometry, faceOf(h), cornerOf(h)));
  };
  double right = directionTo(path.points[k + 1]) - directionTo(path.points[k - 1]);
  if (right < 0) right += geometry.totalAngle[vertex];
  return {geometry.totalAngle[vertex] - right, right};
}

/// Checks that a path is connected, measured, and locally shortest. Returns the number of vertices
/// that it passes.
int expectTight(const Geometry& geometry, const SurfacePath& path) {
  const TriangleMesh& mesh = *geometry.mesh;
  EXPECT_EQ(path.points.size(), path.lengths.size());
  EXPECT_EQ(path.lengths.front(), 0);
  int vertices = 0;
  for (int i = 0; i < path.points.count(); ++i) {
    EXPECT_GE(path.points[i].bary.minCoeff(), 0);
    EXPECT_NEAR(path.points[i].bary.sum(), 1, 1e-15);
    if (i == 0) continue;
    EXPECT_TRUE(haveCommonFace(mesh, path.points[i - 1], path.points[i]));
    EXPECT_NEAR(path.lengths[i] - path.lengths[i - 1],
                chord(mesh, path.points[i - 1], path.points[i]), 1e-14 * geometry.diagonal);
    if (i + 1 == path.points.count()) continue;
    const PointLocation at = locate(mesh, path.points[i]);
    if (at.simplex != Simplex::kVertex) continue;
    // Neighbours within rounding of the vertex do not determine a direction.
    const double near = 1e-6 * geometry.meanEdge;
    if (path.lengths[i] - path.lengths[i - 1] < near ||
        path.lengths[i + 1] - path.lengths[i] < near) {
      continue;
    }
    ++vertices;
    const Sides sides = sidesAt(geometry, path, i, at.vertex);
    // At the boundary one side is open. Directions of pieces of 1e-6 edges are accurate to 1e-9.
    const double straight = kPi - 1e-8;
    if (mesh.onBoundary[at.vertex]) {
      EXPECT_GT(std::max(sides.left, sides.right), 0);
      continue;
    }
    EXPECT_GT(sides.left, straight);
    EXPECT_GT(sides.right, straight);
  }
  return vertices;
}

TEST(SurfacePath, HasTheLengthsOfItsPieces) {
  const MeasuredMesh plane(planeGrid(4, 4));
  Array<SurfacePoint> points;
  for (int v = 0; v < 5; ++v) points.push_back(vertexPoint(plane.mesh, v));
  const SurfacePath path = pathThrough(plane.mesh, points);
  EXPECT_EQ(path.lengths, (Array<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(reversed(path).lengths, (Array<double>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(sameBits(reversed(path).start(), path.end()));
  for (const double s : {-1.0, 0.0, 0.25, 1.0, 2.75, 4.0, 5.0}) {
    const Vec3 at(std::clamp(s, 0.0, 4.0), 0, 0);
    EXPECT_NEAR((position(plane.mesh, pointAlong(plane.mesh, path, s)) - at).norm(), 0, 1e-15);
  }
}

TEST(SurfacePath, OfOnePointIsThatPoint) {
  const MeasuredMesh plane(planeGrid(2, 2));
  const SurfacePoint p{3, Vec3(0.25, 0.5, 0.25)};
  SurfacePath path = pathThrough(plane.mesh, {p});
  EXPECT_EQ(path.length(), 0);
  EXPECT_TRUE(sameBits(pointAlong(plane.mesh, path, 0.5), p));
  SurfacePath part;
  appendPart(plane.mesh, path, 0, 1, part);
  EXPECT_EQ(part.points.size(), 1u);
  StripWorkspace workspace;
  straighten(plane.geometry, path, workspace);
  EXPECT_EQ(path.points.size(), 1u);
  ASSERT_TRUE(moveEnd(plane.geometry, vertexPoint(plane.mesh, 8), path, workspace));
  EXPECT_NEAR(path.length(), chord(plane.mesh, p, vertexPoint(plane.mesh, 8)), 1e-15);
}

TEST(SurfacePath, IsTheSumOfItsParts) {
  const MeasuredMesh bunny(bunnyMesh());
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    const SurfacePath path =
        localPath(bunny.geometry, randomPlace(bunny.mesh, random), randomPlace(bunny.mesh, random));
    SurfacePath whole;
    double at = 0;
    for (int k = 1; k <= 8; ++k) {
      const double to = k < 8 ? random.uniform(at, path.length()) : path.length();
      appendPart(bunny.mesh, path, at, to, whole);
      at = to;
    }
    EXPECT_NEAR(whole.length(), path.length(), 1e-13 * bunny.geometry.diagonal);
    EXPECT_EQ(whole.lengths, pathThrough(bunny.mesh, whole.points).lengths);
    for (int k = 1; k < whole.points.count(); ++k) {
      EXPECT_TRUE(haveCommonFace(bunny.mesh, whole.points[k - 1], whole.points[k]));
    }
    SurfacePath back;
    const double low = 0.3 * path.length();
    const double high = 0.9 * path.length();
    appendPart(bunny.mesh, path, high, low, back);
    SurfacePath there;
    appendPart(bunny.mesh, path, low, high, there);
    ASSERT_EQ(there.points.size(), back.points.size());
    for (int k = 0; k < there.points.count(); ++k) {
      EXPECT_TRUE(sameBits(there.points[k], back.points[back.points.count() - 1 - k]));
    }
  }
}

TEST(SurfacePath, AroundACornerStraightensToTheLineInThePlane) {
  for (const PlaneTessellation tessellation : kPlaneTessellations) {
    SCOPED_TRACE(tessellationName(tessellation));
    const MeasuredMesh plane(tessellatedPlane(tessellation, 600, 3));
    Random random(17);
    for (int i = 0; i < 60; ++i) {
      const SurfacePoint a = randomPlace(plane.mesh, random);
      const SurfacePoint b = randomPlace(plane.mesh, random);
      const SurfacePoint c = randomPlace(plane.mesh, random);
      const SurfacePath around =
          joined(plane.mesh, localPath(plane.geometry, a, b), localPath(plane.geometry, b, c));
      const SurfacePath path = tight(plane.geometry, around);
      expectTight(plane.geometry, path);
      EXPECT_TRUE(sameBits(path.start(), a));
      EXPECT_TRUE(sameBits(path.end(), c));
      EXPECT_NEAR(path.length(), chord(plane.mesh, a, c), 1e-13 * plane.geometry.diagonal);
      const Vec3 along = position(plane.mesh, c) - position(plane.mesh, a);
      for (const SurfacePoint& p : path.points) {
        const Vec3 off = (position(plane.mesh, p) - position(plane.mesh, a)).cross(along);
        // The errors are parts of the piece, which is up to twenty times as wide as high.
        EXPECT_LT(off.norm(), 1e-12 * plane.geometry.diagonal * along.norm());
      }
    }
  }
}

TEST(SurfacePath, StaysInItsClassAroundACylinder) {
  const FlatCylinder flat = flatCylinder(24, 2, 4);
  const MeasuredMesh cylinder(flat.soup);
  const auto vertexNear = [&](double x, double y) {
    int best = 0;
    for (int v = 1; v < cylinder.mesh.vertexCount(); ++v) {
      if ((flat.unrolled[v] - Vec2(x, y)).norm() < (flat.unrolled[best] - Vec2(x, y)).norm()) {
        best = v;
      }
    }
    return best;
  };
  const double round = flat.circumference;
  // The path rises and makes more than a full turn in three thirds: the straight line in the
  // unrolled plane.
  SurfacePath path = pathThrough(cylinder.mesh, {vertexPoint(cylinder.mesh, vertexNear(0, 0.3))});
  int last = vertexNear(0, 0.3);
  const int first = last;
  double turned = 0;
  for (int k = 1; k <= 5; ++k) {
    const double x = std::fmod(k * round / 3, round);
    const int v = vertexNear(x, 0.3 + 0.3 * k);
    path = joined(cylinder.mesh, path,
                  localPath(cylinder.geometry, vertexPoint(cylinder.mesh, last),
                            vertexPoint(cylinder.mesh, v)));
    double step = flat.unrolled[v].x() - flat.unrolled[last].x();
    if (step < 0) step += round;
    turned += step;
    last = v;
    const SurfacePath straight = tight(cylinder.geometry, path);
    expectTight(cylinder.geometry, straight);
    EXPECT_NEAR(straight.length(),
                std::hypot(turned, flat.unrolled[last].y() - flat.unrolled[first].y()), 1e-12);
  }
  EXPECT_GT(turned, 1.5 * round);
}

TEST(SurfacePath, PassesOverTheApexOfAConeTowardsTheShorterSide) {
  // The total angle 4 is less than 2 pi: around the apex both sides may be shorter.
  const FlatCone flat = flatCone(30, 4, 5);
  const MeasuredMesh cone(flat.soup);
  Random random(9);
  for (int i = 0; i < 100; ++i) {
    const int v = 1 + random.index(cone.mesh.vertexCount() - 1);
    const int w = 1 + random.index(cone.mesh.vertexCount() - 1);
    const SurfacePoint a = vertexPoint(cone.mesh, v);
    const SurfacePoint c = vertexPoint(cone.mesh, w);
    const SurfacePoint apex = vertexPoint(cone.mesh, 0);
    const SurfacePath path = tight(
        cone.geometry,
        joined(cone.mesh, localPath(cone.geometry, a, apex), localPath(cone.geometry, apex, c)));
    expectTight(cone.geometry, path);
    EXPECT_NEAR(path.length(), coneDistance(flat, flat.unrolled[v], flat.unrolled[w]), 1e-12);
  }
}

TEST(SurfacePath, ThatIsLocallyShortestStays) {
  const MeasuredMesh bunny(bunnyMesh());
  const MeasuredMesh rough(roughened(bunny.mesh, 2, 3));
  for (const MeasuredMesh* surface : {&bunny, &rough}) {
    Random random(21);
    int vertices = 0;
    for (int i = 0; i < 60; ++i) {
      const SurfacePath path = localPath(surface->geometry, randomPlace(surface->mesh, random),
                                         randomPlace(surface->mesh, random));
      const SurfacePath again = tight(surface->geometry, path);
      vertices += expectTight(surface->geometry, again);
      ASSERT_EQ(again.points.size(), path.points.size());
      EXPECT_LT(apart(surface->mesh, again, path), 1e-12 * surface->geometry.diagonal);
    }
    EXPECT_GT(vertices, 0) << "no path passed a vertex: the test says less";
  }
}

TEST(SurfacePath, ReversedStraightensToTheReversed) {
  const MeasuredMesh bunny(bunnyMesh());
  const MeasuredMesh rough(roughened(bunny.mesh, 2, 3));
  for (const MeasuredMesh* surface : {&bunny, &rough}) {
    const TriangleMesh& mesh = surface->mesh;
    Random random(33);
    for (int i = 0; i < 40; ++i) {
      // The path has corners at vertices, on edges and in faces.
      SurfacePath path = pathThrough(mesh, {randomPlace(mesh, random)});
      for (int k = 0; k < 3; ++k) {
        path =
            joined(mesh, path, localPath(surface->geometry, path.end(), randomPlace(mesh, random)));
      }
      const SurfacePath there = tight(surface->geometry, path);
      const SurfacePath back = reversed(tight(surface->geometry, reversed(path)));
      expectTight(surface->geometry, there);
      EXPECT_LT(apart(mesh, there, back), 1e-11 * surface->geometry.diagonal) << "chain " << i;
    }
  }
}

TEST(SurfacePath, ThatDoublesBackStraightensToAPoint) {
  const MeasuredMesh torus(makeShape(Shape::kTorus, 2000));
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const SurfacePath path =
        localPath(torus.geometry, randomPlace(torus.mesh, random), randomPlace(torus.mesh, random));
    const SurfacePath straight = tight(torus.geometry, joined(torus.mesh, path, reversed(path)));
    EXPECT_EQ(straight.length(), 0);
    EXPECT_TRUE(sameBits(straight.start(), path.start()));
    EXPECT_TRUE(sameBits(straight.end(), path.start()));
  }
}

TEST(SurfacePath, AroundATubeStaysAroundIt) {
  // The path runs once around the torus's tube and back to the start: no motion on the surface
  // removes it.
  const MeasuredMesh torus(makeShape(Shape::kTorus, 4000));
  const auto at = [&](double longitude, double latitude) {
    const double r = kTorusMajor + kTorusMinor * std::cos(latitude);
    return nearestPoint(torus.mesh, Vec3(r * std::cos(longitude), r * std::sin(longitude),
                                         kTorusMinor * std::sin(latitude)));
  };
  SurfacePath path = pathThrough(torus.mesh, {at(1, 0)});
  for (int k = 1; k <= 6; ++k) {
    path = joined(torus.mesh, path,
                  localPath(torus.geometry, path.end(), at(1 + 0.2 * (k % 3), 2 * kPi * k / 6)));
  }
  const SurfacePath loop = tight(torus.geometry, path);
  expectTight(torus.geometry, loop);
  // The loop is a meridian of an inscribed polyhedron.
  EXPECT_NEAR(loop.length(), 2 * kPi * kTorusMinor, 0.02);
  EXPECT_LT(chord(torus.mesh, loop.start(), loop.end()), 1e-12);
}

TEST(SurfacePath, BendsAtAReentrantCornerOnly) {
  const MeasuredMesh surface(lShape(3));
  const SurfacePoint p = nearestPoint(surface.mesh, Vec3(2.7, 5.6, 0));
  const SurfacePoint q = nearestPoint(surface.mesh, Vec3(5.8, 2.9, 0));
  const SurfacePoint corner = nearestPoint(surface.mesh, Vec3(0.3, 0.2, 0));
  const SurfacePath path =
      tight(surface.geometry, joined(surface.mesh, localPath(surface.geometry, p, corner),
                                     localPath(surface.geometry, corner, q)));
  EXPECT_NEAR(path.length(), std::hypot(0.3, 2.6) + std::hypot(2.8, 0.1), 1e-12);
}

TEST(SurfacePath, OfPointsThatShareNoFaceIsRefused) {
  const MeasuredMesh plane(planeGrid(4, 4));
  SurfacePath path =
      pathThrough(plane.mesh, {vertexPoint(plane.mesh, 0), vertexPoint(plane.mesh, 24)});
  StripWorkspace workspace;
  EXPECT_EQ(codeOf([&] { straighten(plane.geometry, path, workspace); }), ErrorCode::kBadArgument);
}

TEST(SurfacePath, MovesItsEndOnItsComponentOnly) {
  const MeasuredMesh both(together(planeGrid(3, 3), planeGrid(3, 3), Vec3(10, 0, 0)));
  StripWorkspace workspace;
  SurfacePath path = localPath(both.geometry, vertexPoint(both.mesh, 0), vertexPoint(both.mesh, 7));
  const Array<double> lengths = path.lengths;
  EXPECT_FALSE(moveEnd(both.geometry, vertexPoint(both.mesh, 20), path, workspace));
  EXPECT_FALSE(moveStart(both.geometry, vertexPoint(both.mesh, 20), path, workspace));
  EXPECT_EQ(path.lengths, lengths);
  EXPECT_TRUE(sameBits(path.start(), vertexPoint(both.mesh, 0)));
  EXPECT_TRUE(moveEnd(both.geometry, vertexPoint(both.mesh, 15), path, workspace));
  EXPECT_NEAR(path.length(), std::hypot(3, 3), 1e-14);
}

/// Moves the end of a path over the surface, in steps of up to one and a half mean edges.
void expectContinued(const MeasuredMesh& surface, int walks, uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const TriangleMesh& mesh = surface.mesh;
  Random random(seed);
  StripWorkspace workspace;
  int vertices = 0;
  int returned = 0;
  for (int walk = 0; walk < walks; ++walk) {
    SurfacePath path = pathThrough(mesh, {randomPlace(mesh, random)});
    const SurfacePoint start = path.start();
    double heading = random.uniform(-kPi, kPi);
    for (int step = 0; step < 40; ++step) {
      // Half of the steps end on nearby edges and vertices.
      heading += random.uniform(-0.3, 0.3);
      const double length = random.uniform(0, 1.5) * surface.geometry.meanEdge;
      SurfacePoint end =
          traceStraightest(surface.geometry, path.end(), length * unitVector(heading)).path.end();
      const int kind = random.index(4);
      if (kind == 1) end = edgePoint(3 * end.face + random.index(3), random.uniform());
      if (kind == 2) end = edgePoint(3 * end.face + random.index(3), 0);
      const SurfacePath before = path;
      SurfacePath fromBehind = reversed(path);
      ASSERT_TRUE(moveEnd(surface.geometry, end, path, workspace));
      EXPECT_TRUE(sameBits(path.start(), start));
      EXPECT_TRUE(sameBits(path.end(), end));
      vertices += expectTight(surface.geometry, path);
      // The path is at most as long as the detour by the old end.
      EXPECT_LE(path.length(), before.length() +
                                   localPath(surface.geometry, before.end(), end).length() +
                                   1e-12 * surface.geometry.diagonal);
      ASSERT_TRUE(moveStart(surface.geometry, end, fromBehind, workspace));
      EXPECT_LT(apart(mesh, reversed(fromBehind), path), 1e-10 * surface.geometry.diagonal);
      // After a move there and back the path is the old one, if the surface in between has no
      // vertex.
      SurfacePath back = path;
      ASSERT_TRUE(moveEnd(surface.geometry, before.end(), back, workspace));
      expectTight(surface.geometry, back);
      if (apart(mesh, back, before) < 1e-10 * surface.geometry.diagonal) ++returned;
    }
  }
  EXPECT_GT(vertices, 0) << "no path passed a vertex: the test says less";
  EXPECT_GT(returned, 20 * walks);
}

TEST(SurfacePath, IsContinuedOnTheBunny) {
  expectContinued(MeasuredMesh(bunnyMesh()), longRun() ? 100 : 8, 1);
}

TEST(SurfacePath, IsContinuedOnARoughSurface) {
  expectContinued(MeasuredMesh(roughened(meshOf(makeShape(Shape::kGenus3, 2000)), 2, 7)),
                  longRun() ? 200 : 10, 2);
}

TEST(SurfacePath, IsContinuedOnATorus) {
  expectContinued(MeasuredMesh(makeShape(Shape::kTorus, 3000)), longRun() ? 200 : 10, 3);
}

TEST(SurfacePath, IsContinuedBesideABoundary) {
  expectContinued(MeasuredMesh(roughened(meshOf(makeShape(Shape::kOpenSheet, 600)), 2, 7)),
                  longRun() ? 200 : 15, 4);
}

TEST(SurfacePath, IsRestoredAfterADragBackInThePlane) {
  // On the plane no vertex holds a path: after a move there and back it is always the old one.
  const MeasuredMesh plane(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 800, 2));
  Random random(8);
  StripWorkspace workspace;
  for (int i = 0; i < 300; ++i) {
    const SurfacePath path =
        localPath(plane.geometry, randomPlace(plane.mesh, random), randomPlace(plane.mesh, random));
    SurfacePath moved = path;
    ASSERT_TRUE(moveEnd(plane.geometry, randomPlace(plane.mesh, random), moved, workspace));
    ASSERT_TRUE(moveEnd(plane.geometry, path.end(), moved, workspace));
    EXPECT_LT(apart(plane.mesh, moved, path), 1e-12);
  }
}

}  // namespace
}  // namespace karcher

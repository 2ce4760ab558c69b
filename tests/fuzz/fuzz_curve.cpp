#include <algorithm>
#include <cmath>
#include <memory>

#include "curves/curve.h"
#include "distance/find_path.h"
#include "distance/shortest_path.h"
#include "fuzz/fuzz_checks.h"
#include "generators/grid.h"
#include "mesh/shapes.h"

namespace karcher {
namespace {

constexpr int kMostPoints = 7;
constexpr int kMostEdits = 6;
/// The tolerance, as a part of the diagonal.
constexpr double kSame = 1e-9;

/// A sheet of squares with heights from the fuzzer: flat, folded or steep.
TriangleSoup sheet(FuzzBytes& bytes) {
  const int columns = 1 + bytes.index(6);
  const int rows = 1 + bytes.index(6);
  constexpr double kSteepness[] = {0, 0.1, 1, 20};
  const double steepness = kSteepness[bytes.index(4)];
  const double stretch = bytes.flag() ? 50 : 1;
  const int cuts = bytes.byte();
  TriangleSoup soup;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      soup.positions.emplace_back(stretch * i, j, steepness * bytes.byte() / 255);
    }
  }
  soup.triangles =
      gridTriangles(columns, rows, [&](int i, int j) { return (cuts >> (i + j) % 8) % 2 == 1; });
  return soup;
}

/// The shapes exist once, since a surface keeps its derived data.
Surface& shapeOf(int number) {
  static Array<std::unique_ptr<Surface>> shapes;
  if (shapes.empty()) {
    for (const Shape shape : kShapes) {
      shapes.push_back(std::make_unique<Surface>(importMesh(makeShape(shape, 500)).mesh));
    }
    shapes.push_back(std::make_unique<Surface>(importMesh(icosphere(1)).mesh));
    shapes.push_back(
        std::make_unique<Surface>(buildMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})));
  }
  return *shapes[number % shapes.count()];
}

SurfacePoint readPoint(FuzzBytes& bytes, const TriangleMesh& mesh) {
  const int face = bytes.index(mesh.faceCount());
  // A place in the face, on its edges or at its corners.
  const int where = bytes.index(8);
  double b1 = bytes.unit();
  double b2 = bytes.unit();
  if (where == 7) return vertexPoint(mesh, mesh.corner(face, 0));
  if (where >= 5) b2 = where == 5 ? 0 : 1 - b1;
  if (b1 + b2 > 1) {
    b1 = 1 - b1;
    b2 = 1 - b2;
  }
  return checkedPoint(mesh, face, {1 - b1 - b2, b1, b2});
}

CurveOptions readOptions(FuzzBytes& bytes, int points) {
  CurveOptions options;
  CurveShape& shape = options.shape;
  shape.kind = kCurveKinds[bytes.index(6)];  // not kOwn, which needs a basis
  shape.closed = bytes.flag();
  shape.degree = 1 + bytes.index(kMostSplineDegree);
  if (bytes.byte() % 4 == 3) shape.knotRule = KnotRule::kClamped;
  shape.centripetal = bytes.flag();
  const auto values = [&](double most) {
    Array<double> all;
    for (int i = 0; i < points; ++i) all.push_back(std::pow(most, 2 * bytes.unit() - 1));
    return all;
  };
  const int spread = bytes.byte();
  constexpr double kSpreads[] = {2, 10, 1000, 1 / kLeastWeight};
  if (spread >= 64) {
    if (takesWeights(shape.kind)) shape.weights = values(kSpreads[spread / 64]);
    if (takesBetas(shape.kind)) shape.betas = values(kSpreads[spread / 64]);
  }
  options.samples = 2 + bytes.index(12);
  constexpr int kLevels[] = {0, 0, 0, 1, 2, 3, kAutomaticLevels, kLimitLevels};
  options.levels = kLevels[bytes.index(8)];
  constexpr FieldOptions kFields[] = {
      {Method::kKarcher, Solver::kFast, 6},  {Method::kKarcher, Solver::kFast, 6},
      {Method::kKarcher, Solver::kExact, 6}, {Method::kKarcher, Solver::kGraph, 3},
      {Method::kPaper, Solver::kExact, 6},   {Method::kPaper, Solver::kGraph, 3}};
  options.field = kFields[bytes.index(6)];
  constexpr double kTolerances[] = {0, 0, 0, 1e-2, 1e-3};
  options.tolerance = kTolerances[bytes.index(5)];
  if (bytes.byte() % 4 == 3) options.geometry = CurveGeometry::kExact;
  return options;
}

/// The surface is connected: only the requested edit may be refused.
void expectRefusal(const Error& error) {
  expectSentence(error);
  expect(error.code() == ErrorCode::kBadArgument || error.code() == ErrorCode::kTooFewPoints,
         std::string(errorCodeName(error.code())) + ": " + error.what());
}

class CurveCase {
 public:
  CurveCase(Surface& surface, FuzzBytes& bytes)
      : surface_(surface), mesh_(surface.mesh()), bytes_(bytes) {}

  void run() {
    Array<SurfacePoint> points;
    const int count = 1 + bytes_.index(kMostPoints);
    for (int i = 0; i < count; ++i) points.push_back(readPoint(bytes_, mesh_));
    if (count > 1) checkPaths(points[0], points[1]);
    const CurveOptions options = readOptions(bytes_, count);
    std::unique_ptr<Curve> curve;
    try {
      curve = std::make_unique<Curve>(surface_, options, points);
    } catch (const Error& error) {
      return expectRefusal(error);
    }
    check(*curve);
    for (int edits = 0; !bytes_.isAtEnd() && edits < kMostEdits; ++edits) {
      const Array<SurfacePoint> before = curve->points();
      const int segments = curve->segmentCount();
      try {
        edit(*curve);
      } catch (const Error& error) {
        expectRefusal(error);
        expect(samePoints(before, curve->points()) && segments == curve->segmentCount(),
               "an edit that is refused changes the curve");
      }
      check(*curve);
      checkSameAnew(*curve);
    }
  }

 private:
  static bool samePoints(const Array<SurfacePoint>& a, const Array<SurfacePoint>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const SurfacePoint& p, const SurfacePoint& q) {
                        return p.face == q.face && p.bary == q.bary;
                      });
  }

  void checkPaths(const SurfacePoint& a, const SurfacePoint& b) {
    const double diagonal = surface_.geometry().diagonal;
    const SurfacePath there = shortestPath(surface_.geometry(), a, b);
    const SurfacePath back = shortestPath(surface_.geometry(), b, a);
    expectOnSurface(mesh_, there);
    expectOnSurface(mesh_, back);
    expect(std::abs(there.length() - back.length()) <= kSame * diagonal,
           "a shortest path is longer back, by " +
               inSentence((back.length() - there.length()) / diagonal) + " of the diagonal");
    const double straight = (position(mesh_, a) - position(mesh_, b)).norm();
    expect(there.length() >= straight - kSame * diagonal, "a path is shorter than a straight line");
    FindPathWorkspace workspace;
    SurfacePath found;
    SurfacePath foundBack;
    expect(findPath(surface_.geometry(), a, b, workspace, found) &&
               findPath(surface_.geometry(), b, a, workspace, foundBack),
           "no path is found");
    expectOnSurface(mesh_, found);
    expect(std::abs(found.length() - foundBack.length()) <= kSame * diagonal,
           "a path that was found is longer back");
    expect(found.length() >= there.length() - kSame * diagonal,
           "a path is shorter than the shortest, by " +
               inSentence((there.length() - found.length()) / diagonal) + " of the diagonal");
  }

  void edit(Curve& curve) {
    const int what = bytes_.index(12);
    const int i = bytes_.index(curve.pointCount());
    const SurfacePoint point = readPoint(bytes_, mesh_);
    const double value = std::pow(100, 2 * bytes_.unit() - 1);
    switch (what) {
      case 0:
        return curve.insertPoint(i, point);
      case 1:
        return curve.removePoint(i);
      case 2:
        return curve.movePointInOrder(i, bytes_.index(curve.pointCount()));
      case 3:
        return curve.reverse();
      case 4:
        return curve.setKind(kCurveKinds[bytes_.index(6)]);
      case 5:
        return curve.setClosed(!curve.shape().closed);
      case 6:
        return curve.setWeight(i, value);
      case 7:
        return curve.setBeta(i, value);
      case 8:
        return curve.dragPoint(i, point);
      case 9: {
        CurveValue next = curve.value();
        next.options = readOptions(bytes_, curve.pointCount());
        return curve.set(next);
      }
      default:
        return curve.movePoint(i, point);
    }
  }

  void check(Curve& curve) {
    for (int j = 0; j < curve.segmentCount(); ++j) {
      const Array<CurveSample>& samples = curve.samples(j);
      expect(samples.count() >= 2, "a segment of fewer than two samples");
      for (int i = 0; i < samples.count(); ++i) {
        expectOnSurface(mesh_, samples[i].point);
        expect(i == 0 || samples[i].t > samples[i - 1].t, "samples that are not in order");
      }
      expectOnSurface(mesh_, SurfacePath(curve.path(j).line));
      for (const Bridge& bridge : curve.bridges(j)) expectOnSurface(mesh_, bridge.line.path);
    }
    for (const SurfacePath& leg : curve.legs()) expectOnSurface(mesh_, leg);
  }

  void checkSameAnew(Curve& curve) {
    CurveValue value = curve.value();
    // A curve keeps numbers that only another kind uses, but a caller cannot set them.
    CurveShape& shape = value.options.shape;
    if (!takesWeights(shape.kind)) shape.weights.clear();
    if (!takesBetas(shape.kind)) shape.betas.clear();
    if (shape.kind != CurveKind::kBSpline) shape.knotRule = KnotRule::kUniform;
    Curve anew(surface_, value);
    expect(anew.segmentCount() == curve.segmentCount() && anew.levels() == curve.levels(),
           "edits change the segments");
    for (int j = 0; j < curve.segmentCount(); ++j) {
      const Array<CurveSample>& a = curve.samples(j);
      const Array<CurveSample>& b = anew.samples(j);
      expect(a.count() == b.count(), "edits change the number of samples");
      for (int i = 0; i < a.count(); ++i) {
        const double apart = (position(mesh_, a[i].point) - position(mesh_, b[i].point)).norm();
        expect(apart <= kSame * surface_.geometry().diagonal && a[i].status == b[i].status,
               "an edited curve is not the one traced anew: " +
                   inSentence(apart / surface_.geometry().diagonal) + " of the diagonal apart");
      }
    }
  }

  Surface& surface_;
  const TriangleMesh& mesh_;
  FuzzBytes& bytes_;
};

}  // namespace

void fuzzCurve(Bytes given) {
  FuzzBytes bytes(given);
  const int mesh = bytes.index(12);
  if (mesh < 7) return CurveCase(shapeOf(mesh), bytes).run();
  Surface surface(importMesh(sheet(bytes)).mesh);
  CurveCase(surface, bytes).run();
}

}  // namespace karcher

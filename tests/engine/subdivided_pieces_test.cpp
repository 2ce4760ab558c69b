#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "curve_support.h"
#include "curves/curve.h"
#include "curves/spec/bases.h"
#include "generators/plane.h"
#include "support.h"

/// Pieces over slivers from rim to rim become their subdivision. A strip is flat whether folded or
/// rolled, so that the correct curve is that of the unrolled strip.
namespace karcher {
namespace {

/// A strip of the plane from rim to rim, 1 wide, cut at these x into pairs of slivers.
struct Strip {
  Array<double> cuts;

  /// The mesh with the strip placed by `place`. Vertices 2 i and 2 i + 1 lie on the lower and the
  /// upper rim at cut i.
  template <class Place>
  TriangleMesh mesh(const Place& place) const {
    TriangleSoup soup;
    for (int i = 0; i < cuts.count(); ++i) {
      soup.positions.push_back(place(cuts[i], 0.0));
      soup.positions.push_back(place(cuts[i], 1.0));
      if (i == cuts.count() - 1) break;
      soup.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
      soup.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    return meshOf(soup);
  }

  SurfacePoint pointAt(const Vec2& place) const {
    const auto after = std::upper_bound(cuts.begin(), cuts.end(), place.x());
    const int i = static_cast<int>(after - cuts.begin()) - 1;
    const double u = (place.x() - cuts[i]) / (cuts[i + 1] - cuts[i]);
    const double v = place.y();
    if (v <= u) return {2 * i, Vec3(1 - u, u - v, v)};
    return {2 * i + 1, Vec3(1 - v, u, v - u)};
  }

  Array<SurfacePoint> pointsAt(const Array<Vec2>& places) const {
    Array<SurfacePoint> points;
    for (const Vec2& place : places) points.push_back(pointAt(place));
    return points;
  }

  Vec2 placeOf(const TriangleMesh& mesh, const SurfacePoint& point) const {
    Vec2 place = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh.corner(point.face, k);
      place += point.bary[k] * Vec2(cuts[vertex / 2], vertex % 2);
    }
    return place;
  }
};

constexpr double kLength = 3;

Strip evenStrip(int pairs) {
  Strip strip;
  for (int i = 0; i <= pairs; ++i) strip.cuts.push_back(kLength * i / pairs);
  return strip;
}

constexpr int kPairs = 12'000;

Vec3 flat(double x, double y) { return {x, y, 0}; }

/// Two thirds of a turn around a cylinder with as many planes as there are pairs.
Vec3 rolled(double x, double y) {
  const double side = 4 * std::numbers::pi / 3 / kPairs;
  const double radius = kLength / kPairs / 2 / std::sin(side / 2);
  const double angle = x * kPairs / kLength * side;
  return {radius * std::cos(angle), radius * std::sin(angle), y};
}

/// A bar with a square section, folded along edges.
Vec3 folded(double x, double y) {
  const Vec2 kCorners[] = {{0, 0}, {0.75, 0}, {0.75, 0.75}, {0, 0.75}};
  const double side = 0.75;
  const int k = std::min(static_cast<int>(x / side + 1e-9), 3);
  const Vec2 along = (kCorners[(k + 1) % 4] - kCorners[k]) / side;
  const Vec2 place = kCorners[k] + (x - k * side) * along;
  return {place.x(), place.y(), y};
}

/// Waves, which are not flat.
Vec3 waved(double x, double y) { return {x, y, 0.3 * std::sin(3 * x) * (0.5 + y)}; }

/// Waves with slivers in one half and even triangles in the other.
TriangleMesh halfSlivers() {
  constexpr int kSlivers = 3000;
  constexpr int kRows = 12;
  TriangleSoup soup;
  const auto addColumn = [&](double x, int rows) {
    const int first = soup.positions.count();
    for (int row = 0; row <= rows; ++row) {
      soup.positions.push_back(waved(x, static_cast<double>(row) / rows));
    }
    return first;
  };
  for (int i = 0; i < kSlivers; ++i) {
    const int from = addColumn(kLength / 2 * i / kSlivers, 1);
    if (i + 1 < kSlivers) {
      soup.triangles.push_back({from, from + 2, from + 3});
      soup.triangles.push_back({from, from + 3, from + 1});
      continue;
    }
    // The last column fans out to the first column of the even half.
    const int to = from + 2;
    for (int row = 0; row < kRows; ++row) {
      soup.triangles.push_back({from, to + row, to + row + 1});
    }
    soup.triangles.push_back({from, to + kRows, from + 1});
  }
  constexpr int kColumns = 18;
  for (int i = 0; i <= kColumns; ++i) {
    const int from = addColumn(kLength / 2 * (1 + static_cast<double>(i) / kColumns), kRows);
    const int to = from + kRows + 1;
    for (int row = 0; row < kRows && i < kColumns; ++row) {
      soup.triangles.push_back({from + row, to + row, to + row + 1});
      soup.triangles.push_back({from + row, to + row + 1, from + row + 1});
    }
  }
  return meshOf(soup);
}

const Array<Vec2> kControls{{0.31, 0.22}, {1.13, 0.83}, {1.92, 0.31}, {2.61, 0.74}};

/// Automatic levels, but at least three: a curve without levels has no subdivided pieces.
CurveOptions automatic(CurveKind kind) {
  CurveOptions options{CurveShape{kind}, 65, kFast};
  options.levels = kAutomaticLevels;
  options.leastLevels = 3;
  if (kind == CurveKind::kRational) options.shape.weights = {1, 2.5, 0.6, 1.3};
  return options;
}

int subdividedPieces(const Curve& curve) {
  int count = 0;
  for (int j = 0; j < curve.segmentCount(); ++j) {
    for (int k = 0; k < curve.piecesPerSegment(); ++k) {
      count += curve.piece(j, k).isSubdivided() ? 1 : 0;
    }
  }
  return count;
}

TEST(SubdividedPieces, OverSliversOfAPlaneTheyAreTheCurveOfThePlane) {
  const struct {
    const char* name;
    Vec3 (*place)(double, double);
  } kShapes[] = {{"flat", flat}, {"rolled", rolled}, {"folded", folded}};
  const Strip strip = evenStrip(kPairs);
  for (const auto& [name, place] : kShapes) {
    Surface surface(strip.mesh(place));
    for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kRational}) {
      SCOPED_TRACE(std::string(name) + " " + curveKindName(kind));
      const Curve curve(surface, automatic(kind), strip.pointsAt(kControls));
      EXPECT_GT(subdividedPieces(curve), 0);
      SCOPED_TRACE("levels " + std::to_string(curve.levels()));
      double worst = 0;
      for (const CurveSample& sample : curve.samples(0)) {
        Array<double> weights = bernsteinBasis(3, sample.t);
        if (kind == CurveKind::kRational) {
          for (int i = 0; i < 4; ++i) weights[i] *= curve.shape().weights[i];
        }
        Vec2 expected = Vec2::Zero();
        double sum = 0;
        for (int i = 0; i < 4; ++i) {
          expected += weights[i] * kControls[i];
          sum += weights[i];
        }
        const Vec2 found = strip.placeOf(surface.mesh(), sample.point);
        worst = std::max(worst, (found - expected / sum).norm());
      }
      EXPECT_LT(worst, 1e-9);
    }
  }
}

TEST(SubdividedPieces, MeetTheirNeighboursAndReportTheReason) {
  // The points are far from the rims, as the handles of a Catmull-Rom curve must lie on the strip.
  Array<Vec3> places;
  for (const Vec2& place : kControls) places.push_back(waved(place.x(), 0.35 + 0.3 * place.y()));
  for (const bool isEven : {true, false}) {
    SCOPED_TRACE(isEven ? "slivers" : "slivers in a half");
    Surface surface(isEven ? evenStrip(kPairs / 2).mesh(waved) : halfSlivers());
    const Array<SurfacePoint> points = pointsNear(surface.mesh(), places);
    const TriangleMesh& mesh = surface.mesh();
    for (const CurveKind kind :
         {CurveKind::kBezier, CurveKind::kRational, CurveKind::kCatmullRom}) {
      SCOPED_TRACE(curveKindName(kind));
      const Curve curve(surface, automatic(kind), points);
      SCOPED_TRACE("levels " + std::to_string(curve.levels()));
      ASSERT_GT(subdividedPieces(curve), 0);
      if (!isEven) {
        EXPECT_LT(subdividedPieces(curve), curve.segmentCount() * curve.piecesPerSegment());
      }
      Vec3 end = position(mesh, curve.point(0));
      for (int j = 0; j < curve.segmentCount(); ++j) {
        for (int k = 0; k < curve.piecesPerSegment(); ++k) {
          const Curve::Piece& piece = curve.piece(j, k);
          const Array<CurveSample>& samples = piece.samples();
          EXPECT_LT((position(mesh, samples.front().point) - end).norm(),
                    (j + k == 0 ? 1e-2 : 1e-9) * surface.geometry().diagonal);
          end = position(mesh, samples.back().point);
          if (!piece.isSubdivided()) {
            for (const CurveSample& sample : samples) {
              EXPECT_NE(sample.status, SampleStatus::kSubdivided);
            }
            continue;
          }
          ASSERT_EQ(piece.bridges().count(), 1);
          EXPECT_EQ(piece.bridges()[0].reason, SampleStatus::kSubdivided);
          EXPECT_EQ(piece.bridges()[0].t0, 0);
          EXPECT_EQ(piece.bridges()[0].t1, 1);
          for (int i = 1; i + 1 < samples.count(); ++i) {
            EXPECT_EQ(samples[i].status, SampleStatus::kSubdivided);
          }
        }
        // The segment has the same reason.
        const bool isSaid = std::any_of(
            curve.bridges(j).begin(), curve.bridges(j).end(),
            [](const Bridge& bridge) { return bridge.reason == SampleStatus::kSubdivided; });
        bool isSubdivided = false;
        for (int k = 0; k < curve.piecesPerSegment(); ++k) {
          isSubdivided = isSubdivided || curve.piece(j, k).isSubdivided();
        }
        EXPECT_EQ(isSaid, isSubdivided);
        const Array<SurfacePoint>& line = curve.path(j).line.points;
        for (int i = 1; i < line.count(); ++i) {
          EXPECT_TRUE(haveCommonFace(mesh, line[i - 1], line[i]));
        }
      }
    }
  }
}

TEST(SubdividedPieces, AreAbsentForGivenLevelsAndBSplines) {
  SKIP_WHERE_SANITIZED();
  const Strip strip = evenStrip(kPairs / 2);
  const Array<SurfacePoint> points = strip.pointsAt(kControls);
  Surface surface(strip.mesh(waved));
  CurveOptions options = automatic(CurveKind::kBezier);
  EXPECT_GT(subdividedPieces(Curve(surface, options, points)), 0);
  options.levels = 4;
  EXPECT_EQ(subdividedPieces(Curve(surface, options, points)), 0);
  options = automatic(CurveKind::kBSpline);
  EXPECT_EQ(subdividedPieces(Curve(surface, options, points)), 0);
}

TEST(SubdividedPieces, AreAbsentOnAFineEvenMesh) {
  Surface surface(meshOf(tessellatedPlane(PlaneTessellation::kRandomDelaunay, 2000, 7)));
  for (const CurveKind kind : {CurveKind::kBezier, CurveKind::kRational, CurveKind::kCatmullRom}) {
    SCOPED_TRACE(curveKindName(kind));
    Array<Vec3> places(kPlaces.begin(), kPlaces.begin() + 4);
    const Curve curve(surface, automatic(kind), pointsNear(surface.mesh(), places));
    EXPECT_EQ(subdividedPieces(curve), 0);
  }
}

}  // namespace
}  // namespace karcher

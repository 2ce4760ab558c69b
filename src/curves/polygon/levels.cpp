#include "curves/polygon/levels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "intrinsic/straighten.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// The largest number of averages in one curve. Every step of a drag computes all averages.
constexpr double kMostAverages = 1e6;

bool isBezier(CurveKind kind) { return kind == CurveKind::kBezier || kind == CurveKind::kRational; }

/// Finds the averages on the legs of the workspace's row. `share(i)` is the later point's share on
/// leg i.
template <class Share>
void findAverages(const TriangleMesh& mesh, const Share& share, AveragingWorkspace& workspace) {
  const LeggedPolygon& row = workspace.row;
  workspace.averages.clear();
  for (int i = 0; i + 1 < row.points.count(); ++i) {
    const double s = share(i);
    workspace.averages.push_back(
        averageOn(mesh, row.legs[i], (1 - s) * row.points[i].weight, s * row.points[i + 1].weight));
  }
}

/// Replaces the row by the averages on its legs. The new row has one point fewer.
void replaceByAverages(const Geometry& geometry, AveragingWorkspace& workspace) {
  const Array<LegAverage>& averages = workspace.averages;
  Array<SurfacePath>& legs = workspace.row.legs;
  for (int i = 0; i + 1 < averages.count(); ++i) {
    Chain chain(*geometry.mesh, workspace.inner);
    chain.append(legs[i], averages[i].at, legs[i].length());
    chain.append(legs[i + 1], 0, averages[i + 1].at);
    straighten(geometry, workspace.inner, workspace.strip);
    std::swap(legs[i], workspace.inner);
  }
  workspace.row.points.clear();
  for (const LegAverage& average : averages) workspace.row.points.push_back(average.point);
}

// Bezier curves.

/// The numbers of points, legs and pieces that a refined polygon has so far.
struct Written {
  int points = 0;
  int legs = 0;
  int pieces = 0;
};

void appendPiece(const LeggedPolygon& polygon, RefinedPolygon& out, Written& written) {
  const int degree = polygon.points.count() - 1;
  // A piece starts at the end of the previous one.
  const int first = std::max(written.points - 1, 0);
  SegmentLayout& layout = out.pieces[written.pieces++];
  layout.basis = {BasisForm::kBernstein, degree};
  layout.basis.points = degree + 1;
  layout.points.clear();
  for (int k = 0; k <= degree; ++k) {
    layout.points.push_back(first + k);
    out.points[first + k] = polygon.points[k];
  }
  written.points = first + degree + 1;
  for (const SurfacePath& leg : polygon.legs) out.legs[written.legs++] = leg;
}

void appendPieces(const Geometry& geometry, const LeggedPolygon& polygon, int levels,
                  AveragingWorkspace& workspace, RefinedPolygon& out, Written& written) {
  if (levels == 0) {
    appendPiece(polygon, out, written);
    return;
  }
  BezierHalves& halves = workspace.halves[levels - 1];
  halve(geometry, polygon, workspace, halves);
  appendPieces(geometry, halves.first, levels - 1, workspace, out, written);
  appendPieces(geometry, halves.second, levels - 1, workspace, out, written);
}

/// Sizes the lists for the pieces of `curves` Bezier curves of degree `degree`.
void makeRoom(int curves, int degree, int levels, AveragingWorkspace& workspace,
              RefinedPolygon& out) {
  const auto pieces = static_cast<size_t>(curves) << levels;
  const auto legs = pieces * static_cast<size_t>(degree);
  out.pieces.resize(pieces);
  out.legs.resize(legs);
  out.points.resize(legs + 1);
  if (workspace.halves.count() < levels) workspace.halves.resize(static_cast<size_t>(levels));
}

}  // namespace

bool takesLevels(CurveKind kind) {
  return kind == CurveKind::kBSpline || isBezier(kind) || kind == CurveKind::kCatmullRom;
}

void checkLevels(const CurveShape& shape, int points, int levels) {
  if (levels < 0 || levels > kMostLevels) {
    throw Error(ErrorCode::kBadArgument, "a curve takes 0 to " + std::to_string(kMostLevels) +
                                             " levels, not " + std::to_string(levels));
  }
  if (levels == 0) return;
  if (!takesLevels(shape.kind)) {
    throw Error(ErrorCode::kBadArgument,
                std::string("a curve of the kind '") + curveKindName(shape.kind) +
                    "' takes no levels: it cannot be subdivided by averages of two points");
  }
  if (!mayTakeLevels(shape, points, levels)) {
    throw Error(ErrorCode::kBadArgument, "a curve of this kind with " + std::to_string(points) +
                                             " points takes fewer than " + std::to_string(levels) +
                                             " levels");
  }
}

bool mayTakeLevels(const CurveShape& shape, int points, int levels) {
  if (levels == 0) return true;
  if (levels < 0 || levels > kMostLevels || !takesLevels(shape.kind)) return false;
  const double legs = legCount(shape, points);
  const double averages = (isBezier(shape.kind) ? legs * legs : 6 * legs) * std::ldexp(1, levels);
  return averages <= kMostAverages;
}

bool refinePolygon(const Geometry& geometry, const CurveShape& shape,
                   const Array<SurfacePoint>& points, const Array<SurfacePath>& legs, int levels,
                   AveragingWorkspace& workspace, RefinedPolygon& refined) {
  LeggedPolygon& whole = workspace.polygon;
  whole.points.clear();
  const bool hasWeights = takesWeights(shape.kind) && !shape.weights.empty();
  for (int i = 0; i < points.count(); ++i) {
    whole.points.push_back({points[i], hasWeights ? shape.weights[i] : 1});
  }
  if (shape.kind == CurveKind::kBSpline) {
    SplineWorkspace& spline = workspace.spline;
    refineSpline(geometry, shape, whole.points, legs, levels, workspace.strip, spline);
    refined.points = spline.levels.back().points;
    refined.legs = spline.levels.back().legs;
    refined.pieces = spline.pieces;
  } else {
    Written written;
    if (isBezier(shape.kind)) {
      // A closed curve ends at its first point.
      if (shape.closed) whole.points.push_back(WeightedPoint(whole.points[0]));
      whole.legs = legs;
      makeRoom(1, legs.count(), levels, workspace, refined);
      appendPieces(geometry, whole, levels, workspace, refined, written);
    } else {
      if (!findHandles(geometry, shape, points, legs, workspace.handles)) return false;
      makeRoom(legs.count(), 3, levels, workspace, refined);
      for (int j = 0; j < legs.count(); ++j) {
        takeBezierPolygon(geometry, points, legs, j, workspace.strip, workspace.handles, whole);
        appendPieces(geometry, whole, levels, workspace, refined, written);
      }
    }
    if (shape.closed) {
      // Both ends of a closed curve use the same point of the polygon, so that both find the same
      // zero of this point's field.
      refined.pieces.back().points.back() = 0;
      refined.points.pop_back();
    }
  }
  refined.weighted = hasWeights;
  return true;
}

void halve(const Geometry& geometry, const LeggedPolygon& polygon, AveragingWorkspace& workspace,
           BezierHalves& halves) {
  const TriangleMesh& mesh = *geometry.mesh;
  auto& [first, second] = halves;
  const int degree = polygon.legs.count();
  for (LeggedPolygon* half : {&first, &second}) {
    half->points.resize(polygon.points.size());
    half->legs.resize(polygon.legs.size());
  }
  LeggedPolygon& row = workspace.row;
  row = polygon;
  first.points[0] = row.points.front();
  second.points[degree] = row.points.back();
  for (int k = 0; k < degree; ++k) {
    findAverages(
        mesh, [](int) { return 0.5; }, workspace);
    const SurfacePath& last = row.legs[degree - 1 - k];
    takePart(mesh, row.legs[0], 0, workspace.averages.front().at, first.legs[k]);
    takePart(mesh, last, workspace.averages.back().at, last.length(), second.legs[degree - 1 - k]);
    replaceByAverages(geometry, workspace);
    first.points[k + 1] = row.points.front();
    second.points[degree - 1 - k] = row.points.back();
  }
}

void takePolygon(const RefinedPolygon& refined, const SegmentLayout& piece,
                 LeggedPolygon& polygon) {
  polygon.points.clear();
  polygon.legs.resize(piece.points.size() - 1);
  for (int k = 0; k < piece.points.count(); ++k) {
    polygon.points.push_back(refined.points[piece.points[k]]);
    if (!refined.weighted) polygon.points.back().weight = 1;
    if (k > 0) polygon.legs[k - 1] = refined.legs[piece.points[k - 1]];
  }
}

SurfacePoint averageAt(const Geometry& geometry, const SegmentBasis& basis,
                       const LeggedPolygon& polygon, double t, AveragingWorkspace& workspace) {
  const int degree = polygon.legs.count();
  const auto knot = [&](int k) {
    return basis.form == BasisForm::kBSpline ? basis.numbers[k] : k - degree;
  };
  workspace.row = polygon;
  for (int row = 1; row <= degree; ++row) {
    const auto share = [&](int i) {
      if (basis.form == BasisForm::kBernstein) return t;
      const double left = knot(i + row);
      return (t - left) / (knot(i + degree + 1) - left);
    };
    findAverages(*geometry.mesh, share, workspace);
    replaceByAverages(geometry, workspace);
  }
  return workspace.row.points[0].point;
}

}  // namespace karcher

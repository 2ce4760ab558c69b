#include "curves/polygon/deviation.h"

#include <algorithm>
#include <cmath>

#include "curves/polygon/convexity.h"
#include "intrinsic/angles.h"
#include "intrinsic/tangent.h"

namespace karcher {
namespace {

/// The number of equal intervals of a segment's parameter. The deviation is computed at their ends.
constexpr int kParts = 8;

/// The vector turned to the right.
Vec2 turned(const Vec2& v) { return {v.y(), -v.x()}; }

/// The mean curvature per area along a leg.
double meanAlong(const Geometry& geometry, const SurfacePath& leg) {
  double sum = 0;
  for (int i = 1; i < leg.points.count(); ++i) {
    const int face = commonFace(*geometry.mesh, leg.points[i - 1], leg.points[i]);
    if (face < 0) continue;
    sum += curvatureOf(geometry, face) * (leg.lengths[i] - leg.lengths[i - 1]);
  }
  return leg.length() > 0 ? sum / leg.length() : 0;
}

/// The angle by which a leg turns from the straight continuation of the previous leg. Both need a
/// length.
double turningBetween(const Geometry& geometry, const SurfacePath& before,
                      const SurfacePath& after) {
  const Vec2 on = -logBack(geometry, before);
  const Vec2 next = logAlong(geometry, after);
  return angleFromTo(on, next);
}

void unroll(const Geometry& geometry, const Array<SurfacePath>& legs, const SegmentLayout& segment,
            Array<Vec2>& unrolled) {
  unrolled.assign(1, Vec2(0, 0));
  double heading = 0;
  const SurfacePath* before = nullptr;
  for (int k = 1; k < segment.points.count(); ++k) {
    const SurfacePath& leg = legs[segment.points[k - 1]];
    // A leg without length, at a repeated point, has no direction.
    if (leg.length() > 0) {
      if (before) heading += turningBetween(geometry, *before, leg);
      before = &leg;
    }
    const Vec2 way(std::cos(heading), std::sin(heading));
    unrolled.push_back(Vec2(unrolled.back() + leg.length() * way));
  }
}

/// The share of the later point in an average of the pyramid. Row 1 averages the control points.
double shareAt(const SegmentBasis& basis, int degree, int row, int i, double t) {
  if (basis.form == BasisForm::kBernstein || basis.form == BasisForm::kCatmullRom) return t;
  const auto knot = [&](int k) {
    return basis.form == BasisForm::kBSpline ? basis.numbers[k] : k - degree;
  };
  const double left = knot(i + row);
  return (t - left) / (knot(i + degree + 1) - left);
}

/// A handle of a Catmull-Rom curve, and its move by the curvature.
struct Handle {
  Vec2 point;
  Vec2 move;
};

/// Replaces the points of a Catmull-Rom curve's span by its Bezier polygon (through_points.h).
void takeHandles(const SegmentBasis& basis, double curvature, DeviationWorkspace& workspace) {
  Array<Vec2>& row = workspace.row;
  const auto log = [&](const Vec2& p, const Vec2& q) {
    const Vec2 way = q - p;
    return Handle{way, curvature / 3 * cross(p, q) * turned(way)};
  };
  const bool isFirst = !basis.folds.empty() && basis.folds[0].to == 0 && basis.folds[0].factor == 2;
  const int start = isFirst ? 0 : 1;
  const Vec2 p = row[start];
  const Vec2 q = row[start + 1];
  const double spans[] = {-basis.numbers[0], basis.numbers[3] - 1};
  // The handle from `at` towards `other`; `beyond` is the point on the other side of `at`, if any.
  const auto handle = [&](const Vec2& at, const Vec2& other, const Vec2* beyond, double span) {
    Handle way = log(at, other);
    if (beyond) {
      const Handle back = log(at, *beyond);
      const double sum = 1 + span;
      way.point = (span * way.point - back.point / span) / sum;
      way.move = (span * way.move - back.move / span) / sum;
    }
    way.point /= 3;
    way.move /= 3;
    const Vec2 move = way.move - curvature / 3 * cross(at, way.point) * turned(way.point);
    return Handle{at + way.point, move};
  };
  const bool isLast = start + 2 >= row.count();
  const Handle after = handle(p, q, isFirst ? nullptr : &row[start - 1], spans[0]);
  const Handle before = handle(q, p, isLast ? nullptr : &row[start + 2], spans[1]);
  row.assign({p, after.point, before.point, q});
  workspace.moves.assign({Vec2(0, 0), after.move, before.move, Vec2(0, 0)});
}

/// The distance by which the curvature moves the point of the subdivision curve at t from the
/// center of mass.
double moveAt(const SegmentBasis& basis, const Array<double>& pointWeights, double curvature,
              double t, DeviationWorkspace& workspace) {
  const Array<Vec2>& unrolled = workspace.unrolled;
  weightsAt(basis, pointWeights, t, workspace.weights);
  Vec2 center(0, 0);
  for (int k = 0; k < unrolled.count(); ++k) center += workspace.weights[k] * unrolled[k];
  Array<Vec2>& row = workspace.row;
  row.clear();
  for (const Vec2& p : unrolled) row.push_back(Vec2(p - center));
  Array<Vec2>& moves = workspace.moves;
  moves.assign(row.size(), Vec2(0, 0));
  if (basis.form == BasisForm::kCatmullRom) takeHandles(basis, curvature, workspace);
  Array<double>& weights = workspace.rowWeights;
  weights = pointWeights;
  weights.resize(row.size(), 1);
  const int degree = row.count() - 1;
  for (int j = 1; j <= degree; ++j) {
    for (int i = 0; i + j <= degree; ++i) {
      const double share = shareAt(basis, degree, j, i, t);
      const double weight = (1 - share) * weights[i] + share * weights[i + 1];
      const double s = share * weights[i + 1] / weight;
      const Vec2 way = row[i + 1] - row[i];
      moves[i] = (1 - s) * moves[i] + s * moves[i + 1] +
                 curvature / 3 * s * (1 - s) * cross(row[i], row[i + 1]) * turned(way);
      row[i] += s * way;
      weights[i] = weight;
    }
  }
  return moves[0].norm();
}

}  // namespace

double segmentDeviation(const Geometry& geometry, const Array<SurfacePath>& legs,
                        const SegmentLayout& segment, const Array<double>& pointWeights,
                        DeviationWorkspace& workspace) {
  double curvature = 0;
  for (int k = 1; k < segment.points.count(); ++k) {
    const SurfacePath& leg = legs[segment.points[k - 1]];
    curvature = std::max(curvature, std::abs(meanAlong(geometry, leg)));
  }
  if (curvature == 0) return 0;
  unroll(geometry, legs, segment, workspace.unrolled);
  double most = 0;
  for (int part = 1; part < kParts; ++part) {
    const double t = static_cast<double>(part) / kParts;
    most = std::max(most, moveAt(segment.basis, pointWeights, curvature, t, workspace));
  }
  return most;
}

}  // namespace karcher

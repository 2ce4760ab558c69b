#include "curves/automatic_levels.h"

#include <algorithm>
#include <cmath>

#include "distance/sight.h"
#include "intrinsic/straighten.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "rcm/field_blend.h"

namespace karcher {
namespace {

/// The least convexity of a safe piece: half the convexity in the plane. On the sphere, the squared
/// distance from a point has this convexity at 67 degrees from the point.
constexpr double kLeastConvexity = 0.5;

/// The largest detail (`detailAlong`) of a leg of a safe piece, in radians. In the study of
/// steadiness, curves with more detail turn visibly more than the subdivision curve.
constexpr double kMostDetail = 0.2;

/// The largest number of edges that legs cross at `quickLevels`, as a root mean square. A leg
/// across so many edges is about three edge lengths long.
constexpr double kFewEdges = 9;

/// The factor that adds a margin to an estimated deviation, which may be a third too low.
constexpr double kDeviationMargin = 1.5;

/// The length of a leg that levels subdivide, relative to a leg of the control polygon. In a
/// Catmull-Rom curve, levels subdivide the legs of its Bezier polygons, which are a third as long.
double partOfLeg(const CurveShape& shape) {
  return shape.kind == CurveKind::kCatmullRom ? 1.0 / 3 : 1;
}

/// The number of legs of a piece's polygon.
int legsOfPiece(const CurveShape& shape, int points) {
  if (shape.kind == CurveKind::kBSpline) return shape.degree;
  return shape.kind == CurveKind::kCatmullRom ? 3 : points - 1;
}

/// The root mean square of the number of edges that a leg crosses after these levels.
double edgesOfLeg(const CurveShape& shape, const Array<SurfacePath>& legs, int levels) {
  double squares = 0;
  for (const SurfacePath& leg : legs) {
    const double edges = partOfLeg(shape) * leg.points.count();
    squares += edges * edges / legs.count();
  }
  return std::ldexp(std::sqrt(squares), -levels);
}

/// Writes the weights of a piece's points; none if the points have no weights.
void takeWeights(const RefinedPolygon& polygon, const SegmentLayout& piece,
                 Array<double>& weights) {
  weights.clear();
  if (!polygon.weighted) return;
  for (const int point : piece.points) weights.push_back(polygon.points[point].weight);
}

/// A segment with one point for each weight of its basis, as the segment goes along the legs: all
/// around a closed curve, a point occurs several times. Writes to `copy` if that is another
/// segment. The imaginary point beyond an open end has no leg, so its segment stays.
const SegmentLayout& unfolded(const SegmentLayout& segment, SegmentLayout& copy) {
  const Array<SegmentBasis::Fold>& folds = segment.basis.folds;
  const auto isOfMany = [](const SegmentBasis::Fold& fold) { return fold.factor != 1; };
  if (folds.empty() || std::any_of(folds.begin(), folds.end(), isOfMany)) return segment;
  copy.points.clear();
  for (const SegmentBasis::Fold& fold : folds) copy.points.push_back(segment.points[fold.to]);
  copy.basis = segment.basis;
  copy.basis.folds.clear();
  copy.basis.points = copy.points.count();
  return copy;
}

}  // namespace

bool isSafe(const Geometry& geometry, const RefinedPolygon& polygon, LevelsWorkspace& workspace) {
  const auto hasDetail = [&](const SurfacePath& leg) {
    return detailAlong(geometry, leg) > kMostDetail;
  };
  if (std::any_of(polygon.legs.begin(), polygon.legs.end(), hasDetail)) return false;
  return std::all_of(polygon.pieces.begin(), polygon.pieces.end(),
                     [&](const SegmentLayout& folded) {
                       const SegmentLayout& piece = unfolded(folded, workspace.unfolded);
                       takeWeights(polygon, piece, workspace.weights);
                       return leastConvexity(geometry, polygon.legs, piece, workspace.weights,
                                             workspace.convexity) >= kLeastConvexity;
                     });
}

bool areFramesTurned(const Geometry& geometry, const Array<SurfacePath>& legs) {
  for (const SurfacePath& leg : legs) {
    for (int i = 1; i < leg.points.count(); ++i) {
      const int face = commonFace(*geometry.mesh, leg.points[i - 1], leg.points[i]);
      if (face >= 0 && hasTurnedFrame(geometry, face)) return true;
    }
  }
  return false;
}

int levelsToSafety(const Geometry& geometry, const CurveShape& shape, int points,
                   const Array<SurfacePath>& legs) {
  double detail = 0;
  for (const SurfacePath& leg : legs) detail = std::max(detail, detailAlong(geometry, leg));
  // Each level halves the legs. The detail grows with the square of a leg's length, so that each
  // level divides it by 4.
  detail *= partOfLeg(shape) * partOfLeg(shape);
  int levels = 0;
  while (mayTakeLevels(shape, points, levels + 1) &&
         (levels == 0 || std::ldexp(detail, -2 * levels) > kMostDetail)) {
    ++levels;
  }
  return levels;
}

bool arePiecesInSight(const CurveShape& shape, int points, const Array<SurfacePath>& legs,
                      int levels) {
  return edgesOfLeg(shape, legs, levels) * legsOfPiece(shape, points) <= kMostFacesOfSight;
}

bool areFieldsNear(const CurveShape& shape, int points, const Array<SurfacePath>& legs,
                   int levels) {
  if (levels == 0) return false;
  return arePiecesInSight(shape, points, legs, levels) || !mayTakeLevels(shape, points, levels + 1);
}

int quickLevels(const CurveShape& shape, int points, const Array<SurfacePath>& legs) {
  int levels = 0;
  while (mayTakeLevels(shape, points, levels + 1) &&
         (edgesOfLeg(shape, legs, levels) > kFewEdges ||
          !arePiecesInSight(shape, points, legs, levels))) {
    ++levels;
  }
  return levels;
}

double levelsDeviation(const Geometry& geometry, const RefinedPolygon& polygon,
                       LevelsWorkspace& workspace) {
  double most = 0;
  for (const SegmentLayout& folded : polygon.pieces) {
    const SegmentLayout& segment = unfolded(folded, workspace.unfolded);
    takeWeights(polygon, segment, workspace.weights);
    most = std::max(most, segmentDeviation(geometry, polygon.legs, segment, workspace.weights,
                                           workspace.deviation));
  }
  return kDeviationMargin * most;
}

double tightLength(const Geometry& geometry, const RefinedPolygon& polygon,
                   const SegmentLayout& segment, int from, int to, LevelsWorkspace& workspace) {
  Chain chain(*geometry.mesh, workspace.tight);
  for (int k = from; k < to; ++k) chain.append(polygon.legs[segment.points[k]]);
  straighten(geometry, workspace.tight, workspace.strip);
  return workspace.tight.length();
}

int levelsToLimit(const Geometry& geometry, const CurveShape& shape, int points,
                  const Array<SurfacePath>& legs) {
  double longest = 0;
  for (const SurfacePath& leg : legs) longest = std::max(longest, leg.length());
  int levels = mayTakeLevels(shape, points, 2) ? 2 : 0;
  while (levels > 0 && mayTakeLevels(shape, points, levels + 1) &&
         std::ldexp(longest, -levels) > 2 * geometry.meanEdge) {
    ++levels;
  }
  return levels;
}

}  // namespace karcher

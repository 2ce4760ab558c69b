#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "curves/automatic_levels.h"
#include "curves/curve.h"

// The levels of a curve, and the polygon of its pieces.
namespace karcher {
namespace {

/// A field's distance and the length of a path count as equal up to this relative difference, which
/// is twice the usual largest error of fast fields.
constexpr double kSameLength = 0.02;

/// The mean edge of a point's face.
double edgeAt(const Geometry& geometry, const SurfacePoint& point) {
  const int h = 3 * point.face;
  const Array<double>& lengths = geometry.edgeLength;
  return (lengths[h] + lengths[h + 1] + lengths[h + 2]) / 3;
}

}  // namespace

/// The control polygon itself, without legs. Its pieces are the segments.
void Curve::takeControlPolygon(const CurveValue& value, RefinedPolygon& polygon) {
  const CurveShape& shape = value.options.shape;
  const int count = value.points.count();
  polygon.points.clear();
  polygon.weighted = takesWeights(shape.kind) && !shape.weights.empty();
  for (int i = 0; i < count; ++i) {
    polygon.points.push_back({value.points[i], polygon.weighted ? shape.weights[i] : 1});
  }
  Workspace& known = *workspace_;
  if (known.layoutPoints != count || !layAlike(shape, known.layoutShape)) {
    known.layoutPoints = 0;
    known.layout = layOut(shape, count);
    known.layoutShape = shape;
    known.layoutPoints = count;
  }
  polygon.pieces = known.layout;
}

/// The control polygon with its legs, which determines the levels.
RefinedPolygon& Curve::leggedPolygon(const CurveValue& value, const Array<SurfacePath>& legs) {
  const CurveShape& shape = value.options.shape;
  RefinedPolygon& polygon = workspace_->control;
  takeControlPolygon(value, polygon);
  polygon.legs = legs;
  if (shape.kind == CurveKind::kCatmullRom) {
    // The knots follow the lengths of the legs, which are known, and not distances by fields.
    Array<double>& gaps = workspace_->gaps;
    gaps.clear();
    for (const SurfacePath& leg : legs) gaps.push_back(leg.length());
    catmullRomSpacings(gaps, shape.centripetal, workspace_->spacings);
    spaceKnots(workspace_->spacings, shape.closed, polygon.pieces);
  }
  return polygon;
}

/// Whether the tightened legs are shortest paths by the fields of level 0. From each point of a
/// segment to both ends of the segment, the legs, pulled tight, must be as long as the field's
/// distance. If the distance is smaller, a shorter path goes another way, for instance around a
/// tube, and centers of mass would jump to it. If the distance is larger, the field is wrong, since
/// the tightened legs are a path. Distances of less than an edge have the error of the blend beside
/// the field's point, which is relative to the edges there. The function releases the field's
/// memory, since the curve may need no other field.
bool Curve::joinsByShortestPaths(const RefinedPolygon& polygon) {
  const Geometry& geometry = surface().geometry();
  bool areShortest = true;
  {
    PointField field(surface(), fieldSet_->options());
    // The tested pairs of points. Bit k of a point is set if the pair of this point and the point k
    // legs later has been tested. Adjacent segments share pairs.
    Array<uint64_t> tested(polygon.points.size());
    const auto isShortest = [&](const SegmentLayout& segment, int from, int to) {
      const uint64_t bit = to - from < 64 ? uint64_t{1} << (to - from) : 0;
      uint64_t& bits = tested[segment.points[from]];
      if ((bits & bit) != 0) return true;
      bits |= bit;
      const double tight = tightLength(geometry, polygon, segment, from, to, workspace_->levels);
      const SurfacePoint& start = polygon.points[segment.points[from]].point;
      const SurfacePoint& end = polygon.points[segment.points[to]].point;
      field.setPointFor(start, end, (1 + kSameLength) * tight);
      const double least = std::max(edgeAt(geometry, start), edgeAt(geometry, end));
      return std::abs(distanceTo(end, field) - tight) <= kSameLength * std::max(tight, least);
    };
    areShortest = std::all_of(polygon.pieces.begin(), polygon.pieces.end(),
                              [&](const SegmentLayout& segment) {
                                const int last = segment.points.count() - 1;
                                for (int k = 1; k < last; ++k) {
                                  if (!isShortest(segment, 0, k) || !isShortest(segment, k, last))
                                    return false;
                                }
                                return isShortest(segment, 0, last);
                              });
  }
  surface().pages()->trim();
  return areShortest;
}

/// The distance of a place from a field's point, by the field.
double Curve::distanceTo(const SurfacePoint& place, PointField& field) {
  workspace_->fields.assign(1, &field);
  const std::array weights = {1.0};
  return std::sqrt(std::max(blendFields().blend.energy(place, weights), 0.0));
}

/// The number of levels of a curve with automatic levels, judged by its control polygon. The
/// refined polygon may need more.
int Curve::levelsOf(const Next& next) {
  const CurveOptions& options = next.value.options;
  const Geometry& geometry = surface().geometry();
  const int points = next.value.points.count();
  LevelsWorkspace& workspace = workspace_->levels;
  const RefinedPolygon& polygon = leggedPolygon(next.value, next.legs);
  const int quick = quickLevels(options.shape, points, next.legs);
  if (next.jumps || areFramesTurned(geometry, next.legs) || !isSafe(geometry, polygon, workspace)) {
    return std::max(levelsToSafety(geometry, options.shape, points, next.legs), quick);
  }
  const auto isNearIt = [&] {
    return levelsDeviation(geometry, polygon, workspace) <=
           options.levelsTolerance * geometry.meanEdge;
  };
  if (quick == 0) return 0;
  return isNearIt() || !joinsByShortestPaths(polygon) ? quick : 0;
}

double Curve::deviation() {
  if (levels_ == 0) return 0;
  if (jumps_) return std::numeric_limits<double>::quiet_NaN();
  const Geometry& geometry = surface().geometry();
  LevelsWorkspace& workspace = workspace_->levels;
  const RefinedPolygon& polygon = leggedPolygon(value_, legs());
  const double deviation = levelsDeviation(geometry, polygon, workspace);
  const bool isFar = deviation > kLevelsTolerance * geometry.meanEdge;
  const bool hasOne =
      isSafe(geometry, polygon, workspace) && !(isFar && !joinsByShortestPaths(polygon));
  return hasOne ? deviation : std::numeric_limits<double>::quiet_NaN();
}

/// Finds the number of levels, and makes the polygon of the pieces.
void Curve::makePolygon(Next& next) {
  const CurveOptions& options = next.value.options;
  const CurveShape& shape = options.shape;
  const int count = next.value.points.count();
  const Geometry& geometry = surface().geometry();
  const bool isAutomatic = options.levels == kAutomaticLevels;
  next.levels = 0;
  if (mayHaveLevels(options)) {
    next.levels = isAutomatic ? std::max(levelsOf(next), options.leastLevels)
                  : options.levels == kLimitLevels
                      ? levelsToLimit(geometry, shape, count, next.legs)
                      : options.levels;
  }
  while (next.levels > 0) {
    if (!refinePolygon(geometry, shape, next.value.points, next.legs, next.levels,
                       workspace_->averaging, next.polygon)) {
      // If a handle lies beyond the boundary, the curve has level 0, which needs no handles.
      next.levels = 0;
    } else if (isAutomatic && mayTakeLevels(shape, count, next.levels + 1) &&
               !isSafe(geometry, next.polygon, workspace_->levels)) {
      ++next.levels;
    } else {
      return;
    }
  }
  takeControlPolygon(next.value, next.polygon);
  next.polygon.legs.clear();
}

/// Whether a curve with automatic levels has bridges at level 0.
bool Curve::jumpsAtLevelZero(const Next& next) const {
  if (next.levels > 0 || !mayHaveLevels(next.value.options)) return false;
  if (next.value.options.levels != kAutomaticLevels) return false;
  return std::any_of(next.segments.begin(), next.segments.end(),
                     [](const Segment& segment) { return !segment.whole->bridges.empty(); });
}

}  // namespace karcher

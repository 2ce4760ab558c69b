#pragma once

#include "curves/automatic_levels.h"
#include "curves/polygon/levels.h"
#include "curves/spec/curve_shape.h"
#include "curves/trace/joined_path.h"
#include "rcm/field_options.h"

/// A curve as a value, and its edits as pure functions from one value to another. A value
/// determines its curve, which `Curve` (curve.h) traces.
namespace karcher {

/// The curve chooses its number of levels, so that its pieces are safe and tracing is fast
/// (automatic_levels.h).
inline constexpr int kAutomaticLevels = -1;
/// The subdivision curve itself, which the curves of many levels approach. Its points are averages
/// of two points, not centers of mass, and it needs no fields.
inline constexpr int kLimitLevels = -2;

struct CurveOptions {
  CurveShape shape;
  int samples = 128;  ///< the number of samples of each segment, at t = i / (samples - 1)
  FieldOptions field;
  /// The largest distance of the curve from the geodesics between samples, relative to the bounding
  /// box's diagonal (sampling.h). If positive, it determines the number of samples.
  double tolerance = 0;
  CurveGeometry geometry = CurveGeometry::kGeodesic;
  /// The number of subdivisions of the control polygon (levels.h): 0 to 8, kAutomaticLevels or
  /// kLimitLevels. Each piece of the curve consists of centers of mass of a few points of the
  /// subdivided polygon. With 0 each segment consists of centers of mass of all its control points,
  /// as in the curve of Mancinelli and Puppo.
  int levels = kAutomaticLevels;
  /// The smallest number of levels that kAutomaticLevels chooses, 0 to 8. A drag uses it to keep at
  /// least the levels that the curve had.
  int leastLevels = 0;
  /// The largest distance, in mean edges, by which kAutomaticLevels may move a curve that is safe
  /// at level 0. With 0 the curve does not move. With infinity it takes the levels that trace
  /// fastest, which suits a draft.
  double levelsTolerance = kLevelsTolerance;
};

struct CurveValue {
  CurveOptions options;
  Array<SurfacePoint> points;
  /// The legs of the control polygon: none, or one from each point to the next, and for a closed
  /// curve also from the last to the first. A path without points stands for the shortest path. The
  /// curve uses any other path as it is, even if it is not the shortest. If a path does not reach
  /// its points, the curve extends it, as if a drag had moved its ends. Curves of level 0 ignore
  /// legs, except for polylines.
  Array<SurfacePath> legs;
};

/// Whether a curve may have levels: its kind and method take them, and their number is not 0.
bool mayHaveLevels(const CurveOptions& options);

/// Whether a curve follows the legs of its control polygon, or consists of them.
bool usesLegs(const CurveOptions& options);

/// Empties a leg, which then stands for the shortest path.
void makeShortest(SurfacePath& leg);

/// The value with a control point at another place. The legs that meet at it become shortest paths.
/// Throws Error kBadIndex.
CurveValue withPointPlaced(CurveValue value, int i, const SurfacePoint& point);

/// The value after a drag of a control point. The legs that meet at it stay unchanged, so that the
/// curve extends them to the point. `legs` are the legs that the curve uses, if any.
CurveValue withPointDragged(CurveValue value, int i, const SurfacePoint& point,
                            const Array<SurfacePath>& legs);

// The value after other edits. Weights and betas stay with their points. A new point has the weight
// and the beta 1. A caller's own knots stay as far as possible (knots.h). A leg stays if its ends
// are still neighbours, in either direction; all others become shortest paths. Each function throws
// Error kBadIndex for a point that does not exist.
CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point);
CurveValue withPointRemoved(CurveValue value, int i);
/// Moves point `from` in the order so that its index becomes `to`.
CurveValue withPointMovedInOrder(CurveValue value, int from, int to);
CurveValue reversed(CurveValue value);
CurveValue withKind(CurveValue value, CurveKind kind);
CurveValue withClosed(CurveValue value, bool closed);
CurveValue withWeight(CurveValue value, int i, double weight);
CurveValue withBeta(CurveValue value, int i, double beta);

}  // namespace karcher

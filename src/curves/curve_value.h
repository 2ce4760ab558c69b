#pragma once

#include "curves/automatic_levels.h"
#include "curves/polygon/levels.h"
#include "curves/spec/curve_shape.h"
#include "curves/trace/joined_path.h"
#include "rcm/field_options.h"

/// A curve as a value, and its edits as pure functions from one value to another. A value
/// determines its curve: `Curve` (curve.h) becomes the curve of a value.
namespace karcher {

/// The fewest levels at which the pieces of the curve are safe centers of mass
/// (automatic_levels.h).
inline constexpr int kAutomaticLevels = -1;
/// The subdivision curve itself, which the curves of many levels approach. It consists of averages
/// of two points, needs no fields, and is no center of mass.
inline constexpr int kLimitLevels = -2;

struct CurveOptions {
  CurveShape shape;
  int samples = 128;  ///< the number for each segment, at t = i / (samples - 1)
  FieldOptions field;
  /// The largest distance of the curve from the geodesics between samples, relative to the bounding
  /// box's diagonal (sampling.h). If positive, it determines the number of samples.
  double tolerance = 0;
  CurveGeometry geometry = CurveGeometry::kGeodesic;
  /// The number of subdivisions of the control polygon (levels.h), whose pieces are then averaged:
  /// 0 to 8, kAutomaticLevels or kLimitLevels. With 0 each segment is one center of mass of all its
  /// points, as in the curve of Mancinelli and Puppo.
  int levels = kAutomaticLevels;
  /// The fewest levels that kAutomaticLevels takes, 0 to 8. With it a drag keeps the levels that
  /// the curve had.
  int leastLevels = 0;
  /// The largest move, in mean edges, by kAutomaticLevels of a curve that is a safe center of mass
  /// without levels. With 0 the curve does not move; with infinity it is the quickest draft.
  double levelsTolerance = kLevelsTolerance;
};

struct CurveValue {
  CurveOptions options;
  Array<SurfacePoint> points;
  /// The legs of the control polygon: none, or one from each point to the next, and for a closed
  /// curve also from the last to the first. A path without points stands for the shortest one; the
  /// curve uses others unchanged. It continues a leg that does not reach its points, as if a drag
  /// had moved its ends there; the leg need not stay the shortest. Except for polylines, curves of
  /// level 0 ignore legs.
  Array<SurfacePath> legs;
};

/// Whether a curve may have levels: its kind and method take them, and their number is not 0.
bool mayHaveLevels(const CurveOptions& options);

/// Whether a curve follows the legs of its control polygon, or consists of them.
bool usesLegs(const CurveOptions& options);

/// Empties a leg, which then stands for the shortest path.
void makeShortest(SurfacePath& leg);

/// The value with a control point elsewhere. The legs that meet at it become shortest paths. Throws
/// Error kBadIndex.
CurveValue withPointPlaced(CurveValue value, int i, const SurfacePoint& point);

/// The value after a drag of a control point. The legs that meet at it stay where they are, so that
/// the curve continues them. `legs` are the curve's, if it uses them.
CurveValue withPointDragged(CurveValue value, int i, const SurfacePoint& point,
                            const Array<SurfacePath>& legs);

// The value after other edits. Weights and betas stay with their points, and those of a new point
// are 1. A caller's own knots stay as far as possible (knots.h). A leg stays if its ends are still
// neighbours, in either direction; all others become shortest paths. Each function throws Error
// kBadIndex for a point that does not exist.
CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point);
CurveValue withPointRemoved(CurveValue value, int i);
/// Moves point `from` in the order so that its number becomes `to`.
CurveValue withPointMovedInOrder(CurveValue value, int from, int to);
CurveValue reversed(CurveValue value);
CurveValue withKind(CurveValue value, CurveKind kind);
CurveValue withClosed(CurveValue value, bool closed);
CurveValue withWeight(CurveValue value, int i, double weight);
CurveValue withBeta(CurveValue value, int i, double beta);

}  // namespace karcher

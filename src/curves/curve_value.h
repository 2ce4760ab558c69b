#pragma once

#include "curves/automatic_levels.h"
#include "curves/polygon/levels.h"
#include "curves/spec/curve_shape.h"
#include "curves/trace/joined_path.h"
#include "rcm/field_options.h"

/// What a curve is, as a value, and its edits as pure functions from a value to another. A value
/// determines its curve: `Curve` (curve.h) becomes the curve of a value.
namespace karcher {

/// As few levels as make the pieces of the curve safe centers of mass (automatic_levels.h).
inline constexpr int kAutomaticLevels = -1;
/// The subdivision curve itself, by averages of two points alone: what many levels come near to. It
/// needs no fields, and is no center of mass.
inline constexpr int kLimitLevels = -2;

struct CurveOptions {
  CurveShape shape;
  int samples = 128;  ///< a segment, at t = i / (samples - 1)
  FieldOptions field;
  /// If positive, segments get as many samples as it needs instead: the curve's largest distance
  /// from the geodesics between samples, as a part of the bounding box's diagonal (sampling.h).
  double tolerance = 0;
  CurveGeometry geometry = CurveGeometry::kGeodesic;
  /// How often the control polygon is subdivided before pieces of it are averaged (levels.h): 0 to
  /// 8, kAutomaticLevels or kLimitLevels. 0 is the curve of Mancinelli and Puppo, one center of
  /// mass of all the points of a segment.
  int levels = kAutomaticLevels;
  /// The fewest levels that kAutomaticLevels takes, 0 to 8. With it a drag does not lose levels
  /// that it once had.
  int leastLevels = 0;
  /// Mean edges: how far kAutomaticLevels may move a curve that is a safe center of mass without
  /// levels. 0: not at all. Infinity makes a draft, as quick as can be, of what is to be this
  /// curve.
  double levelsTolerance = kLevelsTolerance;
};

struct CurveValue {
  CurveOptions options;
  Array<SurfacePoint> points;
  /// The legs of the control polygon: none, or one from each point to the next, at a closed curve
  /// also from the last to the first. A path without points stands for the shortest one; others are
  /// taken as they are. The curve continues a leg that does not reach its points to these, as if a
  /// hand had drawn its ends there, whether or not it stays the shortest. Curves of level 0 have no
  /// use for legs, but polylines.
  Array<SurfacePath> legs;
};

/// Whether a curve may be refined: its kind and method take levels, and it is not asked for none.
bool mayHaveLevels(const CurveOptions& options);

/// Whether a curve follows the legs of its control polygon, or is made of them.
bool usesLegs(const CurveOptions& options);

/// Makes the leg of a value one that it leaves out.
void makeShortest(SurfacePath& leg);

/// Throws Error kBadIndex for a control point that is not there.
void checkIndex(const CurveValue& value, int i);

/// Moves a control point of the value itself, in the memory that is there: the legs that meet at it
/// become the shortest. Throws Error kBadIndex.
void placePoint(CurveValue& value, int i, const SurfacePoint& point);

/// The same as a hand does: the legs that meet at the point stay where they lie, for the curve to
/// continue them. `legs` are the curve's, where it uses them.
void dragIn(CurveValue& value, int i, const SurfacePoint& point, const Array<SurfacePath>& legs);

// The value after an edit. Weights and betas go with their points, a new point's are 1; a caller's
// own knots are kept as far as they can be (knots.h). A leg is kept where both its ends are still
// neighbours, also in the other direction; others are the shortest. Each throws Error kBadIndex for
// a point that is not there.
CurveValue withPointInserted(CurveValue value, int i, const SurfacePoint& point);
CurveValue withPointRemoved(CurveValue value, int i);
/// Point `from` becomes the one of number `to`.
CurveValue withPointMovedInOrder(CurveValue value, int from, int to);
CurveValue reversed(CurveValue value);
CurveValue withKind(CurveValue value, CurveKind kind);
CurveValue withClosed(CurveValue value, bool closed);
CurveValue withWeight(CurveValue value, int i, double weight);
CurveValue withBeta(CurveValue value, int i, double beta);

}  // namespace karcher

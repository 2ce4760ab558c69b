#pragma once

#include "curves/polygon/leg_average.h"
#include "curves/polygon/spline_levels.h"
#include "curves/polygon/through_points.h"
#include "curves/spec/curve_layout.h"
#include "intrinsic/surface_path.h"

/// Subdivision of a control polygon before its curve is traced. A center of mass of distant points
/// is rough on a rough surface, since their squared distances have creases everywhere. So averages
/// of two points along the legs subdivide the control polygon first, and each point of the curve is
/// then a center of mass of a few points near it. On the plane this does not change the curve.
/// Elsewhere, more levels bring the curve nearer to the subdivision curve of C. Mancinelli, G.
/// Nazzaro, F. Pellacini, E. Puppo, "b/Surf: Interactive Bezier Splines on Surface Meshes" (2022).
///
/// Averages do not search for paths. They straighten paths that consist of parts of adjacent legs,
/// so that the curve moves continuously with the legs.
namespace karcher {

inline constexpr int kMostLevels = 8;

/// Whether averages of two points can subdivide a kind of curve: B-splines, Bezier curves (also
/// rational ones) and Catmull-Rom curves. Curves of other kinds have no levels.
bool takesLevels(CurveKind kind);

/// A control polygon after some levels, and the pieces of its curve. The points of a piece are
/// centers of mass of a few points of the polygon.
struct RefinedPolygon {
  Array<WeightedPoint> points;
  /// The pieces in order, 2^levels for each segment of the curve. Their points are indices into
  /// `points`.
  Array<SegmentLayout> pieces;
  /// The legs from each point to the next, and for a closed B-spline also from the last to the
  /// first.
  Array<SurfacePath> legs;
  bool weighted = false;  ///< whether the points have weights that matter
};

/// Throws Error kBadArgument for levels outside 0 to 8, for a kind that takes none, and for
/// excessive work (curves of very many points, above all Bezier curves).
void checkLevels(const CurveShape& shape, int points, int levels);

/// Whether `checkLevels` accepts these levels.
bool mayTakeLevels(const CurveShape& shape, int points, int levels);

/// The two halves of a Bezier polygon, by de Casteljau's algorithm.
struct BezierHalves {
  LeggedPolygon first;
  LeggedPolygon second;
};

/// Reusable scratch memory of averages.
struct AveragingWorkspace {
  StripWorkspace strip;
  LeggedPolygon row;  ///< a row of a pyramid; its list of legs may be longer than the row
  Array<LegAverage> averages;
  SurfacePath inner;
  LeggedPolygon polygon;
  Array<BezierHalves> halves;  ///< the halves, by the number of remaining levels
  SplineWorkspace spline;
  HandleWorkspace handles;
};

/// Subdivides a control polygon `levels` >= 1 times. `legs` are paths from each point to the next,
/// and for a closed curve also from the last to the first.
/// - Bezier curves, also rational ones: de Casteljau's algorithm divides them at 1/2;
/// - B-splines: each span gets a new knot in its middle. A new point is the repeated average
///   (subdivision.h) of consecutive old points, its parents, with the weights of the knot
///   insertion. In degrees up to 3, with evenly spaced knots, this is Lane and Riesenfeld's
///   algorithm;
/// - Catmull-Rom curves: they count as cubic Bezier curves. Log and exp maps at the points give the
///   handles.
///
/// Reversed points and legs give the reversed result. Writes to `refined`. Returns false if a
/// handle would lie beyond the surface's boundary.
bool refinePolygon(const Geometry& geometry, const CurveShape& shape,
                   const Array<SurfacePoint>& points, const Array<SurfacePath>& legs, int levels,
                   AveragingWorkspace& workspace, RefinedPolygon& refined);

/// Halves a Bezier polygon, which must not be part of `halves`.
void halve(const Geometry& geometry, const LeggedPolygon& polygon, AveragingWorkspace& workspace,
           BezierHalves& halves);

/// Writes the polygon of a piece.
void takePolygon(const RefinedPolygon& refined, const SegmentLayout& piece, LeggedPolygon& polygon);

/// The point of a piece at t in [0, 1], by averages of two points alone, in de Casteljau's or de
/// Boor's pyramid. With many levels it is a point of the subdivision curve.
SurfacePoint averageAt(const Geometry& geometry, const SegmentBasis& basis,
                       const LeggedPolygon& polygon, double t, AveragingWorkspace& workspace);

}  // namespace karcher

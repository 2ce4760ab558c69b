#pragma once

#include <map>
#include <string>

#include "generators/control_polygons.h"
#include "measures/drag.h"
#include "measures/turning.h"
#include "steady_variants.h"

/// Measurements of the study of steadiness, for one variant on one mesh with control points of one
/// spacing.
namespace karcher {

/// Figures of traced curves, with an entry for each polygon.
struct CurveFigures {
  Array<double> turnings;  ///< angles in degrees
  Array<double> bridged;   ///< parts of the curve
  Array<double> corners;   ///< angles in degrees
  Array<double> levels;
  Array<double> ms;
  int lost = 0;
  Array<Array<Vec3>> polylines;
};

CurveFigures measureCurves(const TurningMeasure& measure, Surface& surface,
                           const SteadyVariant& variant,
                           const Array<Array<SurfacePoint>>& polygons);

/// The Hausdorff distance between two curves, as a part of the first one's length.
double partMoved(const Array<Vec3>& from, const Array<Vec3>& to);

/// Hausdorff distances between the curves of two variants, each as a part of the first one's
/// length.
Array<double> partsMoved(const CurveFigures& from, const CurveFigures& to);

/// A control polygon and the places through which its third point is dragged.
struct Drag {
  static constexpr int kPoint = 2;
  /// A step of the hand, in mean edges.
  static constexpr double kStep = 0.1;

  Array<SurfacePoint> polygon;
  Array<SurfacePoint> path;
};

/// A drag in a random direction. Drags that meet the boundary are drawn again.
Drag randomDrag(const Geometry& geometry, Random& random, const ControlPolygonOptions& options,
                int steps);

/// Steps that shiver although no leg passed a vertex that allows it, classified by the paths of the
/// averages. Like a leg, a geodesic between two averages may cease to exist at a vertex of positive
/// curvature. The passages of legs and averages in a step add up.
struct AverageFigures {
  int passing = 0;  // steps that the passages explain
  /// The largest of their leaps, as a part of the allowed one.
  double largestPassing = 0;
  int unexplained = 0;     // steps that the passages do not explain
  double largestLeap = 0;  // the largest leap of all other steps that count, in steps of the hand
};

/// A step that leapt farther than allowed. Lengths are in steps of the hand.
struct Leap {
  int drag = 0;
  int step = 0;
  double motion = 0;
  double allowedByLegs = 0;
  double allowedByAverages = 0;
};

struct HandFigures {
  DragFigures motion;
  AverageFigures averages;
  Array<double> ms;           ///< milliseconds of each step
  Array<double> allocations;  ///< allocations of each step
  std::map<std::string, Array<double>> stageMs;
  Array<std::string> stages;  // in the order of their occurrence
  Array<Leap> leaps;          // the largest first
  double bridged = 0;         ///< the sum over the steps
  int lost = 0;
  /// The distance by which release moves the curve, as a part of its length, for each drag.
  Array<double> released;
  /// The distance from a draft to the curve of automatic levels; empty without drafts.
  Array<double> releasedToAutomatic;
};

/// The figures by variant. All variants of a drag are measured before the next drag, so that a
/// machine whose speed drifts favours none.
Array<HandFigures> measureDrags(Surface& surface, const Array<SteadyVariant>& variants,
                                const Array<Drag>& drags);

}  // namespace karcher

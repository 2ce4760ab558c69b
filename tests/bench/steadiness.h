#pragma once

#include <map>
#include <string>

#include "generators/control_polygons.h"
#include "measures/drag.h"
#include "measures/turning.h"
#include "steady_variants.h"

/// What the study of steadiness measures of one variant on one mesh, with control points of one
/// spacing.
namespace karcher {

/// Of traced curves, an entry a polygon.
struct CurveFigures {
  Array<double> turnings;  ///< degrees
  Array<double> bridged;   ///< parts of the curve
  Array<double> corners;   ///< degrees
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

/// In a random direction; drags that meet the boundary are drawn again.
Drag randomDrag(const Geometry& geometry, Random& random, const ControlPolygonOptions& options,
                int steps);

/// Steps that shiver though no leg passed a vertex that allows it, told by the paths that the
/// averages lie on: a geodesic between two averages ends to exist at a vertex of positive curvature
/// as a leg does. The passages of a step, of legs and averages, add up.
struct AverageFigures {
  int passing = 0;  ///< the passages allow it to leap that far
  /// The largest of their leaps, as a part of what the passages allow.
  double largestPassing = 0;
  int unexplained = 0;     ///< the others
  double largestLeap = 0;  ///< of all steps that count but these passing ones, in steps of the hand
};

/// A step that leapt farther than it may. Lengths in steps of the hand.
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
  Array<double> ms;           ///< a step
  Array<double> allocations;  ///< a step
  std::map<std::string, Array<double>> stageMs;
  Array<std::string> stages;  ///< their order
  Array<Leap> leaps;          ///< the farthest first
  double bridged = 0;         ///< sum over the steps
  int lost = 0;
  /// How far release moves the curve, as a part of its length; a drag.
  Array<double> released;
  /// The same where the dragged curve was a draft of the one of automatic levels; none where it
  /// cannot be.
  Array<double> releasedToAutomatic;
};

/// By variant. Each drag is measured with all of them before the next, so that a machine whose
/// speed drifts does not favour one.
Array<HandFigures> measureDrags(Surface& surface, const Array<SteadyVariant>& variants,
                                const Array<Drag>& drags);

}  // namespace karcher

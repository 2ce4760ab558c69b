#pragma once

#include <functional>

#include "intrinsic/geometry.h"
#include "measures/polyline_distance.h"

/// The steadiness of a curve in a drag: the motion of the whole curve in each small step of a
/// control point.
namespace karcher {

/// A vertex of positive curvature that changed from one side of a leg to the other. No geodesic
/// passes through it, so the leg's middle leaps by about length * curvature / 4 there.
struct VertexPassage {
  int vertex = -1;
  double curvature = 0;  ///< 2 pi less the vertex's total angle
};

/// The vertices of positive curvature between two paths on the surface with about the same ends,
/// among those next to both. Consecutive points of a path share a face.
Array<VertexPassage> passedVertices(const Geometry& geometry, const Array<SurfacePoint>& before,
                                    const Array<SurfacePoint>& after);

/// The sum of the angles between two paths at their two ends, in radians. If the paths are
/// geodesics with the same ends, by Gauss and Bonnet it is at most the curvature between them. This
/// is the curvature that a geodesic passed over before another one replaced it, even where no
/// vertex lies next to both.
double anglesBetween(const TriangleMesh& mesh, const Array<SurfacePoint>& before,
                     const Array<SurfacePoint>& after);

/// The figures of drags. Lengths are in steps of the hand.
struct DragFigures {
  /// The motion above which a step is a shiver.
  static constexpr double kShiver = 5;
  static constexpr double kTolerance = 1e-2;

  int steps = 0;  // the steps that count
  int shivers = 0;
  double largestLeap = 0;
  /// The number of steps that do not count: a leg passed vertices that explain the leap.
  int passing = 0;
  /// The largest of their leaps, as a part of what the passages allow.
  double largestPassing = 0;
  int beyond = 0;  // steps of these with a larger leap

  double shiverShare() const { return steps > 0 ? static_cast<double>(shivers) / steps : 0; }
  double beyondShare() const {
    return steps + passing > 0 ? static_cast<double>(beyond) / (steps + passing) : 0;
  }
  double passingShare() const {
    return steps + passing > 0 ? static_cast<double>(passing) / (steps + passing) : 0;
  }
};

/// Counts one step of the hand, and returns its motion. `allowedLeap` is half of length *
/// curvature, summed over the passages of the legs in this step, in the mesh's units like `step`.
/// If it is less than a shiver, the step counts like any other. `allowedBeside` returns what else
/// allows a leap in the same step; it runs if a leg's passage does not suffice.
double countStep(DragFigures& figures, const MeasuredPolyline& before,
                 const MeasuredPolyline& after, double step, double allowedLeap = 0,
                 const std::function<double()>& allowedBeside = {});

/// Adds the figures of other drags.
void add(DragFigures& sum, const DragFigures& figures);

}  // namespace karcher

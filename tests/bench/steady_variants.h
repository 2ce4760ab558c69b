#pragma once

#include <functional>
#include <string>

#include "curves/curve.h"

/// The curves that the study of steadiness compares, with their measurements.
namespace karcher {

/// The number of samples of every curve.
inline constexpr int kSteadySamples = 128;

struct StageTime {
  std::string name;
  double ms = 0;
};

struct TracedCurve {
  Array<Vec3> polyline;
  /// The legs of the control polygon in the curve's form, with consecutive points in a common face;
  /// empty if the curve has no legs.
  Array<Array<SurfacePoint>> legs;
  int levels = 0;
  double bridged = 0;  ///< the part of the parameter over which the curve is no center of mass
  // Parts of the pieces.
  double piecesSubdivided = 0;  // the part replaced by its subdivision
  double piecesBridged = 0;     // the part with a bridge among the others
  int lost = 0;                 ///< samples that neither converged nor lie on such pieces
  double ms = 0;                // processor time of the step
  Array<StageTime> stages;
  int64_t allocations = 0;  // allocations of the step
};

/// A curve during a drag.
struct HeldCurve {
  /// Moves a control point and traces the curve.
  std::function<TracedCurve(int point, const SurfacePoint& place)> drag;
  /// Ends the drag and returns the final curve.
  std::function<TracedCurve()> release;
  /// Ends the drag of a draft and returns the curve of automatic levels with the present legs.
  /// Empty for curves of other programs.
  std::function<TracedCurve()> releaseToAutomatic;
};

struct SteadyVariant {
  std::string name;
  /// The cubic Bezier curve of these points.
  std::function<TracedCurve(Surface&, const Array<SurfacePoint>&)> trace;
  /// The curve's largest angle at a joint of two pieces, in degrees.
  std::function<double(Surface&, const Array<SurfacePoint>&)> corner;
  /// Begins a drag.
  std::function<HeldCurve(Surface&, const Array<SurfacePoint>&)> hold;
};

/// The variant with this name: a number of levels, "auto", "averages" (the engine's curve of
/// subdivision, which continues its legs) or "limit" (the curve of subdivision to the end, with a
/// search for every path at every step). Throws std::runtime_error for another name.
SteadyVariant steadyVariant(const std::string& name);

}  // namespace karcher

#pragma once

#include <functional>
#include <string>

#include "curves/curve.h"

/// The curves that the study of steadiness compares, each as what it measures of them.
namespace karcher {

/// Of every curve that is compared.
inline constexpr int kSteadySamples = 128;

struct StageTime {
  std::string name;
  double ms = 0;
};

struct TracedCurve {
  Array<Vec3> polyline;
  /// Of the control polygon as the curve has them, consecutive points sharing a face; none where
  /// the curve has no legs.
  Array<Array<SurfacePoint>> legs;
  int levels = 0;
  double bridged = 0;  ///< the part of the parameter over which the curve is no center of mass
  // Parts of the pieces.
  double piecesSubdivided = 0;  ///< that are their own subdivision
  double piecesBridged = 0;     ///< of the others, those that have a bridge
  int lost = 0;                 ///< samples that neither converged nor lie on one of these
  double ms = 0;                ///< of a step, the processor's
  Array<StageTime> stages;
  int64_t allocations = 0;  ///< of the step of the hand
};

/// A curve under the hand.
struct HeldCurve {
  /// Moves a control point and carries it out.
  std::function<TracedCurve(int point, const SurfacePoint& place)> drag;
  /// Lets go: what the curve is from then on.
  std::function<TracedCurve()> release;
  /// The same where it was a draft: the curve of automatic levels, with the legs as they are. None
  /// where the curve is not the engine's.
  std::function<TracedCurve()> releaseToAutomatic;
};

struct SteadyVariant {
  std::string name;
  /// The cubic Bezier curve of these points.
  std::function<TracedCurve(Surface&, const Array<SurfacePoint>&)> trace;
  /// Its largest angle at a joint of two pieces, degrees.
  std::function<double(Surface&, const Array<SurfacePoint>&)> corner;
  /// Takes hold of it.
  std::function<HeldCurve(Surface&, const Array<SurfacePoint>&)> hold;
};

/// A number of levels, "auto", "averages": the engine's curve of subdivision, whose legs follow the
/// hand, or "limit": the curve of subdivision to the end, for which every path is searched for at
/// every step. Throws std::runtime_error for another name.
SteadyVariant steadyVariant(const std::string& name);

}  // namespace karcher

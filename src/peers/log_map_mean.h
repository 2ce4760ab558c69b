#pragma once

#include <unordered_map>

#include "peers/vector_heat.h"
#include "rcm/center_of_mass.h"

/// The Karcher mean by gradient descent over log maps: N. Sharp, Y. Soliman, K. Crane, "The Vector
/// Heat Method" (2019), section 8.3. Each step follows the straightest geodesic along the weighted
/// sum of the control points' logarithms, until that vanishes.
namespace karcher {

struct LogMapMeanOptions {
  double tolerance = 1e-6;  ///< of the weighted sum of logarithms, in mean edges
  int maxIterations = 100;
};

/// The center of mass of control points that stay the same for many weights. A log map is computed
/// once for each vertex that a search comes by, and kept are the logarithms of the control points.
class LogMapMean {
 public:
  /// The geometry must outlive the mean.
  LogMapMean(const Geometry& geometry, LogMapFromVertex logMapFromVertex,
             Array<SurfacePoint> points, const LogMapMeanOptions& options = {});

  /// Replaces the control points and forgets their logarithms.
  void setPoints(Array<SurfacePoint> points);

  /// The weights should sum to 1. Statuses: kConverged; kNoProgress where no step lowers the energy
  /// or the weighted sum (log maps of neighbouring faces do not quite agree, and a zero may lie in
  /// between); kBoundary for that at the boundary; kLimit.
  /// Throws Error: kBadWeights if there is not one weight a point, kUnreachable if a control point
  /// has no logarithm where the search stands.
  CenterOfMass centerOfMass(Weights weights, const SurfacePoint& start);

  /// How many log maps were computed since the points were set.
  int logMapCount() const { return static_cast<int>(logarithms_.size()); }

 private:
  /// The weighted sum of logarithms, in the frame of the point's face, and the energy (Eq. 1).
  struct State {
    SurfacePoint point;
    Vec2 step = Vec2::Zero();
    double energy = 0;
  };

  State stateAt(const SurfacePoint& point, Weights weights);
  bool descend(State& state, Weights weights);
  const Array<Vec2>& logarithmsAt(int vertex);

  const Geometry& geometry_;
  LogMapFromVertex logMapFromVertex_;
  LogMapMeanOptions options_;
  Array<SurfacePoint> points_;
  std::unordered_map<int, Array<Vec2>> logarithms_;
};

}  // namespace karcher

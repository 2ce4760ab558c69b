#pragma once

#include <functional>
#include <unordered_map>

#include "peers/vector_heat.h"
#include "rcm/field_blend.h"
#include "rcm/search_end.h"

/// The Karcher mean by gradient descent over log maps: N. Sharp, Y. Soliman, K. Crane, "The Vector
/// Heat Method" (2019), section 8.3. Each step follows the straightest geodesic along the weighted
/// sum of the control points' logarithms, until the sum vanishes.
namespace karcher {

struct LogMapMeanOptions {
  double tolerance = 1e-6;  ///< the tolerance of the weighted sum of logarithms, in mean edges
  int maxIterations = 100;
  /// The largest memory for whole log maps, in bytes. The mean reads the logarithms of moved points
  /// from these maps. A map takes 16 bytes for each vertex.
  size_t mostBytes = size_t{1} << 29;
  std::function<double()> clock = {};  ///< the time in milliseconds; without it nothing is timed
};

/// The center of mass of control points that stay the same for many weights. The first search that
/// visits a vertex computes its log map. The map does not depend on the control points. While
/// memory suffices, the mean keeps whole maps and reads the logarithms of moved points from them.
class LogMapMean {
 public:
  /// The geometry must outlive the mean.
  LogMapMean(const Geometry& geometry, LogMapFromVertex logMapFromVertex,
             Array<SurfacePoint> points, const LogMapMeanOptions& options = {});

  /// Replaces the control points and forgets all log maps.
  void setPoints(Array<SurfacePoint> points);

  /// Replaces control point i, which must exist. Keeps only whole log maps in which the point has a
  /// logarithm.
  void movePoint(int i, const SurfacePoint& point);

  /// The center of mass. The weights should sum to 1. Statuses: kConverged; kNoProgress if no step
  /// lowers the energy or the weighted sum; kBoundary if this happens at the boundary; kLimit. A
  /// search may make no progress because the log maps of neighbouring faces do not quite agree, so
  /// that a zero may lie in between. Throws Error: kBadWeights if there is not one weight for each
  /// point, kUnreachable if a control point has no logarithm at the place of the search.
  SearchEnd centerOfMass(Weights weights, const SurfacePoint& start);

  /// Whether the last search met the stopping rule of the authors' library (geometry-central,
  /// findCenter): a step shorter than a third of the root of the face's area. A step is the
  /// weighted sum. Where a step does not lower the energy, the library halves it up to seven times
  /// and tests each part.
  bool metLibraryRule() const { return metLibraryRule_; }

  /// The number of log maps computed since the last `setPoints`.
  int logMapCount() const { return logMapCount_; }

  /// The duration of the computation of these log maps, in milliseconds; 0 without a clock.
  double logMapMilliseconds() const { return logMapMilliseconds_; }

  /// The number of requests for log maps. The authors' library keeps no maps and would compute one
  /// for each request.
  int64_t logMapsAsked() const { return logMapsAsked_; }

 private:
  /// The weighted sum of logarithms, in the frame of the point's face, and the energy (Eq. 1).
  struct State {
    SurfacePoint point;
    Vec2 step = Vec2::Zero();
    double energy = 0;
  };

  /// The kept data of the log map from a vertex.
  struct KnownMap {
    LogMap whole;          ///< empty if memory did not suffice
    Array<Vec2> ofPoints;  ///< the logarithms of the control points
  };

  State stateAt(const SurfacePoint& point, Weights weights);
  bool descend(State& state, Weights weights);
  const Array<Vec2>& logarithmsAt(int vertex);
  Vec2 logarithmOf(const LogMap& logs, int i) const;

  const Geometry& geometry_;
  LogMapFromVertex logMapFromVertex_;
  LogMapMeanOptions options_;
  Array<SurfacePoint> points_;
  std::unordered_map<int, KnownMap> known_;
  size_t keptBytes_ = 0;
  bool metLibraryRule_ = false;
  int logMapCount_ = 0;
  int64_t logMapsAsked_ = 0;
  double logMapMilliseconds_ = 0;
};

}  // namespace karcher

#pragma once

#include "distance/window.h"

/// Joining of windows that wait at an edge and are parts of one front: see window_distance.h.
namespace karcher {

/// A half-edge at which windows are joined: the tolerance there and what is known.
struct JoinedEdge {
  double length = 0;
  double tolerance = 0;     ///< the most that distances along the edge may change
  double tailDistance = 0;  ///< the distances of the ends, as far as they are known
  double headDistance = 0;

  /// The most by which a vertex and the front that arrives at it may differ.
  double frontTolerance() const { return kSameFront * tolerance; }
  static constexpr double kSameFront = 0.25;  ///< as a part of the tolerance
};

/// Joins windows, at least one, and removes those that lie in others.
void joinWindows(const JoinedEdge& edge, Array<Window>& windows);

}  // namespace karcher

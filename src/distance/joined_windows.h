#pragma once

#include "distance/window.h"

/// Joining of windows that wait at an edge and belong to one front: see window_distance.h.
namespace karcher {

/// The tolerances of joins at a half-edge.
struct JoinedEdge {
  double tolerance = 0;  ///< the largest permitted change of distances along the edge
  /// the largest change of slope by which the ray at an end of a window may turn inwards
  double turn = 0;
};

/// Joins windows and removes those that lie in others. Requires at least one window.
void joinWindows(const JoinedEdge& edge, Array<Window>& windows);

}  // namespace karcher

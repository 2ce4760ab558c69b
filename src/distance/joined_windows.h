#pragma once

#include "distance/window.h"

/// Joining of windows that wait at an edge and belong to one front: see window_distance.h.
namespace karcher {

/// A half-edge at which windows join, with its tolerance.
struct JoinedEdge {
  double tolerance = 0;  ///< the largest permitted change of distances along the edge
  double turn =
      0;  ///< the change of slope by which the rays at the ends of windows may turn inwards
};

/// Joins windows and removes those that lie in others. Requires at least one window.
void joinWindows(const JoinedEdge& edge, Array<Window>& windows);

}  // namespace karcher

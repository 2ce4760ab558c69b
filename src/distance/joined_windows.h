#pragma once

#include "distance/window.h"
#include "intrinsic/geometry.h"

/// Windows that wait at an edge, joined where they are parts of one front: see window_distance.h.
namespace karcher {

/// What joining may change at a half-edge, and what is known there.
struct JoinedEdge {
  double length = 0;
  double tolerance = 0;     ///< of distances along the edge
  double tailDistance = 0;  ///< of the ends, as far as they are known
  double headDistance = 0;

  /// By how much a vertex and the front that comes to it may differ.
  double frontTolerance() const { return kSameFront * tolerance; }
  static constexpr double kSameFront = 0.25;  ///< a part of the tolerance
};

/// By how much distances may change at half-edge h: a part of the least height of its face.
double toleranceOver(const Geometry& geometry, int h, double part);

/// Joins windows, of which there is at least one, and leaves out those that lie in others.
void joinWindows(const JoinedEdge& edge, Array<Window>& windows);

}  // namespace karcher

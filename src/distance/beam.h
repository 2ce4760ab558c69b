#pragma once

#include "mesh/types.h"

namespace karcher {

/// Straight paths into a face, all from one point: the source, a vertex that paths turn round, or
/// the image of one of these, unfolded across the edges that the paths crossed. In the frame of the
/// face.
struct Beam {
  int face = -1;
  Vec2 source = Vec2::Zero();
  double offset = 0;  ///< distance of the point that the paths come from
  /// The rays that bound the paths, unit, counterclockwise from right to left; all directions if
  /// the source lies in the face itself.
  Vec2 right = Vec2(1, 0);
  Vec2 left = Vec2(1, 0);
  bool isFull = false;
};

}  // namespace karcher

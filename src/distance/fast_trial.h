#pragma once

#include <memory>

#include "intrinsic/vertex_fans.h"

namespace karcher {

/// How the fast solver (fast_distance.h) did against exact distances in a trial.
struct FastTrial {
  double thinnest = 1;    ///< least ratio of twice a face's area to its longest side squared
  double bad = 0;         ///< part of the vertices where thin faces meet much curvature
  int pairs = 0;          ///< of a source and a vertex
  double meanError = 0;   ///< relative, over all pairs
  double worstError = 0;  ///< relative
  int wrong = 0;          ///< pairs that are off by more than kWrong

  static constexpr double kWrong = 0.02;

  /// Whether the mesh is one that the fast solver was shown to work on.
  bool isPassed() const;
};

/// Tries the fast solver on a mesh: from some vertices anywhere and from those where thin faces
/// meet most curvature, which is what it takes worst, to the nearest few hundred vertices. The
/// sources depend on the shape alone, not on its place or its numbers. Takes some 30 ms on any
/// mesh, less on a small one and on one whose faces alone tell.
FastTrial tryFastDistance(const Geometry& geometry, const std::shared_ptr<const VertexFans>& fans);

}  // namespace karcher

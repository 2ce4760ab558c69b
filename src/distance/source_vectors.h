#pragma once

#include "distance/distance_solver.h"

/// The log vectors of vertices at the source of their distances: the directions in which shortest
/// paths leave the source, scaled to their lengths.
///
/// The last edge that a path to a vertex crosses joins two other vertices. At the crossing, the
/// class interpolates the log vectors of these two. From there to the vertex, only the vector's
/// length changes. So directions spread outwards from the source (after E. Melvaer, M. Reimers,
/// "Geodesic Polar Coordinates on Polygonal Meshes", 2012, who interpolate angles). On a plane they
/// are exact.
namespace karcher {

class SourceVectors {
 public:
  /// The geometry must outlive the object.
  explicit SourceVectors(const Geometry& geometry) : geometry_(geometry) {}

  /// Changes the source. If the source is a vertex, the vectors are in its tangent plane
  /// (tangent.h).
  void setSource(const SurfacePoint& source);

  /// The log of a vertex at the source, in the tangent plane of the source's face or vertex. The
  /// solver must have the same source, implement `stepTo`, and have grown to the vertex.
  const Vec2& at(const DistanceSolver& solver, int vertex);

 private:
  enum class State : uint8_t { kUnknown, kAsked, kKnown };

  /// A vertex that waits for the earlier vertices on its path.
  struct Asked {
    int vertex = -1;
    PathStep step;
  };

  void know(int vertex, const Vec2& vector);
  bool ask(const DistanceSolver& solver, int vertex);
  void take(const Asked& asked, double distance);

  const Geometry& geometry_;
  Array<Vec2> vectors_;
  Array<State> states_;
  Array<Asked> asked_;
};

}  // namespace karcher

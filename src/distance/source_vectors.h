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
///
/// Across the cut locus, and behind a vertex at which paths turn, interpolation mixes vectors of
/// different fronts. If one end of the edge sees the source at the same place as the vertex does,
/// unfolded into the plane of the last face, and the other end does not, the vector is that of the
/// first end, turned by the angle between the two as seen from the source. This is exact. If paths
/// come straight from a turn, they have the direction of the path to the turn. If neither end sees
/// the source there, the class interpolates. So on surfaces that unroll, directions may be inexact
/// where three fronts meet within an edge, and elsewhere near the cut locus.
namespace karcher {

class SourceVectors {
 public:
  /// The geometry must outlive the object.
  explicit SourceVectors(const Geometry& geometry) : geometry_(geometry) {}

  /// Changes the source. If the source is a vertex, the vectors are in its tangent plane
  /// (tangent.h).
  void setSource(const SurfacePoint& source);

  /// The log of a vertex at the source, in the tangent plane of the source's face or vertex. The
  /// solver must have the same source and implement `stepTo`. It grows as far as needed.
  const Vec2& at(DistanceSolver& solver, int vertex);

 private:
  enum class State : uint8_t { kUnknown, kAsked, kKnown };

  /// A vertex that waits for the earlier vertices on its path.
  struct Asked {
    int vertex = -1;
    int tail = -1;  ///< the ends of the edge, or -1 if an end is on another front
    int head = -1;
    double part = 0;
    /// the turns of the directions from the source, from an end to the vertex; of any length
    Vec2 fromTail = Vec2::UnitX();
    Vec2 fromHead = Vec2::UnitX();
  };

  void know(int vertex, const Vec2& vector);
  bool ask(DistanceSolver& solver, int vertex);
  void take(const Asked& asked, double distance);

  const Geometry& geometry_;
  double angleScale_ = 1;  ///< the scale of angles in the source's tangent plane
  Array<Vec2> vectors_;
  Array<State> states_;
  Array<Asked> asked_;
};

}  // namespace karcher

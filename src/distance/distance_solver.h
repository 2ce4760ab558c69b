#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "intrinsic/geometry.h"

/// The interface of all solvers of geodesic distances. A caller need not know which solver it
/// holds.
namespace karcher {

/// The arrival of a shortest path at the midpoint of an edge.
struct MidpointArrival {
  double distance = kInfinity;
  /// a unit vector towards the source, in the frame whose x axis is the half-edge's direction
  Vec2 toSource = Vec2(1, 0);
};

/// The last step of the path to a vertex. It starts on the line from `tail` to `head`, two
/// neighbours of the vertex. `part` is the ratio of the start's distance from `tail` to the line's
/// length. If the path comes straight from a vertex at which it turns, the step starts there: both
/// `tail` and `head` are this vertex, which need not be a neighbour.
struct PathStep {
  int tail = -1;  ///< the neighbour at `part` 0, or -1 at the source
  int head = -1;
  double part = 0;    ///< a number in [0, 1]
  int halfedge = -1;  ///< the half-edge from `tail` to `head` opposite to the vertex, or -1
};

/// The aim of a search: the paths that lead to a ball in space and are no longer than `mostLength`.
struct PathAim {
  Vec3 center = Vec3::Zero();
  double radius = 0;
  double mostLength = kInfinity;
};

/// Geodesic distances from one point of a surface, and the directions of their paths. The work is
/// bounded and resumable: it stops at a radius or at a vertex and can continue from there. Every
/// final value is the same as without a stop.
class DistanceSolver {
 public:
  virtual ~DistanceSolver() = default;

  /// Starts anew from a point of a face, an edge or a vertex. The time grows with the part of the
  /// mesh that the previous search reached.
  virtual void setSource(const SurfacePoint& source) = 0;

  /// Limits the searches from the next `setSource` on to an aim. The solver may omit a place if the
  /// path to it, continued straight through space to the aim's ball, is longer than `mostLength`.
  /// For points in the ball, distances up to `mostLength` stay exact. All other distances are upper
  /// bounds, whatever `reached` returns. Without an aim, the solver omits nothing.
  virtual void aimAt(const std::optional<PathAim>&) {}

  /// Works until all vertices within `radius` (any number up to kInfinity) are final.
  virtual void grow(double radius) = 0;

  /// Works until a vertex is final. Returns its distance; kInfinity if no path leads there.
  virtual double growTo(int vertex) = 0;

  /// The distance up to which all vertices are final; kInfinity once the whole component is final.
  virtual double reached() const = 0;

  /// Whether a vertex's values are final. Final values depend on the source alone, not on where the
  /// work stopped.
  virtual bool isFinal(int vertex) const = 0;

  /// The length of the shortest path found so far; kInfinity where no path has arrived.
  virtual double distance(int vertex) const = 0;

  /// -2 log_v(source), the gradient of the squared distance, in the frame of the vertex. Its length
  /// is 2 d, and it points in the direction in which the path would continue beyond the vertex. It
  /// has no meaning where no path has arrived.
  virtual Vec2 logVector(int vertex) const = 0;

  /// The last step of the path to a final vertex; an empty step if the solver does not know it.
  virtual PathStep stepTo(int) const { return {}; }

  /// From the next `setSource` on, the solver also finds the arrivals at the midpoints of edges.
  /// Returns false if it cannot.
  virtual bool keepMidpoints() { return false; }

  /// The arrival at the midpoint of an edge that is not on the boundary; the argument is one of its
  /// half-edges. The arrival is final once its distance is <= reached(). Requires `keepMidpoints`.
  virtual MidpointArrival midpointOf(int) const { return {}; }

  /// The approximate memory of the solver's values, in bytes.
  virtual int64_t bytesHeld() const = 0;
  DistanceSolver& operator=(const DistanceSolver&) = delete;

 protected:
  DistanceSolver() = default;
  DistanceSolver(const DistanceSolver&) = default;
};

/// The distances from a point to all vertices; kInfinity where no path leads.
Array<double> distancesFrom(DistanceSolver& solver, const SurfacePoint& source, int vertexCount);

/// The vector -2 log_v(source) at a vertex v, from its distance and the unscaled direction
/// (geometry.h) in which the path leaves it towards the source.
inline Vec2 logVectorAlong(const Geometry& geometry, int vertex, double distance,
                           double direction) {
  return -2 * distance * unitVector(geometry.angleScale[vertex] * direction);
}

/// `growTo` for a solver that can only grow by radius. It first grows to the length of the line
/// through space, then in small steps, so that it does little excess work.
template <class Solver>
double growInSteps(Solver& solver, const Geometry& geometry, const SurfacePoint& source,
                   int vertex) {
  constexpr double kStep = 1.01;
  double distance = solver.distance(vertex);
  if (distance <= solver.reached() && distance != kInfinity) return distance;
  const TriangleMesh& mesh = *geometry.mesh;
  double radius = (mesh.positions[vertex] - position(mesh, source)).norm();
  while ((distance > solver.reached() || distance == kInfinity) && solver.reached() < kInfinity) {
    solver.grow(radius);
    radius = std::max(kStep * radius, radius + geometry.meanEdge / 4);
    distance = solver.distance(vertex);
  }
  return distance;
}

}  // namespace karcher

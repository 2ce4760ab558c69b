#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "intrinsic/geometry.h"

/// What all solvers of geodesic distances give. A caller holds a solver by this interface and does
/// not ask which one it is.
namespace karcher {

/// How a shortest path reaches the midpoint of an edge.
struct MidpointArrival {
  double distance = kInfinity;
  Vec2 toSource = Vec2(1, 0);  ///< unit, in the half-edge's frame: its direction is the x axis
};

/// Where the path to a vertex comes from: a point of the line between two of its neighbours, `part`
/// of the way from `tail` to `head`.
struct PathStep {
  int tail = -1;  ///< none at the source
  int head = -1;
  double part = 0;  ///< in [0, 1]
};

/// What paths are wanted for: those to a ball in space, none longer than `mostLength`.
struct PathAim {
  Vec3 center = Vec3::Zero();
  double radius = 0;
  double mostLength = kInfinity;
};

/// Geodesic distances from one point of a surface, and the directions of their paths. The work is
/// bounded and resumable: it ends at a radius or at a vertex and later goes on from there, and
/// every final value is the same as in one go.
class DistanceSolver {
 public:
  virtual ~DistanceSolver() = default;

  /// Starts anew from a point of a face, an edge or a vertex. The time grows with what was touched.
  virtual void setSource(const SurfacePoint& source) = 0;

  /// From the next `setSource` on the solver may leave out places from which the straight way to
  /// the ball is too long. Distances of points in the ball are then right up to `mostLength`; all
  /// others are upper bounds, whatever `reached` is.
  virtual void aimAt(const std::optional<PathAim>&) {}

  /// Works until all vertices within `radius` (any number up to kInfinity) are final.
  virtual void grow(double radius) = 0;

  /// Works until a vertex is final. Returns its distance; kInfinity if no path leads there.
  virtual double growTo(int vertex) = 0;

  /// All vertices up to this distance are final; kInfinity once the whole component is.
  virtual double reached() const = 0;

  /// Whether a vertex's values change no more. Final values depend on the source alone, not on
  /// where the work stopped.
  virtual bool isFinal(int vertex) const = 0;

  /// Length of the shortest path found so far; kInfinity where no path has arrived.
  virtual double distance(int vertex) const = 0;

  /// -2 log_v(source), the gradient of the squared distance, in the frame of the vertex: of length
  /// 2 d, it points on along the path that arrives. Meaningless where no path has arrived.
  virtual Vec2 logVector(int vertex) const = 0;

  /// The last step of the path to a final vertex; none where the solver cannot tell.
  virtual PathStep stepTo(int) const { return {}; }

  /// From the next `setSource` on also finds the midpoints of edges. Returns false if the solver
  /// cannot.
  virtual bool keepMidpoints() { return false; }

  /// The arrival at the midpoint of an edge that is not on the boundary, by one of its half-edges.
  /// Final once its distance is <= reached(). Requires `keepMidpoints`.
  virtual MidpointArrival midpointOf(int) const { return {}; }

  /// About how many bytes its values take.
  virtual int64_t bytesHeld() const = 0;
  DistanceSolver& operator=(const DistanceSolver&) = delete;

 protected:
  DistanceSolver() = default;
  DistanceSolver(const DistanceSolver&) = default;
};

/// The distances from a point to all vertices; kInfinity where no path leads.
Array<double> distancesFrom(DistanceSolver& solver, const SurfacePoint& source, int vertexCount);

/// -2 log_v(source) of a vertex, by its distance and the unscaled direction (geometry.h) back to
/// the source.
inline Vec2 logVectorAlong(const Geometry& geometry, int vertex, double distance,
                           double direction) {
  return -2 * distance * unitVector(geometry.angleScale[vertex] * direction);
}

/// `growTo` for a solver that grows by radius only: first to the straight distance, then in steps
/// so small that little is done in excess.
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

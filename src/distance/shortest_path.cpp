#include "distance/shortest_path.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "intrinsic/local_path.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The largest relative difference between a path's distance and its length as measured along its
/// points.
[[maybe_unused]] constexpr double kSameMeasure = 1e-6;

/// The vertex at which a point of a straight walk lies, or -1. The point may miss the vertex by ten
/// times kSeenTolerance, since windows see past their ends.
int vertexAt(const Geometry& geometry, const SurfacePoint& point) {
  int corner = 0;
  if (point.bary.maxCoeff(&corner) < 1 - kChainRounding) return -1;
  return geometry.mesh->corner(point.face, corner);
}

/// Appends the points of a straight piece up to the first saddle, without the piece's first point.
/// The piece starts at the distance `left` from the source. A saddle has no unique straight
/// continuation, so the path continues with the saddle's own shortest path. Returns the saddle, or
/// -1 if the piece is complete.
int appendUpToSaddle(const Geometry& geometry, const WindowDistance& distance,
                     const SurfacePath& path, double left, Array<SurfacePoint>& points) {
  const SurfacePoint start = path.start();
  for (int i = 1; i < path.points.count(); ++i) {
    const int vertex = vertexAt(geometry, path.points[i]);
    if (vertex < 0 || !spreadsPaths(geometry, vertex)) continue;
    const double rest = distance.distance(vertex);
    if (!(rest < left) || vertex == vertexAt(geometry, start)) continue;
    if (path.lengths[i] + rest > left * (1 + kChainRounding)) continue;
    points.insert(points.end(), path.points.begin() + 1, path.points.begin() + i);
    points.push_back(vertexPoint(*geometry.mesh, vertex));
    return vertex;
  }
  points.insert(points.end(), path.points.begin() + 1, path.points.end());
  return -1;
}

/// Follows a straight piece and then the path from its end vertex back to the source. Appends the
/// points, without the first.
void followBack(const Geometry& geometry, const WindowDistance& distance, SurfacePath piece,
                const Arrival& from, Array<SurfacePoint>& points) {
  Arrival arrival = from;
  // Each turn is nearer to the source than the previous one, which bounds the loop by the number of
  // vertices.
  for (;;) {
    int vertex = appendUpToSaddle(geometry, distance, piece, arrival.distance, points);
    if (vertex < 0) {
      vertex = arrival.pseudoSource;
      points.back() = vertex >= 0 ? vertexPoint(*geometry.mesh, vertex) : distance.source();
    }
    if (vertex < 0 || distance.distance(vertex) == 0) return;
    arrival = distance.arrival(vertex);
    piece = traceFromVertex(geometry, vertex, distance.direction(vertex),
                            arrival.distance - arrival.pseudoSourceDistance)
                .path;
  }
}

/// Reverses the points traced from the target to the source, and removes repetitions. Rounding may
/// lead the trace along an edge, or past an edge's end, into a face beside the path. Local paths
/// close such gaps. `length` is the path's distance.
SurfacePath cleaned(const Geometry& geometry, const Array<SurfacePoint>& walked,
                    [[maybe_unused]] double length) {
  const TriangleMesh& mesh = *geometry.mesh;
  SurfacePath path;
  path.points.push_back(walked.back());
  StripWorkspace workspace;
  for (int i = walked.count() - 2; i >= 0; --i) {
    const SurfacePoint& last = path.points.back();
    const SurfacePoint& point = walked[i];
    const bool repeated =
        (position(mesh, point) - position(mesh, last)).norm() <= kLocalRounding * geometry.meanEdge;
    if (repeated && i > 0) continue;
    if (repeated && path.points.count() > 1) path.points.pop_back();
    const SurfacePoint from = path.points.back();
    if (haveCommonFace(mesh, from, point) ||
        !appendLocalPath(geometry, from, point, workspace, path.points)) {
      path.points.push_back(point);
    }
  }
  measure(mesh, path);
  assert(std::abs(path.length() - length) <= kSameMeasure * (length + geometry.meanEdge));
  return path;
}

[[noreturn]] void throwUnreachable() {
  throw Error(ErrorCode::kUnreachable,
              "no path joins the two points: they lie on different components of the mesh");
}

template <class Done>
void growUntil(const Geometry& geometry, WindowDistance& distance, double radius,
               const Done& done) {
  radius = std::max(radius, geometry.meanEdge);
  while (!done() && distance.reached() != kInfinity) {
    distance.grow(radius);
    radius *= 1.25;
  }
}

}  // namespace

SurfacePath shortestPathToVertex(const Geometry& geometry, WindowDistance& distance, int vertex) {
  const SurfacePoint target = vertexPoint(*geometry.mesh, vertex);
  const double chord =
      (position(*geometry.mesh, target) - position(*geometry.mesh, distance.source())).norm();
  growUntil(geometry, distance, 1.05 * chord,
            [&] { return distance.distance(vertex) != kInfinity && distance.isFinal(vertex); });
  if (distance.distance(vertex) == kInfinity) throwUnreachable();
  Array<SurfacePoint> points{target};
  if (distance.distance(vertex) == 0) return {{target, target}, {0, 0}};
  const Arrival& arrival = distance.arrival(vertex);
  const double length = arrival.distance - arrival.pseudoSourceDistance;
  followBack(geometry, distance,
             traceFromVertex(geometry, vertex, distance.direction(vertex), length).path, arrival,
             points);
  return cleaned(geometry, points, distance.distance(vertex));
}

SurfacePath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to) {
  const TriangleMesh& mesh = *geometry.mesh;
  const double chord = (position(mesh, to) - position(mesh, from)).norm();
  const PointLocation end = locate(mesh, to);
  // In one face the straight line is the shortest path.
  if (haveCommonFace(mesh, from, to)) return {{from, to}, {0, chord}};

  WindowDistance distance(geometry);
  distance.setSource(from);
  if (end.simplex == Simplex::kVertex) {
    return shortestPathToVertex(geometry, distance, end.vertex);
  }
  distance.setTarget(to);
  growUntil(geometry, distance, 1.05 * chord, [&] {
    return distance.targetArrival().arrival.distance <= distance.reached() &&
           distance.targetArrival().arrival.distance != kInfinity;
  });
  const TargetArrival& target = distance.targetArrival();
  // Beside needles, rounding may drop the windows that lead to the target. Paths over a corner of
  // its face are then as short as paths through the windows, up to rounding.
  double least = target.arrival.distance * (1 - kChainRounding);
  int over = -1;
  for (int k = 0; k < 3; ++k) {
    const int vertex = mesh.corner(to.face, k);
    const double length = distance.distance(vertex) +
                          (pointInFace(geometry, to) - cornerInFace(geometry, to.face, k)).norm();
    if (!(length < least)) continue;
    least = length;
    over = vertex;
  }
  if (over >= 0) {
    SurfacePath path = shortestPathToVertex(geometry, distance, over);
    appendPoint(mesh, to, path);
    return path;
  }
  if (target.arrival.distance == kInfinity) throwUnreachable();

  Array<SurfacePoint> points{to};
  const double length = target.arrival.distance - target.arrival.pseudoSourceDistance;
  followBack(
      geometry, distance,
      traceStraightest(geometry, inFace(mesh, to, target.face), length * target.direction).path,
      target.arrival, points);
  return cleaned(geometry, points, target.arrival.distance);
}

}  // namespace karcher

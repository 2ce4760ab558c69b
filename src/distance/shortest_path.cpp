#include "distance/shortest_path.h"

#include <algorithm>

#include "intrinsic/local_path.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// Points of a path nearer to each other than this part of a mean edge are one.
constexpr double kRepeatedPoint = 1e-13;

/// Appends the points that a straight piece walked through, without its first.
void appendPiece(const SurfacePath& path, Array<SurfacePoint>& points) {
  points.insert(points.end(), path.points.begin() + 1, path.points.end());
}

/// Follows the path from a vertex back to the source, appending its points.
void followBack(const Geometry& geometry, const ExactDistance& distance, int vertex,
                Array<SurfacePoint>& points) {
  // Each turn is nearer to the source than the last, so there are fewer turns than vertices.
  while (distance.distance(vertex) > 0) {
    const Arrival& arrival = distance.arrival(vertex);
    const double length = arrival.distance - arrival.pseudoSourceDistance;
    appendPiece(traceFromVertex(geometry, vertex, distance.direction(vertex), length).path, points);
    points.back() = arrival.pseudoSource >= 0 ? vertexPoint(*geometry.mesh, arrival.pseudoSource)
                                              : distance.source();
    if (arrival.pseudoSource < 0) return;
    vertex = arrival.pseudoSource;
  }
}

/// Turns the points that were walked from the target to the source round, once each. Along an edge,
/// or past the end of one, rounding may lead a walk into faces next to the path's: there the gap is
/// closed by the straight line.
SurfacePath cleaned(const Geometry& geometry, const Array<SurfacePoint>& walked, double length) {
  const TriangleMesh& mesh = *geometry.mesh;
  SurfacePath path;
  path.points.push_back(walked.back());
  StripWorkspace workspace;
  for (int i = walked.count() - 2; i >= 0; --i) {
    const SurfacePoint& last = path.points.back();
    const SurfacePoint& point = walked[i];
    const bool repeated =
        (position(mesh, point) - position(mesh, last)).norm() <= kRepeatedPoint * geometry.meanEdge;
    if (repeated && i > 0) continue;
    if (repeated && path.points.count() > 1) path.points.pop_back();
    const SurfacePoint from = path.points.back();
    if (haveCommonFace(mesh, from, point) ||
        !appendLocalPath(geometry, from, point, workspace, path.points)) {
      path.points.push_back(point);
    }
  }
  measure(mesh, path);
  path.lengths.back() = length;
  return path;
}

[[noreturn]] void throwUnreachable() {
  throw Error(ErrorCode::kUnreachable,
              "no path joins the two points: they lie on different components of the mesh");
}

template <class Done>
void growUntil(const Geometry& geometry, ExactDistance& distance, double radius, const Done& done) {
  radius = std::max(radius, geometry.meanEdge);
  while (!done() && distance.reached() != kInfinity) {
    distance.grow(radius);
    radius *= 1.25;
  }
}

}  // namespace

SurfacePath shortestPathToVertex(const Geometry& geometry, ExactDistance& distance, int vertex) {
  const SurfacePoint target = vertexPoint(*geometry.mesh, vertex);
  const double chord =
      (position(*geometry.mesh, target) - position(*geometry.mesh, distance.source())).norm();
  growUntil(geometry, distance, 1.05 * chord,
            [&] { return distance.distance(vertex) != kInfinity && distance.isFinal(vertex); });
  if (distance.distance(vertex) == kInfinity) throwUnreachable();
  Array<SurfacePoint> points{target};
  followBack(geometry, distance, vertex, points);
  return cleaned(geometry, points, distance.distance(vertex));
}

SurfacePath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                         const SurfacePoint& to) {
  const TriangleMesh& mesh = *geometry.mesh;
  const double chord = (position(mesh, to) - position(mesh, from)).norm();
  const PointLocation end = locate(mesh, to);
  // In one face the straight line is the shortest path of all.
  if (haveCommonFace(mesh, from, to)) return {{from, to}, {0, chord}};

  ExactDistance distance(geometry);
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
  if (target.arrival.distance == kInfinity) throwUnreachable();

  Array<SurfacePoint> points{to};
  const double length = target.arrival.distance - target.arrival.pseudoSourceDistance;
  appendPiece(
      traceStraightest(geometry, inFace(mesh, to, target.face), length * target.direction).path,
      points);
  if (target.arrival.pseudoSource >= 0) {
    points.back() = vertexPoint(mesh, target.arrival.pseudoSource);
    followBack(geometry, distance, target.arrival.pseudoSource, points);
  } else {
    points.back() = from;
  }
  return cleaned(geometry, points, target.arrival.distance);
}

}  // namespace karcher

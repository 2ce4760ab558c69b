#include "distance/shortest_path.h"

#include <algorithm>

#include "intrinsic/straightest.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// Appends a straight piece, which `path` walked from the target's side, without its first point.
void appendPiece(const StraightestPath& path, Array<SurfacePoint>& points) {
  for (int i = 1; i < path.points.count(); ++i) {
    // A crossing is given in both faces; one is enough where the next point shares a face with it.
    const bool repeated = i + 1 < path.points.count() &&
                          path.points[i + 1].face != path.points[i].face &&
                          path.points[i].face == path.points[i - 1].face;
    if (!repeated) points.push_back(path.points[i]);
  }
}

/// Follows the path from a vertex back to the source, appending its points.
void followBack(const Geometry& geometry, const ExactDistance& distance, int vertex,
                Array<SurfacePoint>& points) {
  // Each turn is nearer to the source than the last, so there are fewer turns than vertices.
  while (distance.distance(vertex) > 0) {
    const Arrival& arrival = distance.arrival(vertex);
    const double length = arrival.distance - arrival.pseudoSourceDistance;
    appendPiece(traceFromVertex(geometry, vertex, distance.direction(vertex), length), points);
    points.back() = arrival.pseudoSource >= 0 ? vertexPoint(*geometry.mesh, arrival.pseudoSource)
                                              : distance.source();
    if (arrival.pseudoSource < 0) return;
    vertex = arrival.pseudoSource;
  }
}

ShortestPath reversed(Array<SurfacePoint> points, double length) {
  std::reverse(points.begin(), points.end());
  return {std::move(points), length};
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

ShortestPath shortestPathToVertex(const Geometry& geometry, ExactDistance& distance, int vertex) {
  const SurfacePoint target = vertexPoint(*geometry.mesh, vertex);
  const double chord =
      (position(*geometry.mesh, target) - position(*geometry.mesh, distance.source())).norm();
  growUntil(geometry, distance, 1.05 * chord,
            [&] { return distance.distance(vertex) != kInfinity && distance.isFinal(vertex); });
  if (distance.distance(vertex) == kInfinity) throwUnreachable();
  Array<SurfacePoint> points{target};
  followBack(geometry, distance, vertex, points);
  return reversed(std::move(points), distance.distance(vertex));
}

ShortestPath shortestPath(const Geometry& geometry, const SurfacePoint& from,
                          const SurfacePoint& to) {
  const TriangleMesh& mesh = *geometry.mesh;
  const double chord = (position(mesh, to) - position(mesh, from)).norm();
  const PointLocation start = locate(mesh, from);
  const PointLocation end = locate(mesh, to);
  // In one face the straight line is the shortest path of all.
  const int across = end.simplex == Simplex::kEdge ? mesh.twin[end.halfedge] : -1;
  if (liesInFace(mesh, start, to.face) || liesInFace(mesh, end, from.face) ||
      (across >= 0 && liesInFace(mesh, start, faceOf(across)))) {
    return {{from, to}, chord};
  }

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
  const ExactDistance::TargetArrival& target = distance.targetArrival();
  if (target.arrival.distance == kInfinity) throwUnreachable();

  Array<SurfacePoint> points{to};
  const double length = target.arrival.distance - target.arrival.pseudoSourceDistance;
  appendPiece(traceStraightest(geometry, inFace(mesh, to, target.face), length * target.direction),
              points);
  if (target.arrival.pseudoSource >= 0) {
    points.back() = vertexPoint(mesh, target.arrival.pseudoSource);
    followBack(geometry, distance, target.arrival.pseudoSource, points);
  } else {
    points.back() = from;
  }
  return reversed(std::move(points), target.arrival.distance);
}

}  // namespace karcher

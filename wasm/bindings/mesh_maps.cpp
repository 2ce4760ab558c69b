#include <algorithm>
#include <cmath>
#include <string>

#include "bindings/mesh_handle.h"
#include "distance/source_vectors.h"
#include "distance/tangent_maps.h"
#include "mesh/error.h"

namespace karcher::bindings {
namespace {

Vec3 vectorAt(const Array<double>& numbers, int i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

/// The path through a caller's points. Consecutive points must share a face.
SurfacePath pathFromJs(const MeshHandle& handle, const val& line) {
  const TriangleMesh& mesh = handle.mesh();
  SurfacePath path = pathThrough(mesh, pointsFromJs(handle.numbering(), mesh, line));
  for (int i = 1; i < path.points.count(); ++i) {
    if (commonFace(mesh, path.points[i - 1], path.points[i]) >= 0) continue;
    throw Error(ErrorCode::kBadArgument, "the points " + std::to_string(i - 1) + " and " +
                                             std::to_string(i) +
                                             " of the line have no face in common");
  }
  return path;
}

/// The points to which an exp map or a mirror leads, for JavaScript.
class MappedPoints {
 public:
  void append(const Geometry& geometry, const ExpMapped& mapped) {
    points_.push_back(mapped.point);
    bindings::append(directions_, tangentToSpace(geometry, mapped.point, mapped.direction));
    remaining_.push_back(mapped.remaining);
  }

  val result(const Numbering& numbering) const {
    val result = val::object();
    result.set("points", toJs(numbering, points_));
    result.set("directions", toJs(directions_));
    result.set("remaining", toJs(remaining_));
    return result;
  }

 private:
  Array<SurfacePoint> points_;
  Array<double> directions_;
  Array<double> remaining_;
};

}  // namespace

val MeshHandle::logMap(const val& from, const val& points, const val& directions) const {
  const Geometry& geometry = surface_.geometry();
  const SurfacePoint start = pointFromJs(numbering_, mesh(), from);
  const Array<SurfacePoint> places = pointsFromJs(numbering_, mesh(), points);
  const Array<double> ways = fromJs<double>(directions);
  FindPathWorkspace workspace;
  Array<double> vectors;
  Array<double> carried;
  for (int i = 0; i < places.count(); ++i) {
    const Vec2 way = tangentFromSpace(geometry, places[i], vectorAt(ways, i));
    const LogMapped mapped = karcher::logMap(geometry, start, places[i], way, workspace);
    append(vectors, tangentToSpace(geometry, start, mapped.vector));
    append(carried, tangentToSpace(geometry, start, mapped.direction));
  }
  val result = val::object();
  result.set("vectors", toJs(vectors));
  result.set("directions", toJs(carried));
  return result;
}

val MeshHandle::logMapOfVertices(const val& from, double radius) {
  const SurfacePoint start = pointFromJs(numbering_, mesh(), from);
  const Geometry& geometry = surface_.geometry();
  const auto solver = makeDistanceSolver(surface_, {});
  solver->setSource(start);
  solver->grow(radius);
  SourceVectors ofVertices(geometry);
  ofVertices.setSource(start);
  // The map from the tangent plane to space is linear, so the images of two vectors determine the
  // map.
  const Vec3 along = tangentToSpace(geometry, start, Vec2::UnitX());
  const Vec3 across = tangentToSpace(geometry, start, Vec2::UnitY());
  Array<double> vectors;
  vectors.reserve(3 * numbering_.engineVertex.size());
  Array<double> distances;
  for (int v = 0; v < mesh().vertexCount(); ++v) distances.push_back(solver->distance(v));
  for (const int v : nearestVertices(distances)) {
    const double distance = v < 0 ? kInfinity : distances[v];
    const bool isReached = distance < kInfinity && distance <= radius;
    Vec3 vector = Vec3::Constant(std::nan(""));
    if (isReached) {
      const Vec2& flat = ofVertices.at(*solver, v);
      vector = flat.x() * along + flat.y() * across;
    }
    append(vectors, vector);
  }
  return toJs(vectors);
}

val MeshHandle::expMap(const val& from, const val& vectors, const val& directions) const {
  const Geometry& geometry = surface_.geometry();
  const SurfacePoint start = pointFromJs(numbering_, mesh(), from);
  const Array<double> ways = fromJs<double>(vectors);
  const Array<double> carried = fromJs<double>(directions);
  MappedPoints mapped;
  for (int i = 0; i < ways.count() / 3; ++i) {
    mapped.append(
        geometry,
        karcher::expMap(geometry, start, tangentFromSpace(geometry, start, vectorAt(ways, i)),
                        tangentFromSpace(geometry, start, vectorAt(carried, i))));
  }
  return mapped.result(numbering_);
}

val MeshHandle::mirror(const val& line, const val& points, const val& directions) const {
  const Geometry& geometry = surface_.geometry();
  const SurfacePath path = pathFromJs(*this, line);
  const Array<SurfacePoint> places = pointsFromJs(numbering_, mesh(), points);
  const Array<double> ways = fromJs<double>(directions);
  FindPathWorkspace workspace;
  MappedPoints mapped;
  for (int i = 0; i < places.count(); ++i) {
    const Vec2 way = tangentFromSpace(geometry, places[i], vectorAt(ways, i));
    mapped.append(geometry, mirrored(geometry, path, places[i], way, workspace));
  }
  return mapped.result(numbering_);
}

val MeshHandle::transport(const val& from, const val& to, const val& vectors) const {
  const Geometry& geometry = surface_.geometry();
  const SurfacePoint start = pointFromJs(numbering_, mesh(), from);
  const SurfacePoint end = pointFromJs(numbering_, mesh(), to);
  const Array<double> ways = fromJs<double>(vectors);
  FindPathWorkspace workspace;
  const SurfacePath path = pathBetween(geometry, start, end, workspace);
  Array<double> carried;
  for (int i = 0; i < ways.count() / 3; ++i) {
    const Vec2 way = tangentFromSpace(geometry, start, vectorAt(ways, i));
    append(carried, tangentToSpace(geometry, end, karcher::transportAlong(geometry, path, way)));
  }
  return toJs(carried);
}

val MeshHandle::pointsAlong(const val& line, const val& lengths, double length, int count) const {
  const SurfacePath path = pathFromJs(*this, line);
  Array<double> places = fromJs<double>(lengths);
  const double whole = length > 0 ? length : path.length();
  const bool isClosed = samePlace(mesh(), path.start(), path.end());
  for (int i = 0; i < count; ++i) {
    places.push_back(whole * i / std::max(1, isClosed ? count : count - 1));
  }
  const double scale = whole > 0 ? path.length() / whole : 0;
  Array<SurfacePoint> points;
  for (double& place : places) {
    place = std::clamp(place, 0.0, whole);
    points.push_back(pointAlong(mesh(), path, scale * place));
  }
  val result = val::object();
  result.set("points", toJs(numbering_, points));
  result.set("lengths", toJs(places));
  return result;
}

val MeshHandle::transportAlong(const val& line, const val& vectors) const {
  const Geometry& geometry = surface_.geometry();
  const SurfacePath path = pathFromJs(*this, line);
  const Array<double> ways = fromJs<double>(vectors);
  Array<double> carried;
  for (int i = 0; i < ways.count() / 3; ++i) {
    Vec2 way = tangentFromSpace(geometry, path.start(), vectorAt(ways, i));
    // The path may turn at every point, but is straight between two points. So the loop transports
    // the vectors along one straight piece after the other.
    for (int k = 1; k < path.points.count(); ++k) {
      const SurfacePath piece{{path.points[k - 1], path.points[k]},
                              {0, path.lengths[k] - path.lengths[k - 1]}};
      way = karcher::transportAlong(geometry, piece, way);
    }
    append(carried, tangentToSpace(geometry, path.end(), way));
  }
  return toJs(carried);
}

}  // namespace karcher::bindings

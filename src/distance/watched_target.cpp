#include "distance/watched_target.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "mesh/error.h"

namespace karcher {

void WatchedTarget::clear() {
  faces_[0] = faces_[1] = -1;
  best_ = {};
}

void WatchedTarget::set(const SurfacePoint& point) {
  const TriangleMesh& mesh = *geometry_.mesh;
  const PointLocation location = locate(mesh, point);
  if (location.simplex == Simplex::kVertex) {
    throw Error(ErrorCode::kBadArgument,
                "a target must lie inside a face or on an edge, not at vertex " +
                    std::to_string(location.vertex) + ": read the vertex's distance");
  }
  point_ = point;
  best_ = {};
  faces_[0] = point.face;
  const int t = location.simplex == Simplex::kEdge ? mesh.twin[location.halfedge] : -1;
  faces_[1] = t >= 0 ? faceOf(t) : -1;
}

void WatchedTarget::arriveFromCorner(int h, int vertex, double distance) {
  const Vec2 toVertex = -pointOver(h);
  arrive(h, {distance + toVertex.norm(), distance, vertex}, toVertex);
}

void WatchedTarget::arriveThrough(int h, const Window& window) {
  const Vec2 point = pointOver(h);
  const Vec2 toSource = Vec2(window.sourceX, -window.depth) - point;
  Arrival arrival{window.offset + toSource.norm(), window.offset, window.pseudoSource};
  const double crossing = point.y() > 0 ? crossingTowards(window, point) : point.x();
  const double nearest = std::clamp(crossing, window.begin, window.end);
  if (std::abs(crossing - nearest) <= kSeenTolerance * geometry_.edgeLength[h]) {
    arrive(h, arrival, toSource);
  } else {
    const Vec2 toBend = Vec2(nearest, 0) - point;
    arrival.distance = bentLength(distanceAt(window, nearest) + toBend.norm());
    arrive(h, arrival, toBend);
  }
}

/// The target in the frame of half-edge h of one of its faces.
Vec2 WatchedTarget::pointOver(int h) const {
  const SurfacePoint point = inFace(*geometry_.mesh, point_, faceOf(h));
  return Vec2(point.bary[cornerOf(next(h))] * geometry_.edgeLength[h], 0) +
         point.bary[cornerOf(previous(h))] * oppositeOverHalfedge(geometry_, h);
}

/// Replaces the best arrival if an arrival through half-edge h is better. `toSource` is in the
/// frame of h.
void WatchedTarget::arrive(int h, const Arrival& arrival, const Vec2& toSource) {
  const bool isBetter =
      isTie(arrival.distance, best_.arrival.distance)
          ? std::tie(h, arrival.pseudoSource) < std::tie(via_, best_.arrival.pseudoSource)
          : arrival.distance < best_.arrival.distance;
  if (!isBetter) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  via_ = h;
  best_ = {arrival, faceOf(h), rotate(along, toSource.normalized())};
}

}  // namespace karcher

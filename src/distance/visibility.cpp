#include "distance/visibility.h"

#include <algorithm>

#include "intrinsic/angles.h"

namespace karcher {
namespace {

/// The limit for the windows of one call. Only a surface folded upon itself many times comes near
/// this limit.
constexpr int kMostWindows = 200'000;

/// Rings extend past a vertex only if it has at most this number of edges. Otherwise all its
/// neighbours would see each other, and each pair of them would have an arc. Paths to the vertices
/// behind it lead over the vertex itself, or from neighbour to neighbour.
constexpr int kMostEdges = 256;

bool hasManyEdges(const TriangleMesh& mesh, int vertex) {
  int edges = 0;
  for ([[maybe_unused]] const int h : outgoingHalfedges(mesh, vertex)) {
    if (++edges > kMostEdges) return true;
  }
  return false;
}

}  // namespace

Visibility::Visibility(const Geometry& geometry) : geometry_(geometry), mesh_(*geometry.mesh) {
  const size_t vertices = mesh_.positions.size();
  ringCall_.assign(vertices, 0);
  sightCall_.assign(vertices, 0);
  sightOf_.assign(vertices, 0);
}

const Array<Visibility::Sight>& Visibility::fromVertex(int vertex, int rings) {
  start();
  allowRing(vertex, rings);
  for (const int h : outgoingHalfedges(mesh_, vertex)) {
    const int onward = next(h);
    const int back = previous(h);
    see(mesh_.head(h), geometry_.edgeLength[h],
        geometry_.cumulatedAngle[onward] + geometry_.cornerAngle[onward]);
    if (mesh_.twin[back] < 0) {
      see(mesh_.tail(back), geometry_.edgeLength[back], geometry_.cumulatedAngle[back]);
    }
    const int t = mesh_.twin[onward];
    if (t >= 0) {
      // Seen from the face behind, the edge has the opposite direction and the vertex lies below
      // it.
      const Vec2 apex = oppositeOverHalfedge(geometry_, onward);
      const double length = geometry_.edgeLength[t];
      addWindow(t, {0, length, length - apex.x(), apex.y()});
    }
  }
  run();
  return sights_;
}

const Array<Visibility::Sight>& Visibility::fromPoint(const SurfacePoint& point) {
  start();
  const PointLocation location = locate(mesh_, point);
  const int across = location.simplex == Simplex::kEdge ? mesh_.twin[location.halfedge] : -1;
  for (int side = 0; side < (across >= 0 ? 2 : 1); ++side) {
    const int face = side == 0 ? point.face : faceOf(across);
    for (int k = 0; k < 3; ++k) allowRing(mesh_.corner(face, k), 1);
  }
  for (int side = 0; side < (across >= 0 ? 2 : 1); ++side) {
    const SurfacePoint here = side == 0 ? point : inFace(mesh_, point, faceOf(across));
    const Vec2 x = pointInFace(geometry_, here);
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * here.face + k;
      const Vec2 toPoint = x - cornerInFace(geometry_, here.face, k);
      see(mesh_.tail(h), toPoint.norm(), directionAtTail(geometry_, h, toPoint));
      const int t = mesh_.twin[h];
      if (t < 0 || here.bary[cornerOf(previous(h))] == 0) continue;
      const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
      const double length = geometry_.edgeLength[t];
      addWindow(t, {0, length, length - toPoint.dot(along), cross(along, toPoint)});
    }
  }
  run();
  return sights_;
}

void Visibility::start() {
  ++call_;
  sights_.clear();
  windows_.clear();
}

void Visibility::allowRing(int vertex, int rings) {
  ring_.assign(1, vertex);
  ringCall_[vertex] = call_;
  int begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const int end = ring_.count();
    for (; begin < end; ++begin) {
      if (ring > 0 && hasManyEdges(mesh_, ring_[begin])) continue;
      for (const int h : outgoingHalfedges(mesh_, ring_[begin])) {
        for (const int w : {mesh_.head(h), mesh_.opposite(h)}) {
          if (allowed(w)) continue;
          ringCall_[w] = call_;
          ring_.push_back(w);
        }
      }
    }
  }
}

double Visibility::seen(int vertex) const {
  return sightCall_[vertex] == call_ ? sights_[sightOf_[vertex]].length : kInfinity;
}

void Visibility::see(int vertex, double length, double direction) {
  if (sightCall_[vertex] != call_) {
    sightCall_[vertex] = call_;
    sightOf_[vertex] = sights_.count();
    sights_.push_back({vertex, length, direction});
  } else if (Sight& sight = sights_[sightOf_[vertex]]; length < sight.length) {
    sight = {vertex, length, direction};
  }
}

void Visibility::addWindow(int h, Window window) {
  if (!allowed(mesh_.opposite(h))) return;
  // No shortest path crosses a part of the edge where the path over one of its ends is shorter
  // (Xin, Wang 2009).
  const double length = geometry_.edgeLength[h];
  if (trimByTail(window, seen(mesh_.tail(h))) && trimByHead(window, seen(mesh_.head(h)), length) &&
      !isTooNarrow(window, kNarrowestWindow * length)) {
    windows_.push_back({h, window});
  }
}

void Visibility::carryAcross(int h, const Window& window) {
  const int right = next(h);
  const int left = previous(h);
  const double length = geometry_.edgeLength[h];
  const Vec2 apex = oppositeOverHalfedge(geometry_, h);
  const double crossing = crossingTowards(window, apex);
  const double tolerance = kNarrowestWindow * length;
  if (crossing >= window.begin - tolerance && crossing <= window.end + tolerance) {
    const Vec2 back = Vec2(window.sourceX, -window.depth) - apex;
    const double angle = angleFromTo(-apex, back);
    see(mesh_.opposite(h), back.norm(), geometry_.cumulatedAngle[left] + angle);
  }
  if (crossing > window.begin && mesh_.twin[left] >= 0) {
    addWindow(mesh_.twin[left], carriedToTailEdge(window, apex.normalized(), length,
                                                  geometry_.edgeLength[left], crossing));
  }
  if (crossing < window.end && mesh_.twin[right] >= 0) {
    const double edge = geometry_.edgeLength[right];
    const Vec2 along = Vec2(length - apex.x(), apex.y()).normalized();
    addWindow(mesh_.twin[right], mirrored(carriedToTailEdge(mirrored(window, length), along, length,
                                                            edge, length - crossing),
                                          edge));
  }
}

void Visibility::run() {
  for (int i = 0; i < windows_.count() && i < kMostWindows; ++i) {
    const WaitingWindow waiting = windows_[i];
    carryAcross(waiting.halfedge, waiting.window);
  }
}

}  // namespace karcher

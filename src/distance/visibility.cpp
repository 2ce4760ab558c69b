#include "distance/visibility.h"

#include <algorithm>

namespace karcher {
namespace {

/// Intervals narrower than this part of their edge see nothing.
constexpr double kNarrowest = 1e-11;
/// A bound on the windows of one call; only a surface folded upon itself many times comes near.
constexpr int kMostWindows = 200'000;

/// The vertex opposite to half-edge h where h runs from the origin along the x axis.
Vec2 oppositeOf(const Geometry& geometry, int h) {
  const double base = geometry.edgeLength[h];
  const double left = geometry.edgeLength[previous(h)];
  const double right = geometry.edgeLength[next(h)];
  return {(base * base + left * left - right * right) / (2 * base),
          doubleArea(geometry, faceOf(h)) / base};
}

}  // namespace

Visibility::Visibility(const Geometry& geometry) : geometry_(geometry), mesh_(*geometry.mesh) {
  const size_t vertices = mesh_.positions.size();
  ringStamp_.assign(vertices, 0);
  sightStamp_.assign(vertices, 0);
  sightOf_.assign(vertices, 0);
}

const Array<Visibility::Sight>& Visibility::fromVertex(int vertex, int rings) {
  start();
  allowRing(vertex, rings);
  const int first = mesh_.outgoing[vertex];
  int h = first;
  do {
    const int onward = next(h);
    const int back = previous(h);
    see(mesh_.head(h), geometry_.edgeLength[h],
        geometry_.cumulatedAngle[onward] + geometry_.cornerAngle[onward]);
    if (mesh_.twin[back] < 0) {
      see(mesh_.tail(back), geometry_.edgeLength[back], geometry_.cumulatedAngle[back]);
    }
    const int t = mesh_.twin[onward];
    if (t >= 0) {
      // Seen from the face behind, the edge runs the other way and the vertex lies below it.
      const Vec2 apex = oppositeOf(geometry_, onward);
      const double length = geometry_.edgeLength[t];
      addWindow(t, 0, length, length - apex.x(), -apex.y());
    }
    h = rotateLeft(mesh_, h);
  } while (h >= 0 && h != first);
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
      addWindow(t, 0, length, length - toPoint.dot(along), -cross(along, toPoint));
    }
  }
  run();
  return sights_;
}

void Visibility::start() {
  ++stamp_;
  sights_.clear();
  windows_.clear();
}

void Visibility::allowRing(int vertex, int rings) {
  ring_.assign(1, vertex);
  ringStamp_[vertex] = stamp_;
  int begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const int end = ring_.count();
    for (; begin < end; ++begin) {
      const int first = mesh_.outgoing[ring_[begin]];
      int h = first;
      do {
        for (const int w : {mesh_.head(h), mesh_.opposite(h)}) {
          if (allowed(w)) continue;
          ringStamp_[w] = stamp_;
          ring_.push_back(w);
        }
        h = rotateLeft(mesh_, h);
      } while (h >= 0 && h != first);
    }
  }
}

double Visibility::seen(int vertex) const {
  return sightStamp_[vertex] == stamp_ ? sights_[sightOf_[vertex]].length : kInfinity;
}

void Visibility::see(int vertex, double length, double direction) {
  if (sightStamp_[vertex] != stamp_) {
    sightStamp_[vertex] = stamp_;
    sightOf_[vertex] = sights_.count();
    sights_.push_back({vertex, length, direction});
  } else if (Sight& sight = sights_[sightOf_[vertex]]; length < sight.length) {
    sight = {vertex, length, direction};
  }
}

void Visibility::addWindow(int h, double from, double to, double x, double y) {
  const double length = geometry_.edgeLength[h];
  if (to - from < kNarrowest * length || !allowed(mesh_.opposite(h))) return;
  // A window that an end of its edge beats throughout leads to no shortest path (Xin, Wang 2009).
  constexpr double kRounding = 1 - 1e-12;
  if (seen(mesh_.tail(h)) + to < std::hypot(x - to, y) * kRounding) return;
  if (seen(mesh_.head(h)) + length - from < std::hypot(x - from, y) * kRounding) return;
  windows_.push_back({h, from, to, x, y});
}

void Visibility::carryAcross(const Window& w) {
  const int right = next(w.halfedge);
  const int left = previous(w.halfedge);
  const double base = geometry_.edgeLength[w.halfedge];
  const Vec2 apex = oppositeOf(geometry_, w.halfedge);
  const Vec2 source(w.x, w.y);
  // Where the line from the source to the apex crosses the half-edge.
  const double crossing = w.x + (apex.x() - w.x) * -w.y / (apex.y() - w.y);
  const double tolerance = kNarrowest * base;
  if (crossing >= w.from - tolerance && crossing <= w.to + tolerance) {
    const Vec2 back = source - apex;
    const double angle = std::atan2(cross(-apex, back), (-apex).dot(back));
    see(mesh_.opposite(w.halfedge), back.norm(), geometry_.cumulatedAngle[left] + angle);
  }

  // The point of the line through `start` along `unit` that is seen through x on the half-edge.
  const auto project = [&](double x, const Vec2& start, const Vec2& unit) {
    const Vec2 ray(x - w.x, -w.y);
    const Vec2 toStart = start - source;
    return cross(toStart, ray) / cross(ray, unit);
  };
  if (crossing > w.from && mesh_.twin[left] >= 0) {
    const double length = geometry_.edgeLength[left];
    const Vec2 unit = apex / length;
    const double from = w.from <= 0 ? 0 : std::max(0.0, project(w.from, Vec2::Zero(), unit));
    const double to =
        w.to >= crossing ? length : std::min(length, project(w.to, Vec2::Zero(), unit));
    addWindow(mesh_.twin[left], from, to, source.dot(unit), cross(unit, source));
  }
  if (crossing < w.to && mesh_.twin[right] >= 0) {
    const double length = geometry_.edgeLength[right];
    const Vec2 unit = (Vec2(base, 0) - apex) / length;
    const double from = w.from <= crossing ? 0 : std::max(0.0, project(w.from, apex, unit));
    const double to = w.to >= base ? length : std::min(length, project(w.to, apex, unit));
    addWindow(mesh_.twin[right], from, to, (source - apex).dot(unit), cross(unit, source - apex));
  }
}

void Visibility::run() {
  for (int i = 0; i < windows_.count() && i < kMostWindows; ++i) {
    const Window window = windows_[i];
    carryAcross(window);
  }
}

}  // namespace karcher

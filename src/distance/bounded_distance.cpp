#include "distance/bounded_distance.h"

#include <algorithm>
#include <cmath>

namespace karcher {
namespace {

/// A strip ends when a path is found that is longer than the value by this part of the tolerance:
/// the rest is for paths that go on from it.
constexpr double kEnough = 0.4;

/// A path that is shorter than the value by this part of the tolerance takes its place.
constexpr double kShorter = 0.1;

/// So far off, as a part of the tolerance, may be a value that is held to the exact distance.
constexpr double kNearTolerance = 0.8;

/// The nearest vertices that are held to exact distances. Fast ones are too long there first, where
/// paths to neighbours differ most.
constexpr int kNear = 400;

/// Faces of a strip at most.
constexpr int kLongestStrip = 200;
constexpr int kShortStrip = 12;  ///< in the direction of a neighbour's path

/// Neighbours' paths come from another side where their directions differ by more than this,
/// radians, and by more than they do round a source at that distance.
constexpr double kOtherSide = 0.1;

}  // namespace

BoundedDistance::BoundedDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans,
                                 const std::shared_ptr<PagePool>& pages, double tolerance)
    : geometry_(geometry),
      mesh_(*geometry.mesh),
      tolerance_(tolerance),
      fast_(geometry, std::move(fans), pages),
      paths_(mesh_.vertexCount(), pages) {
  fast_.keepSettled();
}

void BoundedDistance::setSource(const SurfacePoint& source) {
  source_ = source;
  sources_.clear();
  const PointLocation place = locate(mesh_, source);
  if (place.simplex != Simplex::kVertex) sources_.push_back(source);
  if (place.simplex == Simplex::kEdge && mesh_.twin[place.halfedge] >= 0) {
    sources_.push_back(inFace(mesh_, source, faceOf(mesh_.twin[place.halfedge])));
  }
  paths_.clear();
  waiting_.clear();
  isExactOn_ = false;
  trusted_ = kInfinity;
  checked_ = -1;
  nearLeft_ = kNear;
  if (!exact_) exact_ = std::make_unique<ExactDistance>(geometry_);
  exact_->setSource(source);
  fast_.setSource(source);
}

void BoundedDistance::grow(double radius) {
  if (!isExactOn_ && reached() < radius) {
    fast_.grow(radius / kShortest);
    check();
  }
  if (isExactOn_) exact_->grow(radius);
}

double BoundedDistance::growTo(int vertex) {
  if (!isExactOn_ && !isFinal(vertex)) {
    fast_.grow(fast_.growTo(vertex));
    check();
  }
  return isFast(vertex) ? distance(vertex) : exact_->growTo(vertex);
}

/// Looks at the values that have become final, in their order: so what is found depends on the
/// source alone.
void BoundedDistance::check() {
  const double limit = fast_.reached();
  fast_.takeSettled(waiting_);
  batch_.clear();
  int left = 0;
  for (const int v : waiting_) {
    const double value = fast_.distance(v);
    if (value <= limit) {
      batch_.emplace_back(value, v);
    } else {
      waiting_[left++] = v;
    }
  }
  waiting_.resize(static_cast<size_t>(left));
  std::sort(batch_.begin(), batch_.end());
  for (const auto& [value, vertex] : batch_) {
    if (!stands(vertex, value)) {
      goOnExactly(value);
      return;
    }
  }
  checked_ = limit;
}

void BoundedDistance::goOnExactly(double from) {
  exact_->grow(from);
  trusted_ = from;
  checked_ = kInfinity;
  isExactOn_ = true;
}

Vec2 BoundedDistance::logVector(int vertex) const {
  if (!isFast(vertex)) return exact_->logVector(vertex);
  const Path* path = paths_.find(vertex);
  if (path == nullptr || !path->isShorter) return fast_.logVector(vertex);
  return logVectorAlong(geometry_, vertex, path->length, path->direction);
}

bool BoundedDistance::stands(int vertex, double value) {
  if (nearLeft_ > 0) {
    --nearLeft_;
    const double exact = exact_->growTo(vertex);
    if (std::abs(value - exact) > kNearTolerance * tolerance_ * exact) return false;
  }
  Path& path = paths_.touch(vertex);
  path = ownPath(vertex, value);
  const double shorter = value * (1 - kShorter * tolerance_);
  const double most = value * (1 + tolerance_);
  const bool isDoubtful = path.length > most;
  const int mostFaces = isDoubtful ? kLongestStrip : kShortStrip;
  // The neighbours whose paths come from another side; where there is doubt all of them.
  const VertexFans& fans = fast_.fans();
  for (int i = fans.begin[vertex]; i < fans.end(vertex); ++i) {
    const FanEdge& edge = fans.edges[i];
    const double nearer = fast_.distance(edge.head);
    if (!(nearer < value) || !(nearer > 0)) continue;
    const double turn = kOtherSide + edge.length / nearer;
    if (!isDoubtful && fast_.agreement(vertex, i) >= 1 - turn * turn / 2) continue;
    const double direction =
        fans.angles[i] + fast_.direction(edge.head) - fans.angles[edge.reverse] - kPi;
    const Path other = pathTowards(vertex, direction, value, 0, mostFaces);
    if (other.length < path.length) path = other;
  }
  path.isShorter = path.length < shorter;
  return path.length <= most && path.length >= value * kShortest;
}

/// The length of a path over a vertex that is nearer than the one it leads to.
double BoundedDistance::lengthVia(int vertex, double value, double leg) const {
  if (!(fast_.distance(vertex) < value)) return kInfinity;
  const Path* path = paths_.find(vertex);
  return path == nullptr ? kInfinity : path->length + leg;
}

/// The path to a vertex from where its value comes.
BoundedDistance::Path BoundedDistance::ownPath(int vertex, double value) const {
  for (const SurfacePoint& source : sources_) {
    const Triangle& corners = mesh_.faces[source.face];
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return {value};
  }
  const PathStep step = fast_.stepTo(vertex);
  if (step.tail < 0) return {value};
  const double enough = value * (1 + kEnough * tolerance_);
  for (const int out : outgoingHalfedges(mesh_, vertex)) {
    if (mesh_.head(out) != step.tail) continue;
    const int last = previous(out);
    Strip strip{next(out),
                Vec2(geometry_.edgeLength[out], 0),
                geometry_.edgeLength[last] * unitVector(geometry_.cornerAngle[out]),
                {},
                geometry_.cumulatedAngle[out]};
    strip.along = strip.tail + (step.tail == step.head ? 0 : step.part) * (strip.head - strip.tail);
    return pathAlong(strip, value, enough, kLongestStrip);
  }
  // Along the last edge of the boundary.
  for (const int out : outgoingHalfedges(mesh_, vertex)) {
    if (mesh_.opposite(out) != step.tail) continue;
    return {lengthVia(step.tail, value, geometry_.edgeLength[previous(out)]),
            geometry_.totalAngle[vertex]};
  }
  return {};
}

BoundedDistance::Path BoundedDistance::pathTowards(int vertex, double direction, double value,
                                                   double enough, int mostFaces) const {
  const double total = geometry_.totalAngle[vertex];
  if (mesh_.onBoundary[vertex]) {
    if (direction < 0) direction += 2 * kPi;
  } else {
    direction -= total * std::floor(direction / total);
  }
  for (const int out : outgoingHalfedges(mesh_, vertex)) {
    const double inCorner = direction - geometry_.cumulatedAngle[out];
    if (!(inCorner >= 0 && inCorner <= geometry_.cornerAngle[out])) continue;
    return pathAlong({next(out), Vec2(geometry_.edgeLength[out], 0),
                      geometry_.edgeLength[previous(out)] * unitVector(geometry_.cornerAngle[out]),
                      unitVector(inCorner), geometry_.cumulatedAngle[out]},
                     value, enough, mostFaces);
  }
  return {};
}

/// The shortest path to the origin of a strip from a vertex in sight of it; of one that is not
/// longer than `enough` the first.
BoundedDistance::Path BoundedDistance::pathAlong(Strip strip, double value, double enough,
                                                 int mostFaces) const {
  int& h = strip.halfedge;
  double best = kInfinity;
  Vec2 leg = strip.along;
  const auto take = [&](double length, const Vec2& from) {
    if (!(length < best)) return;
    best = length;
    leg = from;
  };
  take(lengthVia(mesh_.tail(h), value, strip.tail.norm()), strip.tail);
  take(lengthVia(mesh_.head(h), value, strip.head.norm()), strip.head);
  // What lies between these is in sight.
  Vec2 right = strip.tail;
  Vec2 left = strip.head;
  const auto isInSight = [&](const Vec2& point) {
    return cross(right, point) >= 0 && cross(point, left) >= 0;
  };
  for (int face = 0; face < mostFaces && best > enough; ++face) {
    const int twin = mesh_.twin[h];
    if (twin < 0) break;
    const Vec2 edge = (strip.tail - strip.head) / geometry_.edgeLength[twin];
    const Vec2 apex = strip.head + rotate(edge, oppositeOverHalfedge(geometry_, twin));
    for (const SurfacePoint& source : sources_) {
      if (faceOf(twin) != source.face) continue;
      const Vec2 at = source.bary[cornerOf(twin)] * strip.head +
                      source.bary[cornerOf(next(twin))] * strip.tail +
                      source.bary[cornerOf(previous(twin))] * apex;
      if (isInSight(at)) take(at.norm(), at);
    }
    const bool isSeen = isInSight(apex);
    if (isSeen) take(lengthVia(mesh_.opposite(twin), value, apex.norm()), apex);
    if (cross(strip.along, apex) > 0) {
      if (isSeen) left = apex;
      strip.head = apex;
      h = next(twin);
    } else {
      if (isSeen) right = apex;
      strip.tail = apex;
      h = previous(twin);
    }
  }
  return {best, strip.right + (best < value ? std::atan2(leg.y(), leg.x()) : 0)};
}

}  // namespace karcher

#include "distance/fast_distance.h"

namespace karcher {
namespace {

/// A distance counts as shorter only if it is by this part: otherwise rounding alone would settle
/// vertices again and again.
constexpr double kShorter = 1 - 1e-15;

/// By how much of the longest edge a vertex may be settled later than in its turn. A path that
/// crosses an edge is known once the nearer end is settled, which is at most half the edge further.
constexpr double kLateness = 0.5;

/// An end that is not settled yet is waited for if it is expected earlier than the apex by this
/// part of the edge.
constexpr double kWait = 0.1;

/// The line from a source may miss the edge by this part of it for the edge to be looked at.
constexpr double kFarBeside = 1;

}  // namespace

FastDistance::FastDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans)
    : geometry_(geometry),
      fans_(fans ? std::move(fans) : std::make_shared<const VertexFans>(buildVertexFans(geometry))),
      jets_(geometry.mesh->vertexCount()),
      queue_(geometry.meanEdge / 8) {}

void FastDistance::setSource(const SurfacePoint& source) {
  source_ = source;
  jets_.clear();
  touched_.clear();
  queue_.clear();
  front_ = 0;
  longest_ = 0;
  barrier_ = -1;
  const TriangleMesh& mesh = *geometry_.mesh;
  const PointLocation place = locate(mesh, source);
  if (place.simplex == Simplex::kVertex) {
    Jet start;
    start.distance = 0;
    start.corner = fans_->begin[place.vertex];
    arrive(jets_.touch(place.vertex), place.vertex, start);
    return;
  }
  placeInFace(place.face, pointInFace(geometry_, source));
  const int twin = place.simplex == Simplex::kEdge ? mesh.twin[place.halfedge] : -1;
  if (twin >= 0) {
    placeInFace(faceOf(twin), pointInFace(geometry_, inFace(mesh, source, faceOf(twin))));
  }
}

void FastDistance::placeInFace(int face, const Vec2& source) {
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const int v = geometry_.mesh->tail(h);
    const Vec2 edge = halfedgeInFace(geometry_, h);
    const Vec2 toSource = source - cornerInFace(geometry_, face, k);
    longest_ = std::max(longest_, geometry_.edgeLength[h]);
    Jet start;
    start.distance = toSource.norm();
    start.corner = fanEdge(*fans_, v, geometry_.mesh->head(h));
    const Vec2 inFan = rotate(fans_->edges[start.corner].vector, rotateBack(edge, toSource));
    start.toSource = inFan.normalized();
    Jet& jet = jets_.touch(v);
    if (start.distance < jet.distance) arrive(jet, v, start);
  }
}

void FastDistance::grow(double radius) {
  while (barrier_ < radius) {
    if (queue_.empty()) {
      barrier_ = kInfinity;
      return;
    }
    const OrderedQueue::Entry entry = queue_.pop();
    Jet& jet = jets_.touch(entry.item);
    // Entries that a shorter way has outdated are left in the queue.
    if (jet.settled || static_cast<float>(jet.distance) != entry.key) continue;
    settle(entry.item);
    barrier_ = std::max(barrier_, front_ - kLateness * longest_);
  }
}

/// Lists the edges of a vertex from the one after `corner` on, laid side by side in the plane.
void FastDistance::gatherSpokes(int vertex, int corner) {
  const int begin = fans_->begin[vertex];
  const int end = fans_->end(vertex);
  const bool closed = !fans_->onBoundary(vertex);
  const Vec2 turn = fans_->turn[vertex];
  const int count = end - begin;
  const int beforeEnd = end - 1 - corner;
  gap_ = closed ? count : beforeEnd;
  spokes_.resize(static_cast<size_t>(count));
  Spoke* spoke = spokes_.data();
  for (int i = 0; i < count; ++i, ++spoke) {
    const bool wraps = i >= beforeEnd;
    const FanEdge& edge = fans_->edges[wraps ? begin + i - beforeEnd : corner + 1 + i];
    spoke->vector = wraps && closed ? rotate(turn, edge.vector) : edge.vector;
    spoke->length =
        std::sqrt(edge.vector.x() * edge.vector.x() + edge.vector.y() * edge.vector.y());
    spoke->jet = &jets_.touch(edge.head);
    spoke->head = edge.head;
    spoke->reverse = edge.reverse;
    longest_ = std::max(longest_, spoke->length);
    if (i > 0) {
      Spoke& last = spoke[-1];
      last.dot = last.vector.x() * spoke->vector.x() + last.vector.y() * spoke->vector.y();
      last.doubleArea = cross(last.vector, spoke->vector);
    }
  }
}

void FastDistance::settle(int vertex) {
  Jet& own = jets_.touch(vertex);
  own.settled = true;
  front_ = std::max(front_, own.distance);
  gatherSpokes(vertex, own.corner);
  for (const Spoke& spoke : spokes_) goAlongEdge(own, spoke);
  if (own.distance == 0) return;
  crossEdges<1>(vertex, own, own.toSource);
  const bool closed = !fans_->onBoundary(vertex);
  crossEdges<-1>(vertex, own, closed ? rotate(fans_->turn[vertex], own.toSource) : own.toSource);
}

void FastDistance::goAlongEdge(const Jet& own, const Spoke& spoke) {
  const double distance = own.distance + spoke.length;
  if (!(distance < spoke.jet->distance * kShorter) || distance <= barrier_) return;
  Jet jet;
  jet.distance = distance;
  jet.base = own.distance;
  jet.toSource = fans_->edges[spoke.reverse].vector / spoke.length;
  jet.corner = spoke.reverse;
  jet.alongEdge = true;
  arrive(*spoke.jet, spoke.head, jet);
}

/// Takes the edges counterclockwise (kSide = 1) or clockwise (kSide = -1) from the direction to the
/// source, and goes over each into the triangle that follows.
template <int kSide>
void FastDistance::crossEdges(int vertex, const Jet& own, const Vec2& toSource) {
  const double radius = own.distance - own.base;
  const Spoke* const last =
      kSide > 0 ? spokes_.data() + gap_ - 1 : spokes_.data() + (gap_ == spokes_.count() ? 0 : gap_);
  const Spoke* spoke = kSide > 0 ? spokes_.data() : spokes_.data() + spokes_.count() - 1;
  if (kSide > 0 ? spoke > last : spoke < last) return;
  for (; spoke != last; spoke += kSide) {
    const Jet& other = *spoke->jet;
    const double sine =
        kSide * (toSource.x() * spoke->vector.y() - toSource.y() * spoke->vector.x());
    const bool settled = other.settled;
    if (sine < 0 && !settled) continue;

    // No path over the edge is shorter than (d_v + d_w - length) / 2 and the height above the edge.
    // If that is no less than the distance of an end that is not settled, the end comes first.
    const Spoke& target = spoke[kSide];
    const Spoke& corner = kSide > 0 ? *spoke : target;
    const double length = spoke->length;
    double limit = target.jet->distance;
    if (!settled) limit = std::min(limit, other.distance);
    if (corner.doubleArea >= length * (limit - 0.5 * (own.distance + other.distance - length))) {
      continue;
    }
    const double cosine = toSource.x() * spoke->vector.x() + toSource.y() * spoke->vector.y();
    const double squared = length * length;
    if (sine >= 0) {
      const double drop = corner.doubleArea + radius * sine;
      const double crossing = radius * (cosine * corner.doubleArea + corner.dot * sine);
      if (crossing < -kFarBeside * squared * drop || crossing > (1 + kFarBeside) * squared * drop) {
        continue;
      }
    }
    if (!settled) {
      // The same for straight paths from this vertex's source, by bounds without a root.
      const double away = radius - cosine;
      const double gain =
          (cosine - kWait * length) * squared - corner.dot * cosine + corner.doubleArea * sine;
      if (away > 0 && 2 * away * gain > (squared - cosine * cosine) * squared) continue;
    }
    if ((fans_->flags[vertex] & VertexFans::kWide) != 0 &&
        looksTooFar(vertex, fans_->edges[spoke->reverse].reverse, kSide)) {
      continue;
    }
    const double inverse = 1 / length;
    EdgeEnd end;
    end.cosine = cosine * inverse;
    end.sine = sine * inverse;
    end.seen = sine >= 0;
    end.distance = own.distance * inverse;
    end.base = own.base * inverse;
    crossEdge<kSide>(*spoke, target, end,
                     Vec2(corner.dot * inverse * inverse, corner.doubleArea * inverse * inverse));
  }
}

/// The path to the end of the spoke `target` over the spoke beside it; the target lies on its left
/// (kSide = 1) or on its right (kSide = -1).
template <int kSide>
void FastDistance::crossEdge(const Spoke& spoke, const Spoke& target, const EdgeEnd& a,
                             const Vec2& apex) {
  const Jet& other = *spoke.jet;
  const double inverse = 1 / spoke.length;
  EdgeEnd b;
  b.distance = other.distance * inverse;
  b.base = other.base * inverse;
  ApexArrival best;
  if (other.settled) {
    b.seen = look<-kSide>(spoke, inverse, b);
    best = crossSettledEdge(a, b, apex);
  } else {
    if (!other.alongEdge && edge_crossing::hides(a, b)) return;
    best = edge_crossing::straight(a, apex);
    const double wait = best.distance - a.base - kWait;
    if (wait > 0 && a.squaredRadiusAtOtherEnd() < wait * wait) return;
  }
  const double distance = best.distance * spoke.length;
  const int reverse = target.reverse;
  const int arrivalCorner = kSide > 0 ? reverse : fans_->before(target.head, reverse);
  if (!mayArrive(*target.jet, distance, arrivalCorner)) return;

  // At the apex the edge to this vertex has the direction of -apex here, and of `reverse` there.
  Jet jet;
  jet.distance = distance;
  jet.base = best.base * spoke.length;
  const Vec2 relative = rotateBack(Vec2(-apex.x(), -kSide * apex.y()),
                                   Vec2(best.toSource.x(), kSide * best.toSource.y()));
  jet.toSource = rotate(fans_->edges[reverse].vector, relative) *
                 (spoke.length / (target.length * target.length));
  if (kSide < 0 && reverse == fans_->begin[target.head]) {
    jet.toSource = rotate(fans_->turn[target.head], jet.toSource);
  }
  jet.corner = arrivalCorner;
  arrive(*target.jet, target.head, jet);
}

/// Looks back from the end of a spoke along it: the angle to the end's source, on the right
/// (kSide = -1) or on the left (kSide = 1). Returns false if it is more than pi.
template <int kSide>
bool FastDistance::look(const Spoke& spoke, double inverseLength, EdgeEnd& end) const {
  const Jet& jet = *spoke.jet;
  if (jet.distance == 0) return true;
  const int vertex = spoke.head;
  const int edge = spoke.reverse;
  // In the corner beside the edge on the wrong side.
  if (jet.corner == (kSide > 0 ? edge : fans_->before(vertex, edge))) return false;
  const uint8_t flags = fans_->flags[vertex];
  double x = jet.toSource.x();
  double y = jet.toSource.y();
  if (kSide > 0 ? jet.corner >= edge : jet.corner < edge) {
    if ((flags & VertexFans::kBoundary) != 0) return false;
    const Vec2& turn = fans_->turn[vertex];
    const Vec2 turned = kSide > 0 ? rotateBack(turn, jet.toSource) : rotate(turn, jet.toSource);
    x = turned.x();
    y = turned.y();
  }
  const Vec2& vector = fans_->edges[edge].vector;
  end.sine = kSide * (x * vector.y() - y * vector.x()) * inverseLength;
  if (end.sine < 0) return false;
  end.cosine = (x * vector.x() + y * vector.y()) * inverseLength;
  return (flags & VertexFans::kWide) == 0 || !looksTooFar(vertex, edge, kSide);
}

/// Whether the angle from an edge to the vertex's source, on the right (side = 1) or on the left
/// (side = -1), is more than 3/2 pi, though its sine is that of a smaller one.
bool FastDistance::looksTooFar(int vertex, int edge, int side) const {
  double angle = side * (cumulatedAngle(*fans_, geometry_, vertex, edge) - direction(vertex));
  if (angle < 0) angle += geometry_.totalAngle[vertex];
  return angle > 1.5 * kPi;
}

bool FastDistance::mayArrive(const Jet& jet, double distance, int corner) const {
  if (!(distance < kInfinity) || distance <= barrier_) return false;
  if (distance < jet.distance * kShorter) return true;
  // What came over the same edge when less was known of its ends is replaced.
  return !jet.settled && !jet.alongEdge && jet.corner == corner && distance != jet.distance;
}

void FastDistance::arrive(Jet& jet, int vertex, const Jet& arrival) {
  if (jet.distance == kInfinity) touched_.push_back(vertex);
  jet = arrival;
  queue_.push(arrival.distance, vertex);
}

double FastDistance::direction(int vertex) const {
  const Jet& jet = *jets_.find(vertex);
  const FanEdge& edge = fans_->edges[jet.corner];
  const double inCorner =
      std::atan2(cross(edge.vector, jet.toSource), edge.vector.dot(jet.toSource));
  return cumulatedAngle(*fans_, geometry_, vertex, jet.corner) + inCorner;
}

Vec2 FastDistance::logVector(int vertex) const {
  const Jet& jet = *jets_.find(vertex);
  return -2 * jet.distance * unitVector(geometry_.angleScale[vertex] * direction(vertex));
}

}  // namespace karcher

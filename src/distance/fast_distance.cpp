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
constexpr double kFarBeside = 0.1;

/// unitVector(angle), by the power series where a few terms are all that doubles can tell.
Vec2 unitVectorOfSmall(double angle) {
  if (std::abs(angle) > 0.25) return unitVector(angle);
  const double x = angle * angle;
  const double c = 1 - x * (1. / 30) * (1 - x * (1. / 56) * (1 - x * (1. / 90)));
  const double s = 1 - x * (1. / 42) * (1 - x * (1. / 72) * (1 - x * (1. / 110)));
  return {1 - x / 2 * (1 - x * (1. / 12) * c),
          angle * (1 - x * (1. / 6) * (1 - x * (1. / 20) * s))};
}

}  // namespace

FastDistance::FastDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans)
    : geometry_(geometry),
      fans_(fans ? std::move(fans) : std::make_shared<const VertexFans>(buildVertexFans(geometry))),
      jets_(geometry.mesh->vertexCount()),
      queue_(geometry.meanEdge / 32) {}

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
    jets_.touch(place.vertex) = start;
    enqueue(place.vertex, kInfinity);
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
    if (start.distance < jet.distance) {
      const double before = jet.distance;
      jet = start;
      enqueue(v, before);
    }
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

void FastDistance::settle(int vertex) {
  Jet& own = jets_.touch(vertex);
  own.settled = true;
  front_ = std::max(front_, own.distance);
  const int begin = fans_->begin[vertex];
  const int count = fans_->end(vertex) - begin;
  const FanEdge* const edges = fans_->edges.data() + begin;
  if (ends_.count() < count) {
    ends_.resize(static_cast<size_t>(count));
    crossings_.resize(static_cast<size_t>(2 * count) + 1);
  }
  constexpr double kOpen[2] = {0, kInfinity};
  for (int i = 0; i < count; ++i) {
    Jet& end = jets_.touch(edges[i].head);
    longest_ = std::max(longest_, edges[i].length);
    const double before = end.distance;
    goAlongEdge(own, edges[i], end);
    ends_[i] = {&end, before, end.distance, end.distance + kOpen[end.settled ? 1 : 0]};
  }
  const int crossings = own.distance == 0 ? 0 : listCrossings(own, begin, count);
  for (int i = 0; i < crossings; ++i) {
    const int left = crossings_[i] >> 1;
    const int right = left + 1 == count ? 0 : left + 1;
    if ((crossings_[i] & 1) == 0) {
      cross<1>(vertex, own, begin + left, begin + right);
    } else {
      cross<-1>(vertex, own, begin + right, begin + left);
    }
  }
  for (int i = 0; i < count; ++i) {
    if (ends_[i].jet->distance != ends_[i].before) enqueue(edges[i].head, ends_[i].before);
  }
}

/// Lists the edges that a path may cross, and returns how many they are. No path over an edge is
/// shorter than (d_v + d_w - length) / 2 and the height above the edge; if that is no less than the
/// distance of an end that is not settled, the end comes first. Without branches, which would be
/// guessed wrong half the time.
int FastDistance::listCrossings(const Jet& own, int begin, int count) {
  const FanEdge* const edges = fans_->edges.data() + begin;
  const auto mayCross = [&](const FanEdge& edge, const End& end, const End& apex, double area) {
    const double limit = std::min(apex.distance, end.open);
    return area < edge.length * (limit - 0.5 * (own.distance + end.distance - edge.length));
  };
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const int j = i + 1 == count ? 0 : i + 1;
    const double area = edges[i].doubleArea;
    // The boundary's last edge has no corner, and no area.
    const bool ahead = begin + i != own.corner && area > 0;
    crossings_[found] = 2 * i;
    found +=
        static_cast<int>(mayCross(edges[i], ends_[i], ends_[j], area)) & static_cast<int>(ahead);
    crossings_[found] = 2 * i + 1;
    found +=
        static_cast<int>(mayCross(edges[j], ends_[j], ends_[i], area)) & static_cast<int>(ahead);
  }
  return found;
}

void FastDistance::goAlongEdge(const Jet& own, const FanEdge& edge, Jet& end) {
  const double distance = own.distance + edge.length;
  if (!(distance < end.distance * kShorter) || distance <= barrier_) return;
  Jet jet;
  jet.distance = distance;
  jet.base = own.distance;
  jet.toSource = fans_->edges[edge.reverse].vector / edge.length;
  jet.corner = edge.reverse;
  jet.alongEdge = true;
  end = jet;
}

/// Goes over an edge if that can be the way to the end of the next edge on the left (kSide = 1) or
/// on the right (kSide = -1).
template <int kSide>
void FastDistance::cross(int vertex, const Jet& own, int edgeNumber, int targetNumber) {
  const FanEdge& edge = fans_->edges[edgeNumber];
  const FanEdge& target = fans_->edges[targetNumber];
  const Jet& other = *ends_[edgeNumber - fans_->begin[vertex]].jet;
  // The direction to the source, turned so that the angle from it to the edge is on this side.
  Vec2 toSource = own.toSource;
  if (kSide > 0 ? edgeNumber <= own.corner : edgeNumber > own.corner) {
    if (fans_->onBoundary(vertex)) return;
    const Vec2& turn = fans_->turn[vertex];
    toSource = kSide > 0 ? rotateBack(turn, toSource) : rotate(turn, toSource);
  }
  Vec2 toTarget = target.vector;
  if (kSide > 0 ? targetNumber < edgeNumber : targetNumber > edgeNumber) {
    const Vec2& turn = fans_->turn[vertex];
    toTarget = kSide > 0 ? rotate(turn, toTarget) : rotateBack(turn, toTarget);
  }
  const double radius = own.distance - own.base;
  const double length = edge.length;
  const double squared = length * length;
  const double sine = kSide * karcher::cross(toSource, edge.vector);
  const double cosine = toSource.dot(edge.vector);
  const double area = (kSide > 0 ? edge : target).doubleArea;
  const double dot = edge.vector.dot(toTarget);

  const double drop = area + radius * sine;
  const double place = radius * (cosine * area + dot * sine);
  const bool faces = sine >= 0;
  const bool beside =
      place < -kFarBeside * squared * drop || place > (1 + kFarBeside) * squared * drop;
  if (faces ? beside : !other.settled) return;
  if (!other.settled) {
    // The bound of listCrossings for straight paths from this vertex's source, without a root.
    const double away = radius - cosine;
    const double gain = (cosine - kWait * length) * squared - dot * cosine + area * sine;
    if (away > 0 && 2 * away * gain > (squared - cosine * cosine) * squared) return;
  }
  if ((fans_->flags[vertex] & VertexFans::kWide) != 0 && looksTooFar(vertex, edgeNumber, kSide)) {
    return;
  }
  const double inverse = 1 / length;
  EdgeEnd end;
  end.cosine = cosine * inverse;
  end.sine = sine * inverse;
  end.seen = faces;
  end.distance = own.distance * inverse;
  end.base = own.base * inverse;
  const double inverseSquare = inverse * inverse;
  crossEdge<kSide>(edge, target, end, Vec2(dot * inverseSquare, area * inverseSquare), inverse);
}

/// The path to the end of the edge `target`, which lies at `apex` in the crossed edge's frame.
template <int kSide>
void FastDistance::crossEdge(const FanEdge& edge, const FanEdge& target, const EdgeEnd& a,
                             const Vec2& apex, double inverse) {
  const Jet& other = *jets_.find(edge.head);
  Jet& reached = jets_.touch(target.head);
  EdgeEnd b;
  b.distance = other.distance * inverse;
  b.base = other.base * inverse;
  ApexArrival best;
  if (other.settled) {
    b.seen = look<-kSide>(edge, other, inverse, b);
    best = crossSettledEdge(a, b, apex);
  } else {
    if (!other.alongEdge && edge_crossing::hides(a, b)) return;
    best = edge_crossing::straight(a, apex);
    const double wait = best.distance - a.base - kWait;
    if (wait > 0 && a.squaredRadiusAtOtherEnd() < wait * wait) return;
  }
  const double distance = best.distance * edge.length;
  const int reverse = target.reverse;
  const int arrivalCorner = kSide > 0 ? reverse : fans_->before(target.head, reverse);
  if (!mayArrive(reached, distance, arrivalCorner)) return;

  // At the apex the edge to this vertex has the direction of -apex here, and of `reverse` there.
  Jet jet;
  jet.distance = distance;
  jet.base = best.base * edge.length;
  const Vec2 relative = rotateBack(Vec2(-apex.x(), -kSide * apex.y()),
                                   Vec2(best.toSource.x(), kSide * best.toSource.y()));
  jet.toSource = rotate(fans_->edges[reverse].vector, relative) *
                 (edge.length / (target.length * target.length));
  if (kSide < 0 && reverse == fans_->begin[target.head]) {
    jet.toSource = rotate(fans_->turn[target.head], jet.toSource);
  }
  jet.corner = arrivalCorner;
  reached = jet;
}

/// Looks back from the end of an edge along it: the angle to the end's source, on the right
/// (kSide = -1) or on the left (kSide = 1). Returns false if it is more than pi.
template <int kSide>
bool FastDistance::look(const FanEdge& along, const Jet& jet, double inverseLength,
                        EdgeEnd& end) const {
  if (jet.distance == 0) return true;
  const int vertex = along.head;
  const int edge = along.reverse;
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
  double angle = side * (fans_->angles[edge] - direction(vertex));
  if (angle < 0) angle += geometry_.totalAngle[vertex];
  return angle > 1.5 * kPi;
}

bool FastDistance::mayArrive(const Jet& jet, double distance, int corner) const {
  if (!(distance < kInfinity) || distance <= barrier_) return false;
  if (distance < jet.distance * kShorter) return true;
  // What came over the same edge when less was known of its ends is replaced.
  return !jet.settled && !jet.alongEdge && jet.corner == corner && distance != jet.distance;
}

void FastDistance::enqueue(int vertex, double before) {
  if (before == kInfinity) touched_.push_back(vertex);
  queue_.push(jets_.find(vertex)->distance, vertex);
}

double FastDistance::direction(int vertex) const {
  const Jet& jet = *jets_.find(vertex);
  const Vec2& edge = fans_->edges[jet.corner].vector;
  const double inCorner = std::atan2(karcher::cross(edge, jet.toSource), edge.dot(jet.toSource));
  return fans_->angles[jet.corner] + inCorner;
}

Vec2 FastDistance::logVector(int vertex) const {
  const Jet& jet = *jets_.find(vertex);
  // The frame's angles are the fan's, scaled: a small turn where the surface bends little.
  const double turn = (geometry_.angleScale[vertex] - 1) * direction(vertex);
  return -2 * jet.distance * rotate(unitVectorOfSmall(turn), jet.toSource);
}

}  // namespace karcher

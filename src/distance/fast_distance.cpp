#include "distance/fast_distance.h"

namespace karcher {
namespace {

/// A distance counts as shorter only if it is by this part: otherwise rounding alone would settle
/// vertices again and again.
constexpr double kShorter = 1 - 1e-15;

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
      queue_(geometry.meanEdge / 128) {}

void FastDistance::setSource(const SurfacePoint& source) {
  source_ = source;
  jets_.clear();
  touched_.clear();
  queue_.clear();
  front_ = 0;
  longest_ = 0;
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
      start.place = jet.place;
      start.lateness = jet.lateness;
      jet = start;
      enqueue(v, before);
    }
  }
}

void FastDistance::grow(double radius) {
  while (reached() < radius) settle(queue_.pop());
}

bool FastDistance::growTo(int vertex) {
  const Jet& jet = jets_.touch(vertex);
  while (!isFinal(jet)) {
    if (queue_.empty()) return jet.settled;
    settle(queue_.pop());
  }
  return true;
}

void FastDistance::settle(int vertex) {
  Jet& own = jets_.touch(vertex);
  own.settled = true;
  own.place = kNotWaiting;
  front_ = std::max(front_, own.distance);
  const int begin = fans_->begin[vertex];
  const int count = fans_->end(vertex) - begin;
  const FanEdge* const edges = fans_->edges.data() + begin;
  if (own.alongEdge) own.toSource = fans_->edges[own.corner].vector / fans_->edges[own.corner].length;
  // Without branches, which would be guessed wrong half the time.
  constexpr double kOpen[2] = {0, kInfinity};
  // The other way round a vertex of the boundary nothing is seen.
  const Vec2 turns[2] = {Vec2(1, 0), fans_->onBoundary(vertex)
                                         ? Vec2::Constant(std::numeric_limits<double>::quiet_NaN())
                                         : fans_->turn[vertex]};
  Ring& ring = ring_;
  double longest = longest_;
  for (int i = 0; i < count; ++i) {
    const FanEdge& edge = edges[i];
    Jet& jet = jets_.touch(edge.head);
    longest = std::max(longest, edge.length);
    ring.before[i] = jet.distance;
    const double around = own.distance + edge.length;
    const bool isNearer = (around < jet.distance * kShorter) & !isFinal(jet);
    Jet& reached = *(isNearer ? &jet : &nowhere_);
    reached.distance = around;
    reached.base = own.distance;
    reached.corner = edge.reverse;
    reached.settled = false;
    reached.alongEdge = true;
    ring.jet[i] = &jet;
    ring.distance[i] = jet.distance;
    const int state = jet.settled ? 1 : 0;
    ring.open[i] = jet.distance + kOpen[state];
    ring.back[i] = 2 * state - 1;
    ring.least[i] = 0.5 * (own.distance + jet.distance - edge.length);
    ring.length[i] = edge.length;
    ring.area[i] = edge.cross;
    const double sine = karcher::cross(own.toSource, edge.vector);
    const double cosine = own.toSource.dot(edge.vector);
    const bool isBehind = begin + i <= own.corner;
    const Vec2& left = turns[isBehind ? 1 : 0];
    const Vec2& right = turns[isBehind ? 0 : 1];
    ring.left[i] = sine * left.x() + cosine * left.y();
    ring.right[i] = cosine * right.y() - sine * right.x();
    ring.along[i] = cosine;
  }
  longest_ = longest;
  if (own.distance > 0) {
    listCrossings(own, begin, count);
    for (int k = 0; k < leftwardCount_; ++k) {
      const int i = ring.leftward[k];
      cross<1>(vertex, own, begin, i, i + 1 == count ? 0 : i + 1);
    }
    for (int k = 0; k < rightwardCount_; ++k) {
      const int i = ring.rightward[k];
      cross<-1>(vertex, own, begin, i, i == 0 ? count - 1 : i - 1);
    }
  }
  int changed = 0;
  for (int i = 0; i < count; ++i) {
    ring.leftward[changed] = i;
    changed += static_cast<int>(ring.jet[i]->distance != ring.before[i]);
  }
  for (int k = 0; k < changed; ++k) {
    enqueue(edges[ring.leftward[k]].head, ring.before[ring.leftward[k]]);
  }
}

/// Lists the edges that a path may cross. No path over an edge is shorter than
/// (d_v + d_w - length) / 2 and the height above the edge; if that is no less than the distance of
/// an end that is not settled, the end comes first. The line from the vertex's own source must not
/// miss the edge by much, unless the edge's end may look through it. Without branches, too.
void FastDistance::listCrossings(const Jet& own, int begin, int count) {
  Ring& ring = ring_;
  const auto copy = [count](double* values) { values[count] = values[0]; };
  copy(ring.distance);
  copy(ring.open);
  copy(ring.back);
  copy(ring.least);
  copy(ring.length);
  copy(ring.left);
  copy(ring.right);
  const double radius = own.distance - own.base;
  const int corners = ring.area[count - 1] > 0 ? count : count - 1;
  const int ownCorner = own.corner - begin;
  const auto score = [&](int edge, int apex, double area, const double* sines) {
    const double sine = sines[edge];
    const double drop = area + radius * sine;
    const double place = radius * sines[apex];
    const double inside =
        std::min(place + kFarBeside * drop, (1 + kFarBeside) * drop - place);
    const double seen = std::max(std::min(sine, inside), std::min(-sine, ring.back[edge]));
    const double gain =
        ring.length[edge] * (std::min(ring.distance[apex], ring.open[edge]) - ring.least[edge]) -
        area;
    return gain > 0 ? seen : -1.0;
  };
  const int even = (corners + 1) & ~1;
  for (int i = 0; i < even; ++i) ring.leftScore[i] = score(i, i + 1, ring.area[i], ring.left);
  for (int i = 0; i < even; ++i) ring.rightScore[i] = score(i + 1, i, ring.area[i], ring.right);
  int left = 0;
  int right = 0;
  for (int i = 0; i < corners; ++i) {
    const int isOther = i != ownCorner ? 1 : 0;
    ring.leftward[left] = i;
    left += static_cast<int>(ring.leftScore[i] >= 0) & isOther;
    ring.rightward[right] = i + 1 == count ? 0 : i + 1;
    right += static_cast<int>(ring.rightScore[i] >= 0) & isOther;
  }
  leftwardCount_ = left;
  rightwardCount_ = right;
}

/// Goes over an edge if that can be the way to the end of the next edge on the left (kSide = 1) or
/// on the right (kSide = -1).
template <int kSide>
void FastDistance::cross(int vertex, const Jet& own, int begin, int edgeNumber, int targetNumber) {
  const FanEdge& edge = fans_->edges[begin + edgeNumber];
  const FanEdge& target = fans_->edges[begin + targetNumber];
  const Jet& other = *ring_.jet[edgeNumber];
  const double radius = own.distance - own.base;
  const double length = edge.length;
  const double squared = length * length;
  const double sine = (kSide > 0 ? ring_.left : ring_.right)[edgeNumber];
  const double area = (kSide > 0 ? edge : target).cross;
  const double dot = (kSide > 0 ? edge : target).dot;
  double cosine = ring_.along[edgeNumber];
  if (kSide > 0 ? begin + edgeNumber <= own.corner : begin + edgeNumber > own.corner) {
    // Turned as the edge is.
    const Vec2& turn = fans_->turn[vertex];
    const double plain = karcher::cross(own.toSource, edge.vector);
    cosine = cosine * turn.x() - kSide * plain * turn.y();
  }
  const bool faces = sine >= 0;
  if (!other.settled) {
    // The bound of listCrossings for straight paths from this vertex's source, without a root.
    const double away = radius - cosine;
    const double gain = (cosine - kWait * length) * squared - dot * cosine + area * sine;
    if (away > 0 && 2 * away * gain > (squared - cosine * cosine) * squared) return;
  }
  if ((fans_->flags[vertex] & VertexFans::kWide) != 0 && looksTooFar(vertex, begin + edgeNumber, kSide)) {
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
  jet.place = reached.place;
  jet.lateness = reached.lateness;
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
  if (!(distance < kInfinity) || isFinal(jet)) return false;
  if (distance < jet.distance * kShorter) return true;
  // What came over the same edge when less was known of its ends is replaced.
  return !jet.settled && !jet.alongEdge && jet.corner == corner && distance != jet.distance;
}

void FastDistance::enqueue(int vertex, double before) {
  Jet& jet = jets_.touch(vertex);
  if (before == kInfinity) {
    touched_.push_back(vertex);
    jet.lateness = fans_->lateness[vertex];
  }
  if (jet.place == kNotWaiting) {
    jet.place = queue_.push(jet.distance, vertex);
  } else {
    queue_.lower(jet.place, jet.distance);
  }
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

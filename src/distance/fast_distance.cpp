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
  jets_.clear();
  queue_.clear();
  front_ = 0;
  latest_ = 0;
  const TriangleMesh& mesh = *geometry_.mesh;
  const PointLocation place = locate(mesh, source);
  if (place.simplex == Simplex::kVertex) {
    Jet start;
    start.distance = 0;
    start.corner = fans_->begin[place.vertex];
    jets_.touch(place.vertex) = start;
    enqueue(place.vertex, jets_.touch(place.vertex), kInfinity);
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
      enqueue(v, jet, before);
    }
  }
}

void FastDistance::grow(double radius) {
  while (reached() < radius) settle(queue_.pop());
}

double FastDistance::growTo(int vertex) {
  const Jet& jet = jets_.touch(vertex);
  while (!isFinal(jet) && !queue_.empty()) settle(queue_.pop());
  return jet.distance;
}

void FastDistance::settle(int vertex) {
  Jet& own = jets_.touch(vertex);
  own.settled = true;
  own.place = kNotWaiting;
  front_ = std::max(front_, own.distance);
  if (own.alongEdge) {
    const FanEdge& along = fans_->edges[own.corner];
    own.toSource = along.vector / along.length;
  }
  const int edges = fans_->end(vertex) - fans_->begin[vertex];
  for (int first = 0; first < edges; first += Ring::kCorners) {
    goRound(vertex, own, first, std::min(edges - first, Ring::kCorners));
  }
}

/// Goes along so many of the vertex's edges from the first on, and over them and the one after
/// them. What is guessed wrong half the time is done without branches.
void FastDistance::goRound(int vertex, const Jet& own, int first, int count) {
  const int begin = fans_->begin[vertex];
  const int end = fans_->end(vertex);
  const bool onBoundary = fans_->onBoundary(vertex);
  // The other way round a vertex of the boundary nothing is seen.
  const Vec2 turns[2] = {Vec2(1, 0), onBoundary
                                         ? Vec2::Constant(std::numeric_limits<double>::quiet_NaN())
                                         : fans_->turn[vertex]};
  const FanEdge* const edges = fans_->edges.data();
  const auto go = [&](int number, int place) {
    goAlongEdge(own, turns, edges[number], number, place);
  };
  for (int i = 0; i < count; ++i) go(begin + first + i, i);
  int met = count;
  int corners = count;
  if (begin + first + count < end) {
    go(begin + first + count, met++);
  } else if (onBoundary) {
    --corners;
  } else if (first > 0) {
    go(begin, met++);
  } else {
    closeRing(count);
  }

  if (own.distance > 0) {
    findCrossings(own.distance - own.base, corners);
    const int ownCorner = own.corner - begin - first;
    if (ownCorner >= 0 && ownCorner < corners) {
      ring_.crossesLeft[ownCorner] = false;
      ring_.crossesRight[ownCorner] = false;
    }
    int left = 0;
    int right = 0;
    for (int i = 0; i < corners; ++i) {
      ring_.leftward[left] = i;
      ring_.rightward[right] = i;
      left += static_cast<int>(ring_.crossesLeft[i]);
      right += static_cast<int>(ring_.crossesRight[i]);
    }
    for (int k = 0; k < left; ++k) {
      cross<1>(vertex, own, ring_.leftward[k], ring_.leftward[k] + 1);
    }
    for (int k = 0; k < right; ++k) {
      cross<-1>(vertex, own, ring_.rightward[k] + 1, ring_.rightward[k]);
    }
  }
  int changed = 0;
  for (int i = 0; i < met; ++i) {
    ring_.leftward[changed] = i;
    changed += static_cast<int>(ring_.jet[i]->distance != ring_.before[i]);
  }
  for (int k = 0; k < changed; ++k) {
    const int i = ring_.leftward[k];
    enqueue(edges[ring_.number[i]].head, *ring_.jet[i], ring_.before[i]);
  }
}

/// Goes along an edge, and takes it into the ring.
inline void FastDistance::goAlongEdge(const Jet& own, const Vec2 (&turns)[2], const FanEdge& edge,
                                      int number, int place) {
  Jet& jet = jets_.touch(edge.head);
  ring_.before[place] = jet.distance;
  const double distance = own.distance + edge.length;
  const bool isNearer = (distance < jet.distance * kShorter) & !isFinal(jet);
  Jet& reached = *(isNearer ? &jet : &nowhere_);
  reached.distance = distance;
  reached.base = own.distance;
  reached.corner = edge.reverse;
  reached.settled = false;
  reached.alongEdge = true;

  constexpr double kRoom[2] = {0, kInfinity};
  ring_.jet[place] = &jet;
  ring_.number[place] = number;
  ring_.distance[place] = jet.distance;
  const double least = 0.5 * (own.distance + jet.distance - edge.length);
  ring_.least[place] = edge.length * least;
  ring_.room[place] = edge.length * (jet.distance - least) + kRoom[jet.settled ? 1 : 0];
  ring_.length[place] = edge.length;
  ring_.area[place] = edge.cross;
  const double sine = karcher::cross(own.toSource, edge.vector);
  const double cosine = own.toSource.dot(edge.vector);
  const int isBehind = number <= own.corner ? 1 : 0;
  const Vec2& left = turns[isBehind];
  const Vec2& right = turns[1 - isBehind];
  ring_.dot[place] = cosine;
  ring_.left[place] = sine * left.x() + cosine * left.y();
  ring_.right[place] = cosine * right.y() - sine * right.x();
}

/// Repeats the first edge after the last.
void FastDistance::closeRing(int place) {
  ring_.jet[place] = ring_.jet[0];
  ring_.number[place] = ring_.number[0];
  ring_.distance[place] = ring_.distance[0];
  ring_.room[place] = ring_.room[0];
  ring_.least[place] = ring_.least[0];
  ring_.length[place] = ring_.length[0];
  ring_.dot[place] = ring_.dot[0];
  ring_.left[place] = ring_.left[0];
  ring_.right[place] = ring_.right[0];
}

/// Tells which edges a path may cross. No path over an edge is shorter than
/// (d_v + d_w - length) / 2 and the height above the edge; if that is no less than the distance of
/// an end that is not settled, the end comes first. The line from the vertex's own source must not
/// miss the edge by much, unless the edge's other end looks through it from a source of its own.
void FastDistance::findCrossings(double radius, int corners) {
  Ring& ring = ring_;
  const auto mayCross = [&](int edge, int apex, double area, const double* sines) {
    const double sine = sines[edge];
    const double drop = area + radius * sine;
    const double place = radius * sines[apex];
    const bool isBefore = place < -kFarBeside * drop;
    const bool isBehind = place > (1 + kFarBeside) * drop;
    const bool crosses = (sine >= 0) & !isBefore & !isBehind;
    const bool isSeen = (sine < 0) & (ring.room[edge] == kInfinity);
    const bool isInTurn = area < ring.room[edge];
    const bool isNearer = area + ring.least[edge] < ring.length[edge] * ring.distance[apex];
    return isNearer & isInTurn & (crosses | isSeen);
  };
  for (int i = 0; i < corners; ++i) {
    ring.crossesLeft[i] = mayCross(i, i + 1, ring.area[i], ring.left);
    ring.crossesRight[i] = mayCross(i + 1, i, ring.area[i], ring.right);
  }
}

/// Goes over an edge of the ring if that can be the way to the end of the next one on the left
/// (kSide = 1) or on the right (kSide = -1).
template <int kSide>
void FastDistance::cross(int vertex, const Jet& own, int edgeInRing, int targetInRing) {
  const int edgeNumber = ring_.number[edgeInRing];
  const FanEdge& edge = fans_->edges[edgeNumber];
  const FanEdge& target = fans_->edges[ring_.number[targetInRing]];
  const Jet& other = *ring_.jet[edgeInRing];
  const double radius = own.distance - own.base;
  const double length = edge.length;
  const double squared = length * length;
  const double sine = (kSide > 0 ? ring_.left : ring_.right)[edgeInRing];
  const double area = (kSide > 0 ? edge : target).cross;
  const double dot = (kSide > 0 ? edge : target).dot;
  double cosine = ring_.dot[edgeInRing];
  if (kSide > 0 ? edgeNumber <= own.corner : edgeNumber > own.corner) {
    const Vec2& turn = fans_->turn[vertex];
    cosine = cosine * turn.x() - kSide * karcher::cross(own.toSource, edge.vector) * turn.y();
  }
  const bool faces = sine >= 0;
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
  crossEdge<kSide>(edge, target, other, *ring_.jet[targetInRing], end,
                   Vec2(dot * inverseSquare, area * inverseSquare), inverse);
}

/// The path to the end of the edge `target`, which lies at `apex` in the crossed edge's frame.
template <int kSide>
void FastDistance::crossEdge(const FanEdge& edge, const FanEdge& target, const Jet& other,
                             Jet& reached, const EdgeEnd& a, const Vec2& apex, double inverse) {
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

void FastDistance::enqueue(int vertex, Jet& jet, double before) {
  if (before == kInfinity) {
    jet.lateness = fans_->lateness[vertex];
    latest_ = std::max(latest_, jet.lateness);
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

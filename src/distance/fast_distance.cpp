#include "distance/fast_distance.h"

#include "distance/arrival.h"

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

/// Distances count as shorter than the straight line only by more than this part of their square.
constexpr double kRounding = 1e-13;

/// Two paths of one length are one if their directions differ by less, in radians.
constexpr double kSameDirection = 1e-4;

/// A path that bends by less, in radians, goes straight on.
constexpr double kStraight = 1e-12;

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

FastDistance::FastDistance(const Geometry& geometry, std::shared_ptr<const VertexFans> fans,
                           std::shared_ptr<PagePool> pages)
    : geometry_(geometry),
      fans_(fans ? std::move(fans) : std::make_shared<const VertexFans>(buildVertexFans(geometry))),
      vertices_(geometry.mesh->vertexCount(), std::move(pages)),
      queue_(geometry.meanEdge / 128) {}

void FastDistance::setSource(const SurfacePoint& source) {
  vertices_.clear();
  queue_.clear();
  front_ = 0;
  longestDelay_ = 0;
  const TriangleMesh& mesh = *geometry_.mesh;
  source_ = position(mesh, source);
  const PointLocation place = locate(mesh, source);
  if (place.simplex == Simplex::kVertex) {
    VertexRecord start;
    start.distance = 0;
    start.corner = fans_->begin[place.vertex];
    vertices_.touch(place.vertex) = start;
    enqueue(place.vertex, vertices_.touch(place.vertex), kInfinity);
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
    VertexRecord start;
    start.distance = toSource.norm();
    start.corner = fanEdge(*fans_, v, geometry_.mesh->head(h));
    const Vec2 inFan = rotate(fans_->edges[start.corner].vector, rotateBack(edge, toSource));
    start.toSource = inFan.normalized();
    VertexRecord& record = vertices_.touch(v);
    if (start.distance < record.distance) {
      const double before = record.distance;
      start.place = record.place;
      start.times = record.times;
      start.delay = record.delay;
      record = start;
      enqueue(v, record, before);
    }
  }
}

void FastDistance::grow(double radius) {
  while (reached() < radius) settle(queue_.pop());
}

double FastDistance::growTo(int vertex) {
  const VertexRecord& record = vertices_.touch(vertex);
  while (!isFinal(record) && !queue_.empty()) settle(queue_.pop());
  return record.distance;
}

void FastDistance::settle(int vertex) {
  VertexRecord& from = vertices_.touch(vertex);
  from.settled = true;
  from.place = kNotWaiting;
  front_ = std::max(front_, from.distance);
  if (from.alongEdge) {
    const FanEdge& along = fans_->edges[from.corner];
    from.toSource = along.vector / along.length;
    const VertexRecord& before = vertices_.touch(along.head);
    if (before.distance == from.base && goesStraightOn(along.head, before, along.reverse)) {
      from.base = before.base;
    }
  }
  const int edges = fans_->end(vertex) - fans_->begin[vertex];
  for (int first = 0; first < edges; first += Ring::kCorners) {
    goRound(vertex, from, first, std::min(edges - first, Ring::kCorners));
  }
}

/// Whether the path to a vertex, gone on along an edge, is straight on both sides: it does not turn
/// round the vertex.
bool FastDistance::goesStraightOn(int vertex, const VertexRecord& record, int number) const {
  const FanEdge& edge = fans_->edges[number];
  const double slack = kStraight * edge.length;
  const double sine = karcher::cross(record.toSource, edge.vector);
  const double cosine = record.toSource.dot(edge.vector);
  if (!(cosine < 0) || std::abs(sine) > slack) return false;
  if (fans_->onBoundary(vertex)) return true;
  // The other way round.
  const Vec2& turn = fans_->turn[vertex];
  const double side = number <= record.corner ? 1 : -1;
  return std::abs(sine * turn.x() + side * cosine * turn.y()) <= slack;
}

/// Goes along so many of the vertex's edges from the first on, and over them and the one after
/// them. What is guessed wrong half the time is done without branches.
void FastDistance::goRound(int vertex, const VertexRecord& from, int first, int count) {
  const int begin = fans_->begin[vertex];
  const int end = fans_->end(vertex);
  const bool onBoundary = fans_->onBoundary(vertex);
  // The other way round a vertex of the boundary nothing is seen.
  const Vec2 turns[2] = {Vec2(1, 0), onBoundary
                                         ? Vec2::Constant(std::numeric_limits<double>::quiet_NaN())
                                         : fans_->turn[vertex]};
  const FanEdge* const edges = fans_->edges.data();
  const auto go = [&](int number, int place) {
    goAlongEdge(from, turns, edges[number], number, place);
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

  if (from.distance > 0) {
    findCrossings(from.distance, from.distance - from.base, corners);
    const int arrivalCorner = from.corner - begin - first;
    if (arrivalCorner >= 0 && arrivalCorner < corners) {
      ring_.crossesLeft[arrivalCorner] = false;
      ring_.crossesRight[arrivalCorner] = false;
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
      cross<1>(vertex, from, ring_.leftward[k], ring_.leftward[k] + 1);
    }
    for (int k = 0; k < right; ++k) {
      cross<-1>(vertex, from, ring_.rightward[k] + 1, ring_.rightward[k]);
    }
  }
  int changed = 0;
  for (int i = 0; i < met; ++i) {
    ring_.leftward[changed] = i;
    changed += static_cast<int>(ring_.record[i]->distance != ring_.before[i]);
  }
  for (int k = 0; k < changed; ++k) {
    const int i = ring_.leftward[k];
    enqueue(edges[ring_.number[i]].head, *ring_.record[i], ring_.before[i]);
  }
  if (hasTied_) enqueueTied(met);
}

/// Of the ring's vertices those whose path was replaced by another one of the very same length.
void FastDistance::enqueueTied(int met) {
  hasTied_ = false;
  for (int i = 0; i < met; ++i) {
    VertexRecord& record = *ring_.record[i];
    const bool waits = record.settled || record.place != kNotWaiting;
    if (waits || record.distance != ring_.before[i] || record.distance == kInfinity) continue;
    enqueue(fans_->edges[ring_.number[i]].head, record, ring_.before[i]);
  }
}

/// Goes along an edge, and takes it into the ring.
inline void FastDistance::goAlongEdge(const VertexRecord& from, const Vec2 (&turns)[2],
                                      const FanEdge& edge, int number, int place) {
  VertexRecord& record = vertices_.touch(edge.head);
  ring_.before[place] = record.distance;
  const double sine = karcher::cross(from.toSource, edge.vector);
  const double cosine = from.toSource.dot(edge.vector);
  const int isBehind = number <= from.corner ? 1 : 0;
  const Vec2& left = turns[isBehind];
  const Vec2& right = turns[1 - isBehind];
  ring_.dot[place] = cosine;
  ring_.left[place] = sine * left.x() + cosine * left.y();
  ring_.right[place] = cosine * right.y() - sine * right.x();

  const double distance = from.distance + edge.length;
  const bool isNearer = (distance < record.distance * kShorter) & !isFinal(record);
  VertexRecord& reached = *(isNearer ? &record : &nowhere_);
  reached.distance = distance;
  reached.base = from.distance;
  reached.corner = edge.reverse;
  reached.settled = false;
  reached.alongEdge = true;

  constexpr double kRoom[2] = {0, kInfinity};
  ring_.record[place] = &record;
  ring_.number[place] = number;
  ring_.distance[place] = record.distance;
  const double least = 0.5 * (from.distance + record.distance - edge.length);
  ring_.least[place] = edge.length * least;
  ring_.room[place] = edge.length * (record.distance - least) + kRoom[record.settled ? 1 : 0];
  ring_.length[place] = edge.length;
  ring_.area[place] = edge.cross;
}

/// Repeats the first edge after the last.
void FastDistance::closeRing(int place) {
  ring_.record[place] = ring_.record[0];
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
/// miss the edge by much, unless another front came to the edge's other end, which may go through
/// it: the end is nearer than straight on from this vertex.
void FastDistance::findCrossings(double distance, double radius, int corners) {
  Ring& ring = ring_;
  // By more than this part of the edge.
  constexpr double kNearer = 0.2;
  const auto mayCross = [&](int edge, int apex, double area, const double* sines) {
    const double sine = sines[edge];
    const double drop = area + radius * sine;
    const double place = radius * sines[apex];
    const bool isBefore = place < -kFarBeside * drop;
    const bool isBehind = place > (1 + kFarBeside) * drop;
    const bool crosses = (sine >= 0) & !isBefore & !isBehind;
    const double soonest = distance - ring.dot[edge] - kNearer * ring.length[edge];
    const bool isSeen = (ring.distance[edge] < soonest) & (ring.room[edge] == kInfinity);
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
void FastDistance::cross(int vertex, const VertexRecord& from, int edgeInRing, int targetInRing) {
  const int edgeNumber = ring_.number[edgeInRing];
  const FanEdge& edge = fans_->edges[edgeNumber];
  const FanEdge& target = fans_->edges[ring_.number[targetInRing]];
  const VertexRecord& other = *ring_.record[edgeInRing];
  const double radius = from.distance - from.base;
  const double length = edge.length;
  const double squared = length * length;
  const double sine = (kSide > 0 ? ring_.left : ring_.right)[edgeInRing];
  const double area = (kSide > 0 ? edge : target).cross;
  const double dot = (kSide > 0 ? edge : target).dot;
  double cosine = ring_.dot[edgeInRing];
  if (kSide > 0 ? edgeNumber <= from.corner : edgeNumber > from.corner) {
    const Vec2& turn = fans_->turn[vertex];
    cosine = cosine * turn.x() - kSide * karcher::cross(from.toSource, edge.vector) * turn.y();
  }
  const bool faces = sine >= 0;
  if (!other.settled) {
    // The bound of findCrossings for straight paths from this vertex's source, without a root.
    const double away = radius - cosine;
    const double gain = (cosine - kWait * length) * squared - dot * cosine + area * sine;
    if (away > 0 && 2 * away * gain > (squared - cosine * cosine) * squared) return;
  }
  if ((fans_->flags[vertex] & VertexFans::kWide) != 0 && turnsTooFar(vertex, edgeNumber, kSide)) {
    return;
  }
  const double inverse = 1 / length;
  EdgeEnd end;
  end.cosine = cosine * inverse;
  end.sine = sine * inverse;
  end.seen = faces;
  end.distance = from.distance * inverse;
  end.base = from.base * inverse;
  const double inverseSquare = inverse * inverse;
  crossEdge<kSide>(edge, target, other, *ring_.record[targetInRing], end,
                   Vec2(dot * inverseSquare, area * inverseSquare), inverse);
}

/// The path to the end of the edge `target`, which lies at `apex` in the crossed edge's frame.
template <int kSide>
void FastDistance::crossEdge(const FanEdge& edge, const FanEdge& target, const VertexRecord& other,
                             VertexRecord& reached, const EdgeEnd& a, const Vec2& apex,
                             double inverse) {
  EdgeEnd b;
  b.distance = other.distance * inverse;
  b.base = other.base * inverse;
  ApexArrival best;
  if (other.settled) {
    b.seen = findSourceAngle<-kSide>(edge, other, inverse, b);
    best = crossSettledEdge(a, b, apex);
  } else {
    if (!other.alongEdge && edge_crossing::hides(a, b)) return;
    best = edge_crossing::straight(a, apex);
    const double wait = best.distance - a.base - kWait;
    if (wait > 0 && a.squaredRadiusAtOtherEnd() < wait * wait) return;
  }
  double distance = best.distance * edge.length;
  const int reverse = target.reverse;
  const int arrivalCorner = kSide > 0 ? reverse : fans_->before(target.head, reverse);
  if (!mayArrive(reached, distance, arrivalCorner)) return;
  const double straight = noLessThanStraight(target.head, distance);
  const bool isTooShort = straight > distance;
  if (isTooShort) {
    if (!mayArrive(reached, straight, arrivalCorner)) return;
    distance = straight;
  }

  // At the apex the edge to this vertex has the direction of -apex here, and of `reverse` there.
  VertexRecord record;
  record.distance = distance;
  record.base = best.base * edge.length;
  const Vec2 relative = rotateBack(Vec2(-apex.x(), -kSide * apex.y()),
                                   Vec2(best.toSource.x(), kSide * best.toSource.y()));
  record.toSource = rotate(fans_->edges[reverse].vector, relative) *
                    (edge.length / (target.length * target.length));
  if (kSide < 0 && reverse == fans_->begin[target.head]) {
    record.toSource = rotate(fans_->turn[target.head], record.toSource);
  }
  record.corner = arrivalCorner;
  if (ties(reached, distance, arrivalCorner)) {
    // One and the same path may be found through both corners beside an edge, and the straight line
    // is not the length of what was too short.
    const bool isOther = !isTooShort && !haveOneDirection(target.head, record, reached);
    const bool isBetter =
        isOther ? arrivalCorner < reached.corner : distance < reached.distance * kShorter;
    if (!isBetter) return;
    hasTied_ = true;
  }
  record.place = reached.place;
  record.times = reached.times;
  record.delay = reached.delay;
  reached = record;
}

/// Finds the angle at the end of an edge from the edge to the end's source, on the right
/// (kSide = -1) or on the left (kSide = 1). Returns false if it is more than pi.
template <int kSide>
bool FastDistance::findSourceAngle(const FanEdge& along, const VertexRecord& record,
                                   double inverseLength, EdgeEnd& end) const {
  if (record.distance == 0) return true;
  const int vertex = along.head;
  const int edge = along.reverse;
  // In the corner beside the edge on the wrong side.
  if (record.corner == (kSide > 0 ? edge : fans_->before(vertex, edge))) return false;
  const uint8_t flags = fans_->flags[vertex];
  double x = record.toSource.x();
  double y = record.toSource.y();
  if (kSide > 0 ? record.corner >= edge : record.corner < edge) {
    if ((flags & VertexFans::kBoundary) != 0) return false;
    const Vec2& turn = fans_->turn[vertex];
    const Vec2 turned =
        kSide > 0 ? rotateBack(turn, record.toSource) : rotate(turn, record.toSource);
    x = turned.x();
    y = turned.y();
  }
  const Vec2& vector = fans_->edges[edge].vector;
  end.sine = kSide * (x * vector.y() - y * vector.x()) * inverseLength;
  if (end.sine < 0) return false;
  end.cosine = (x * vector.x() + y * vector.y()) * inverseLength;
  return (flags & VertexFans::kWide) == 0 || !turnsTooFar(vertex, edge, kSide);
}

/// Whether the angle from an edge to the vertex's source, on the right (side = 1) or on the left
/// (side = -1), is more than 3/2 pi, though its sine is that of a smaller one.
bool FastDistance::turnsTooFar(int vertex, int edge, int side) const {
  double angle = side * (fans_->angles[edge] - direction(vertex));
  if (angle < 0) angle += geometry_.totalAngle[vertex];
  return angle > 1.5 * kPi;
}

/// No path on the surface is shorter than the straight line in space.
double FastDistance::noLessThanStraight(int vertex, double distance) const {
  const double squared = (geometry_.mesh->positions[vertex] - source_).squaredNorm();
  return distance * distance < squared * (1 - kRounding) ? std::sqrt(squared) : distance;
}

bool FastDistance::mayArrive(const VertexRecord& record, double distance, int corner) const {
  if (!(distance < kInfinity) || isFinal(record)) return false;
  if (distance < record.distance * kShorter) return true;
  if (ties(record, distance, corner)) return true;
  // What came over the same edge when less was known of its ends is replaced.
  return !record.settled && !record.alongEdge && record.corner == corner &&
         distance != record.distance;
}

/// Whether another path across faces is as long as the vertex's.
bool FastDistance::ties(const VertexRecord& record, double distance, int corner) {
  return record.corner != corner && isTie(distance, record.distance) && !record.alongEdge;
}

/// Whether two paths come to a vertex from one direction.
bool FastDistance::haveOneDirection(int vertex, const VertexRecord& a,
                                    const VertexRecord& b) const {
  double apart = std::abs(direction(a) - direction(b));
  if (!fans_->onBoundary(vertex)) {
    apart = std::min(apart, geometry_.totalAngle[vertex] - apart);
  }
  return apart < kSameDirection;
}

void FastDistance::enqueue(int vertex, VertexRecord& record, double before) {
  if (before == kInfinity) {
    record.delay = fans_->delay[vertex];
    longestDelay_ = std::max(longestDelay_, record.delay);
  }
  if (record.place == kNotWaiting) {
    if (record.times == kMostTimes) {
      record.settled = true;
      return;
    }
    ++record.times;
    record.place = queue_.push(record.distance, vertex);
  } else {
    queue_.lower(record.place, record.distance);
  }
}

double FastDistance::direction(int vertex) const { return direction(*vertices_.find(vertex)); }

double FastDistance::direction(const VertexRecord& record) const {
  const Vec2& edge = fans_->edges[record.corner].vector;
  const double inCorner =
      std::atan2(karcher::cross(edge, record.toSource), edge.dot(record.toSource));
  return fans_->angles[record.corner] + inCorner;
}

PathStep FastDistance::stepTo(int vertex) const {
  const VertexRecord* record = vertices_.find(vertex);
  if (record == nullptr || record->distance == 0 || record->distance == kInfinity) return {};
  const FanEdge& right = fans_->edges[record->corner];
  if (record->alongEdge || right.cross <= 0) return {right.head, right.head, 0};
  // The corner in the frame of its first edge: how far the ends of the other two lie from the path.
  const Vec2 onward = rotateBack(right.vector, record->toSource) / right.length;
  const Vec2 left = Vec2(right.dot, right.cross) / right.length;
  const double before = right.length * onward.y();
  const double behind = karcher::cross(onward, left);
  const int next = fans_->edges[fans_->after(vertex, record->corner)].head;
  const double part = before / (before + behind);
  return {right.head, next, std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 0};
}

Vec2 FastDistance::logVector(int vertex) const {
  const VertexRecord& record = *vertices_.find(vertex);
  // The frame's angles are the fan's, scaled: a small turn where the surface bends little.
  const double turn = (geometry_.angleScale[vertex] - 1) * direction(vertex);
  return -2 * record.distance * rotate(unitVectorOfSmall(turn), record.toSource);
}

}  // namespace karcher

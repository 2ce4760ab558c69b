#include "distance/window_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "intrinsic/angles.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The width of the queue's buckets: wide enough that many windows cross a face together, narrow
/// enough that few do so in vain. It is half a mean edge at first, and is halved until at most a
/// fourth of a sample of the edges are shorter than half a bucket.
double bucketWidth(const Geometry& geometry) {
  constexpr int kMostEdges = 1024;
  const int count = geometry.edgeLength.count();
  // The step is no multiple of 3, so that the sample does not take the same corner of every face.
  const int most = (count + kMostEdges - 1) / kMostEdges;
  const int step = most % 3 == 0 ? most + 1 : most;
  const auto areShort = [&](double length) {
    int shorter = 0;
    for (int h = 0; h < count; h += step) shorter += geometry.edgeLength[h] < length;
    return 4 * int64_t{step} * shorter > count;
  };
  double width = geometry.meanEdge / 2;
  // The loop ends, since no edge is shorter than the shortest.
  while (areShort(width / 2)) width /= 2;
  return width;
}

/// A threshold for the ratio of the longest edge to the shortest. Above it, a window may circle
/// over the same edges and never come near a vertex from which shorter paths would end it.
constexpr double kThin = 1e3;

/// The two sides of a face above half-edge h, as vectors from its tail and from its head. Each is
/// as exact as its own length allows.
struct FaceSides {
  Vec2 fromTail;
  Vec2 fromHead;
};

FaceSides sidesOver(const Geometry& geometry, int h) {
  const int right = next(h);
  const int left = previous(h);
  const Vec2 atHead = unitVector(geometry.cornerAngle[right]);
  return {geometry.edgeLength[left] * unitVector(geometry.cornerAngle[h]),
          geometry.edgeLength[right] * Vec2(-atHead.x(), atHead.y())};
}

/// An edge that windows reach across a face. It is seen from the end that it shares with the
/// previous edge, through which the windows came.
struct SideEdge {
  int twin;  ///< the half-edge where the windows will wait; -1 at the boundary
  double length;
  Vec2 along;           ///< a unit vector along the edge, in the frame of the previous edge
  double leftLength;    ///< the length of the previous edge
  double nearDistance;  ///< the distance of the shared end
  double apexDistance;
  double farDistance;  ///< the distance of the other end of the previous edge
};

/// The squared distance from the window's source to a point above the half-edge, without the
/// offset.
inline double squaredLeg(const Window& w, const Vec2& point) {
  return square(point.x() - w.sourceX) + square(point.y() + w.depth);
}

/// Trims a window on a side of the face, by the distances of the face's three corners. Returns
/// false if nothing worth keeping remains.
inline bool isWorthKeeping(const SideEdge& side, double narrowest, Window& window) {
  return trimByTail(window, side.nearDistance) &&
         trimByHead(window, side.apexDistance, side.length) &&
         !isTooNarrow(window, narrowest * side.length) &&
         !isBeatenFrom(window, side.farDistance, side.leftLength * side.along.x(),
                       side.leftLength * side.along.y(), window.begin);
}

}  // namespace

WindowDistance::WindowDistance(const Geometry& geometry, double tolerance,
                               const std::shared_ptr<PagePool>& pages)
    : geometry_(geometry),
      mesh_(*geometry.mesh),
      tolerance_(tolerance),
      vertices_(mesh_.vertexCount(), pages),
      waiting_(mesh_.faceCount(), pages),
      // Above the square root of the widest range, the solver computes the apex of a face from both
      // ends of the edge that windows cross (FaceSides), so that no short length is a difference of
      // long ones. Windows that leave a source inside a face always use both ends.
      isWide_(geometry.longestEdge > std::sqrt(kWidestRange) * geometry.shortestEdge),
      isThin_(geometry.longestEdge > kThin * geometry.shortestEdge),
      // Between the ends of very short edges, windows just wider than rounding matter, too.
      narrowest_(isWide_ ? kStepRounding : kNarrowestWindow),
      midpoints_(geometry),
      queue_(bucketWidth(geometry)),
      target_(geometry),
      images_(geometry) {
  // Lengths have rounding errors, too.
  if (geometry.longestEdge > (1 + kChainRounding) * kWidestRange * geometry.shortestEdge) {
    throw Error(ErrorCode::kBadArgument,
                "edge lengths from " + inSentence(geometry.shortestEdge) + " to " +
                    inSentence(geometry.longestEdge) +
                    " are too wide a range for exact distances: at most 1e12 to 1");
  }
}

void WindowDistance::setSource(const SurfacePoint& source) {
  vertices_.clear();
  waiting_.clear();
  widest_.clear();
  midpoints_.clear();
  queue_.clear();
  windowsLeft_ = static_cast<int64_t>(kMostWindowsPerFace) * mesh_.faceCount();
  target_.clear();
  images_.clear();
  source_ = source;
  reachedCount_ = 0;
  const PointLocation location = locate(mesh_, source);
  if (location.simplex == Simplex::kVertex) {
    VertexRecord& record = vertices_.touch(location.vertex);
    record.arrival.distance = 0;
    ++reachedCount_;
    leaveVertex(location.vertex);
    return;
  }
  leaveSourceFace(source.face, source, location.halfedge);
  if (location.simplex == Simplex::kEdge) {
    const int t = mesh_.twin[location.halfedge];
    if (t >= 0) leaveSourceFace(faceOf(t), inFace(mesh_, source, faceOf(t)), t);
  }
}

void WindowDistance::grow(double radius) {
  int item = 0;
  while (queue_.pop(radius, item)) {
    if (item >= 0) {
      if (waiting_.isDue(item, queue_.current())) carryAcross(item);
      continue;
    }
    VertexRecord& record = vertices_.touch(~item);
    if (record.bucket == queue_.current()) {
      record.bucket = kNotQueued;
      leaveVertex(~item);
    }
  }
  if (queue_.empty() && !aim_ && reachedCount_ < mesh_.vertexCount()) reachAlongEdges();
}

PathStep WindowDistance::stepTo(int vertex) const {
  const VertexRecord* record = vertices_.find(vertex);
  if (record == nullptr || record->via < 0) return {};
  const auto& [length, before, turn] = record->arrival;  // Joint windows do not begin at a turn.
  if (turn >= 0 && before > 0 && isTie(before, distance(turn))) return {turn, turn};
  const double part = record->crossing / geometry_.edgeLength[record->via];
  return {mesh_.tail(record->via), mesh_.head(record->via), std::clamp(part, 0.0, 1.0),
          record->via};
}

double WindowDistance::direction(int vertex) const {
  const VertexRecord& record = *vertices_.find(vertex);
  if (record.via < 0) return 0;
  const Vec2 apex = oppositeOverHalfedge(geometry_, record.via);
  const Vec2 toTail = -apex;
  const Vec2 toCrossing = Vec2(record.crossing, 0) - apex;
  const double angle =
      geometry_.cumulatedAngle[previous(record.via)] + angleFromTo(toTail, toCrossing);
  const double total = geometry_.totalAngle[vertex];
  if (mesh_.onBoundary[vertex]) return std::clamp(angle, 0.0, total);
  return angle < 0 ? angle + total : angle >= total ? angle - total : angle;
}

/// Sends out paths from a point of a face to the corners of the face, and windows through its
/// edges, except an edge on which the point lies.
void WindowDistance::leaveSourceFace(int face, const SurfacePoint& source, int ownEdge) {
  if (images_.areKept()) images_.addSource(face, source);
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const double length = geometry_.edgeLength[h];
    const FaceSides sides = sidesOver(geometry_, h);
    const double atTail = source.bary[cornerOf(h)];
    const double atHead = source.bary[cornerOf(next(h))];
    const double height = source.bary[cornerOf(previous(h))];
    const int vertex = mesh_.opposite(h);
    const double leg = (atTail * sides.fromTail + atHead * sides.fromHead).norm();
    const double crossing = length * atHead / (atTail + atHead);
    arrive(vertex, vertices_.touch(vertex), {leg, 0, -1}, h, crossing);
    const int t = mesh_.twin[h];
    if (t >= 0 && h != ownEdge) {
      const double fromHead = atTail * length - height * sides.fromHead.x();
      addWindow(t, {0, length, fromHead, height * sides.fromTail.y()});
    }
  }
}

/// Sends out windows from a vertex: all around if it is the source, else into the wedge behind it.
void WindowDistance::leaveVertex(int vertex) {
  const double total = geometry_.totalAngle[vertex];
  const bool isSource = vertices_.touch(vertex).via < 0;
  const double back = isSource ? 0 : direction(vertex);
  const double ahead = back + kPi - kChainRounding;
  const double width = total - 2 * kPi + 2 * kChainRounding;
  const bool isBehindStart = ahead > total + kChainRounding;
  for (const int h : outgoingHalfedges(mesh_, vertex)) {
    const double right = geometry_.cumulatedAngle[h];
    const auto leave = [&](double from, double to) {
      if (to >= 0 && from <= geometry_.cornerAngle[h]) leaveThroughCorner(vertex, h, from, to);
    };
    if (isSource) {
      leave(0, geometry_.cornerAngle[h]);
    } else if (mesh_.onBoundary[vertex]) {
      leave(ahead - right, kInfinity);
      leave(-kInfinity, back - kPi + kChainRounding - right);
    } else {
      const double end = ahead + width - right;
      // Half-edges are in the order of their angles, so the wedge ends before this one.
      if (end < 0 || (isBehindStart && end < total)) break;
      leave(ahead - right, end);
      leave(ahead - right - total, end - total);
    }
  }
}

/// Sends out the part of a vertex's wedge that lies in the corner of half-edge h, between the
/// angles `from` and `to`. Angles count from h.
void WindowDistance::leaveThroughCorner(int vertex, int h, double from, double to) {
  const double angle = geometry_.cornerAngle[h];
  const double distance = vertices_.touch(vertex).arrival.distance;
  if (images_.areKept()) images_.addCorner(h, distance, from, to);
  const auto arriveAlong = [&](int neighbour, double edge, int via, double crossing) {
    arrive(neighbour, vertices_.touch(neighbour), {distance + edge, distance, vertex}, via,
           crossing);
  };
  if (from <= 0) {
    const int via = previous(h);
    arriveAlong(mesh_.head(h), geometry_.edgeLength[h], via, geometry_.edgeLength[via]);
  }
  if (to >= angle) arriveAlong(mesh_.opposite(h), geometry_.edgeLength[previous(h)], h, 0);
  if (target_.liesIn(faceOf(h))) target_.arriveFromCorner(h, vertex, distance);

  const int edge = next(h);
  const int t = mesh_.twin[edge];
  if (t < 0) return;
  const double length = geometry_.edgeLength[edge];
  // The vertex in the frame of the edge, and in that of its twin.
  const Vec2 fromTail =
      isWide_ ? sidesOver(geometry_, edge).fromTail : oppositeOverHalfedge(geometry_, edge);
  Window window;
  window.sourceX = isWide_ ? -sidesOver(geometry_, edge).fromHead.x() : length - fromTail.x();
  window.depth = fromTail.y();
  const auto hit = [&](double a) {
    const Vec2 turn = unitVector(a);
    return length -
           turn.y() * fromTail.squaredNorm() / (fromTail.x() * turn.y() + fromTail.y() * turn.x());
  };
  window.begin = to < angle ? hit(to) : 0;
  window.end = from > 0 ? hit(from) : length;
  window.offset = distance;
  window.pseudoSource = vertex;
  window.begin = std::max(window.begin, 0.0);
  window.end = std::min(window.end, length);
  const VertexRecord& tail = vertices_.touch(mesh_.tail(t));
  const VertexRecord& head = vertices_.touch(mesh_.head(t));
  if (trimByTail(window, tail.arrival.distance) &&
      trimByHead(window, head.arrival.distance, length) &&
      !isTooNarrow(window, narrowest_ * length)) {
    addWindow(t, window);
  }
}

/// Leads the windows that wait at half-edge h across its face: first to the apex, then to the other
/// two edges of the face. The apex's distance trims the windows on these edges.
void WindowDistance::carryAcross(int h) {
  const double length = geometry_.edgeLength[h];
  const int left = previous(h);
  const int right = next(h);
  const double leftLength = geometry_.edgeLength[left];
  const double rightLength = geometry_.edgeLength[right];
  Vec2 apex = oppositeOverHalfedge(geometry_, h);
  Vec2 fromHead(length - apex.x(), apex.y());
  if (isWide_) {
    const FaceSides sides = sidesOver(geometry_, h);
    apex = sides.fromTail;
    fromHead = Vec2(-sides.fromHead.x(), sides.fromHead.y());
  }
  const int apexVertex = mesh_.opposite(h);
  const double tail = vertices_.touch(mesh_.tail(h)).arrival.distance;
  const double head = vertices_.touch(mesh_.head(h)).arrival.distance;
  VertexRecord& top = vertices_.touch(apexVertex);

  waiting_.take(h, batch_);
  // Distances through joint windows, and of vertices that these reached, are exact only up to the
  // tolerance.
  double slack = 0;
  if (tolerance_ > 0) {
    slack = tolerance_ * length * apex.y() / std::max({length, leftLength, rightLength});
    joinWindows(slack, batch_);
  }
  windowsLeft_ -= batch_.count();
  if (windowsLeft_ < 0) {
    throw Error(ErrorCode::kBadArgument,
                "exact distances need more than " + std::to_string(kMostWindowsPerFace) +
                    " windows a face on this mesh (10 to 100 are usual); the solver 'graph' needs "
                    "none");
  }

  crossings_.resize(std::max(crossings_.size(), batch_.size()));
  int nearest = 0;  // the window that comes nearest to seeing the apex
  double leastMiss = kInfinity;
  const double tolerance = kSeenTolerance * length;
  for (int i = 0; i < batch_.count(); ++i) {
    const Window& window = batch_[i];
    const double crossing = crossingTowards(window, apex);
    crossings_[i] = crossing;
    const double miss = std::max(window.begin - crossing, crossing - window.end);
    if (miss < leastMiss) {
      leastMiss = miss;
      nearest = i;
    }
    if (miss <= tolerance) {
      arrive(
          apexVertex, top,
          {window.offset + std::sqrt(squaredLeg(window, apex)), window.offset, window.pseudoSource},
          h, crossing);
    }
  }
  if (leastMiss > tolerance) {
    arriveBent(apexVertex, top, h, apex, batch_[nearest], crossings_[nearest]);
  }
  if (images_.areKept()) images_.addWindows(h, batch_, tail);
  if (target_.liesIn(faceOf(h))) {
    for (const Window& window : batch_) target_.arriveThrough(h, window);
  }

  // Windows to the right are carried as mirror images of windows to the left. In a needle the apex
  // is exact only up to the rounding of the long edges, so the unit vectors are normalized.
  const SideEdge leftSide{mesh_.twin[left], leftLength,   apex.normalized(),
                          length,           tail + slack, top.arrival.distance + slack,
                          head + slack};
  for (int i = 0; i < batch_.count() && leftSide.twin >= 0; ++i) {
    if (!(crossings_[i] > batch_[i].begin)) continue;
    Window window = carriedToTailEdge(batch_[i], leftSide.along, length, leftLength, crossings_[i]);
    if (isWorthKeeping(leftSide, narrowest_, window)) addWindow(leftSide.twin, window);
  }
  const SideEdge rightSide{mesh_.twin[right],     rightLength,
                           fromHead.normalized(), length,
                           head + slack,          top.arrival.distance + slack,
                           tail + slack};
  for (int i = 0; i < batch_.count() && rightSide.twin >= 0; ++i) {
    if (!(crossings_[i] < batch_[i].end)) continue;
    Window window = carriedToTailEdge(mirrored(batch_[i], length), rightSide.along, length,
                                      rightLength, length - crossings_[i]);
    if (isWorthKeeping(rightSide, narrowest_, window)) {
      addWindow(rightSide.twin, mirrored(window, rightLength));
    }
  }
}

/// Offers the apex a path through a window that does not see the apex. The path bends slightly at
/// an end of the window, so its length is an upper bound. The length is exact if the apex lies in a
/// gap that only rounding left between two windows.
void WindowDistance::arriveBent(int vertex, VertexRecord& record, int via, const Vec2& apex,
                                const Window& window, double crossing) {
  // If the straight path is too long, so is the bent one.
  const double lead = record.arrival.distance - window.offset;
  if (lead <= 0 || square(lead) <= squaredLeg(window, apex)) return;
  const double bend = std::min(std::max(crossing, window.begin), window.end);
  const double length = distanceAt(window, bend) + (apex - Vec2(bend, 0)).norm();
  arrive(vertex, record, {bentLength(length), window.offset, window.pseudoSource}, via, bend);
}

void WindowDistance::arrive(int vertex, VertexRecord& record, const Arrival& arrival, int via,
                            double crossing) {
  const double before = record.arrival.distance;
  const bool isBetter = isTie(arrival.distance, before)
                            ? std::tie(via, arrival.pseudoSource, crossing) <
                                  std::tie(record.via, record.arrival.pseudoSource, record.crossing)
                            : arrival.distance < before;
  if (!isBetter || before <= queue_.leastKey()) return;
  reachedCount_ += before == kInfinity;
  record.arrival = arrival;
  record.crossing = crossing;
  record.via = via;
  if (!spreadsPaths(geometry_, vertex)) return;
  if (aim_ && arrival.distance + (mesh_.positions[vertex] - aim_->center).norm() >
                  aim_->mostLength + aim_->radius) {
    return;
  }
  const int bucket = queue_.bucketOf(arrival.distance);
  if (bucket < record.bucket) {
    record.bucket = bucket;
    queue_.push(~vertex, bucket);
  }
}

/// Whether every point of the window has a shorter path through the widest earlier window at h.
/// Records the window if it is wider.
bool WindowDistance::isBehindAnother(int h, const Window& window) {
  constexpr double kAtTip = 1e-6;
  const auto [entry, isNew] = widest_.try_emplace(h, window);
  if (isNew) return false;
  Window& other = entry->second;
  if (other.offset == window.offset && other.begin <= window.begin && window.end <= other.end) {
    // Along the edge, the squared lengths through both windows differ by a linear function. At a
    // tip this function is zero up to the rounding of all faces round the tip. The rounding moves
    // its zero along the edge.
    const double atBegin = squaredLegTo(other, window.begin) / squaredLegTo(window, window.begin);
    const double atEnd = squaredLegTo(other, window.end) / squaredLegTo(window, window.end);
    const double most = std::max(atBegin, atEnd);
    const double least = std::min(atBegin, atEnd);
    if (least < 1 - kChainRounding && most <= 1 + kChainRounding &&
        most - 1 <= kAtTip * (1 - least)) {
      return true;
    }
  }
  if (window.end - window.begin > other.end - other.begin) other = window;
  return false;
}

/// Whether every path through the window is too long when it reaches the aim's ball.
bool WindowDistance::leadsAway(int h, const Window& window) const {
  const Vec3 middle = (mesh_.positions[mesh_.tail(h)] + mesh_.positions[mesh_.head(h)]) / 2;
  const double left = (middle - aim_->center).norm() - geometry_.edgeLength[h] / 2 - aim_->radius;
  return leastDistance(window) + left > aim_->mostLength;
}

void WindowDistance::addWindow(int h, const Window& window) {
  if (aim_ && leadsAway(h, window)) return;
  if (isThin_ && isBehindAnother(h, window)) return;
  if (keepsMidpoints_) midpoints_.take(h, window, queue_.leastKey());
  const int bucket = queue_.bucketOf(leastDistance(window));
  if (waiting_.add(h, window, bucket)) queue_.push(h, bucket);
}

}  // namespace karcher

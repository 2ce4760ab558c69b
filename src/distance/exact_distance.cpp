#include "distance/exact_distance.h"

#include <algorithm>
#include <string>

#include "mesh/error.h"

namespace karcher {
namespace {

/// Width of the queue's buckets in mean edges: wide enough that many windows cross a face together,
/// narrow enough that few are carried on that a later one beats.
constexpr double kBucketWidth = 0.5;

/// How much wider than its wedge a vertex sends out windows, radians: the rounding of directions.
constexpr double kWedgeMargin = 1e-9;

/// A line that misses its window by this part of the edge still counts as seen through it.
constexpr double kSeenTolerance = 1e-10;

/// Paths with a slight bend, at the end of a window, are counted longer by this part: so that the
/// straight path wins, whose direction is exact.
constexpr double kBentPenalty = 1e-12;

/// An arrival must be better by this part to count: not by rounding alone.
constexpr double kImprovement = 1e-14;

/// Shortest paths turn round vertices with more angle than this.
bool spreadsPaths(const Geometry& geometry, int vertex) {
  const double flat = geometry.mesh->onBoundary[vertex] ? kPi : 2 * kPi;
  return geometry.totalAngle[vertex] > flat + kWedgeMargin;
}

/// An edge that windows are carried to, seen from the end that it shares with the edge they leave.
struct SideEdge {
  int twin;  ///< the half-edge where they will wait; -1 at the boundary
  double length;
  Vec2 along;           ///< unit, in the frame of the edge they leave
  double leftLength;    ///< of the edge they leave
  double nearDistance;  ///< of the shared end
  double apexDistance;
  double farDistance;  ///< of the other end of the edge they leave
};

/// Trims a window that was carried to a side by the three corners of the face; false if nothing
/// worth keeping is left.
inline bool isWorthKeeping(const SideEdge& side, Window& window) {
  return trimByTail(window, side.nearDistance) &&
         trimByHead(window, side.apexDistance, side.length) && !isTooNarrow(window, side.length) &&
         !isBeatenFrom(window, side.farDistance, side.leftLength * side.along.x(),
                       side.leftLength * side.along.y(), window.begin);
}

}  // namespace

ExactDistance::ExactDistance(const Geometry& geometry)
    : geometry_(geometry),
      mesh_(*geometry.mesh),
      vertices_(mesh_.vertexCount()),
      faces_(mesh_.faceCount()),
      middles_(mesh_.faceCount()),
      queue_(kBucketWidth * geometry.meanEdge) {}

void ExactDistance::setSource(const SurfacePoint& source) {
  vertices_.clear();
  faces_.clear();
  middles_.clear();
  queue_.clear();
  pool_.clear();
  windowsLeft_ = static_cast<int64_t>(kMostWindowsPerFace) * mesh_.faceCount();
  targetFaces_[0] = targetFaces_[1] = -1;
  target_ = {};
  beams_.clear();
  source_ = source;
  const PointLocation location = locate(mesh_, source);
  if (location.simplex == Simplex::kVertex) {
    VertexRecord& record = vertices_.touch(location.vertex);
    record.arrival.distance = 0;
    leaveVertex(location.vertex);
    return;
  }
  leaveSourceFace(source.face, source, location.halfedge);
  if (location.simplex == Simplex::kEdge) {
    const int t = mesh_.twin[location.halfedge];
    if (t >= 0) leaveSourceFace(faceOf(t), inFace(mesh_, source, faceOf(t)), t);
  }
}

void ExactDistance::grow(double radius) {
  int item = 0;
  while (queue_.pop(radius, item)) {
    if (item >= 0) {
      if (waitingAt(item).bucket == queue_.current()) carryAcross(item);
      continue;
    }
    VertexRecord& record = vertices_.touch(~item);
    if (record.bucket == queue_.current()) {
      record.bucket = kNotQueued;
      leaveVertex(~item);
    }
  }
}

double ExactDistance::direction(int vertex) const {
  const VertexRecord& record = *vertices_.find(vertex);
  if (record.via < 0) return 0;
  const Vec2 apex = oppositeOverHalfedge(geometry_, record.via);
  const Vec2 toTail = -apex;
  const Vec2 toCrossing = Vec2(record.crossing, 0) - apex;
  const double angle = geometry_.cumulatedAngle[previous(record.via)] +
                       std::atan2(cross(toTail, toCrossing), toTail.dot(toCrossing));
  const double total = geometry_.totalAngle[vertex];
  if (mesh_.onBoundary[vertex]) return std::clamp(angle, 0.0, total);
  return angle < 0 ? angle + total : angle >= total ? angle - total : angle;
}

/// From a point of a face to its corners, and through its edges but the one the point lies on.
void ExactDistance::leaveSourceFace(int face, const SurfacePoint& source, int ownEdge) {
  if (beamDistance_ >= 0) keepSourceBeam(face, source);
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const double length = geometry_.edgeLength[h];
    const Vec2 apex = oppositeOverHalfedge(geometry_, h);
    const double height = source.bary[cornerOf(previous(h))];
    const Vec2 point = Vec2(source.bary[cornerOf(next(h))] * length, 0) + height * apex;
    const int vertex = mesh_.opposite(h);
    const double crossing = apex.x() + (point.x() - apex.x()) / (1 - height);
    arrive(vertex, vertices_.touch(vertex), {(apex - point).norm(), 0, -1}, h, crossing);
    const int t = mesh_.twin[h];
    if (t >= 0 && h != ownEdge) addWindow(t, {0, length, length - point.x(), point.y()});
  }
}

/// Sends out windows from a vertex: all around from the source, else into the wedge behind it.
void ExactDistance::leaveVertex(int vertex) {
  const double total = geometry_.totalAngle[vertex];
  const bool isSource = vertices_.touch(vertex).via < 0;
  const double back = isSource ? 0 : direction(vertex);
  const double ahead = back + kPi - kWedgeMargin;
  const double width = total - 2 * kPi + 2 * kWedgeMargin;
  int h = mesh_.outgoing[vertex];
  do {
    const double right = geometry_.cumulatedAngle[h];
    if (isSource) {
      leaveThroughCorner(vertex, h, 0, geometry_.cornerAngle[h]);
    } else if (mesh_.onBoundary[vertex]) {
      leaveThroughCorner(vertex, h, ahead - right, kInfinity);
      leaveThroughCorner(vertex, h, -kInfinity, back - kPi + kWedgeMargin - right);
    } else {
      leaveThroughCorner(vertex, h, ahead - right, ahead + width - right);
      leaveThroughCorner(vertex, h, ahead - right - total, ahead + width - right - total);
    }
    h = rotateLeft(mesh_, h);
  } while (h >= 0 && h != mesh_.outgoing[vertex]);
}

/// The part of a vertex's wedge in the corner of half-edge h; angles are measured from h.
void ExactDistance::leaveThroughCorner(int vertex, int h, double from, double to) {
  const double angle = geometry_.cornerAngle[h];
  if (!(from <= angle && to >= 0)) return;
  if (beamDistance_ >= 0) keepCornerBeam(vertex, h, from, to);
  const double distance = vertices_.touch(vertex).arrival.distance;
  const auto arriveAlong = [&](int neighbour, double edge, int via, double crossing) {
    arrive(neighbour, vertices_.touch(neighbour), {distance + edge, distance, vertex}, via,
           crossing);
  };
  if (from <= 0) {
    const int via = previous(h);
    arriveAlong(mesh_.head(h), geometry_.edgeLength[h], via, geometry_.edgeLength[via]);
  }
  if (to >= angle) arriveAlong(mesh_.opposite(h), geometry_.edgeLength[previous(h)], h, 0);
  if (isTargetFace(faceOf(h))) {
    const Vec2 toVertex = -targetOver(h);
    arriveAtTarget(h, {distance + toVertex.norm(), distance, vertex}, toVertex);
  }

  const int edge = next(h);
  const int t = mesh_.twin[edge];
  if (t < 0) return;
  const double length = geometry_.edgeLength[edge];
  const Vec2 position = oppositeOverHalfedge(geometry_, edge);
  const double foot = std::atan2(position.x(), position.y());
  const auto hit = [&](double a) { return position.x() + position.y() * std::tan(a - foot); };
  Window window;
  window.begin = to < angle ? length - hit(to) : 0;
  window.end = from > 0 ? length - hit(from) : length;
  window.sourceX = length - position.x();
  window.depth = position.y();
  window.offset = distance;
  window.pseudoSource = vertex;
  window.begin = std::max(window.begin, 0.0);
  window.end = std::min(window.end, length);
  const VertexRecord& tail = vertices_.touch(mesh_.tail(t));
  const VertexRecord& head = vertices_.touch(mesh_.head(t));
  if (trimByTail(window, tail.arrival.distance) &&
      trimByHead(window, head.arrival.distance, length) && !isTooNarrow(window, length)) {
    addWindow(t, window);
  }
}

/// Moves the windows that wait at half-edge h to the batch.
void ExactDistance::takeWaiting(int h) {
  WaitingWindows& waiting = waitingAt(h);
  batch_.clear();
  for (int index = waiting.first; index >= 0;) {
    const WindowBlock& block = pool_[index];
    batch_.insert(batch_.end(), block.windows, block.windows + block.count);
    const int after = block.next;
    pool_.release(index);
    index = after;
  }
  waiting = {};
  windowsLeft_ -= batch_.count();
  if (windowsLeft_ < 0) {
    throw Error(ErrorCode::kBadArgument, "exact distances on this mesh take more than " +
                                             std::to_string(kMostWindowsPerFace) +
                                             " windows a face");
  }
}

/// Carries the windows that wait at half-edge h across its face: first to the apex, so that then
/// all are held against its best distance, then to the edges on its sides.
void ExactDistance::carryAcross(int h) {
  takeWaiting(h);
  const double length = geometry_.edgeLength[h];
  const Vec2 apex = oppositeOverHalfedge(geometry_, h);
  const int apexVertex = mesh_.opposite(h);
  const double tail = vertices_.touch(mesh_.tail(h)).arrival.distance;
  const double head = vertices_.touch(mesh_.head(h)).arrival.distance;
  VertexRecord& top = vertices_.touch(apexVertex);

  // Windows are sorted by side without branches, which would be guessed wrong half of the time.
  leftward_.resize(std::max(leftward_.size(), batch_.size()));
  rightward_.resize(std::max(rightward_.size(), batch_.size()));
  int leftCount = 0;
  int rightCount = 0;
  bool seen = false;
  const double tolerance = kSeenTolerance * length;
  for (const Window& window : batch_) {
    const double crossing = crossingTowards(window, apex);
    if (crossing >= window.begin - tolerance && crossing <= window.end + tolerance) {
      seen = true;
      const double leg = square(apex.x() - window.sourceX) + square(apex.y() + window.depth);
      arrive(apexVertex, top, {window.offset + std::sqrt(leg), window.offset, window.pseudoSource},
             h, crossing);
    }
    leftward_[leftCount] = {window, crossing};
    leftCount += crossing > window.begin;
    rightward_[rightCount] = {window, crossing};
    rightCount += crossing < window.end;
  }
  if (!seen) arriveBent(apexVertex, top, h, apex);
  if (beamDistance_ >= 0) keepWindowBeams(h);
  if (isTargetFace(faceOf(h))) {
    for (const Window& window : batch_) arriveAtTargetThrough(h, window);
  }

  // The way to the right is the mirror image of the way to the left. Unit vectors are normalized,
  // since in a needle the apex is known to rounding of the long edges only.
  const int left = previous(h);
  const SideEdge leftSide{mesh_.twin[left],
                          geometry_.edgeLength[left],
                          apex.normalized(),
                          length,
                          tail,
                          top.arrival.distance,
                          head};
  for (int i = 0; i < leftCount && leftSide.twin >= 0; ++i) {
    Window window = carriedToTailEdge(leftward_[i].window, leftSide.along, leftSide.length,
                                      leftward_[i].crossing);
    if (isWorthKeeping(leftSide, window)) addWindow(leftSide.twin, window);
  }
  const int right = next(h);
  const SideEdge rightSide{mesh_.twin[right],
                           geometry_.edgeLength[right],
                           Vec2(length - apex.x(), apex.y()).normalized(),
                           length,
                           head,
                           top.arrival.distance,
                           tail};
  for (int i = 0; i < rightCount && rightSide.twin >= 0; ++i) {
    Window window = carriedToTailEdge(mirrored(rightward_[i].window, length), rightSide.along,
                                      rightSide.length, length - rightward_[i].crossing);
    if (isWorthKeeping(rightSide, window)) {
      addWindow(rightSide.twin, mirrored(window, rightSide.length));
    }
  }
}

/// Where no window of the batch sees the apex: the way with the slightest bend, as an upper bound,
/// and as the path itself where rounding left a gap between two windows.
void ExactDistance::arriveBent(int vertex, VertexRecord& record, int via, const Vec2& apex) {
  const Window* nearest = nullptr;
  double nearestMiss = kInfinity;
  double bend = 0;
  for (const Window& window : batch_) {
    const double crossing = crossingTowards(window, apex);
    const double end = std::min(std::max(crossing, window.begin), window.end);
    if (std::abs(crossing - end) < nearestMiss) {
      nearestMiss = std::abs(crossing - end);
      nearest = &window;
      bend = end;
    }
  }
  const double length = distanceAt(*nearest, bend) + (apex - Vec2(bend, 0)).norm();
  arrive(vertex, record, {length * (1 + kBentPenalty), nearest->offset, nearest->pseudoSource}, via,
         bend);
}

void ExactDistance::arrive(int vertex, VertexRecord& record, const Arrival& arrival, int via,
                           double crossing) {
  const double before = record.arrival.distance;
  if (!(arrival.distance < before * (1 - kImprovement)) || before <= queue_.leastKey()) return;
  record.arrival = arrival;
  record.crossing = crossing;
  record.via = via;
  if (!spreadsPaths(geometry_, vertex)) return;
  const int bucket = queue_.bucketOf(arrival.distance);
  if (bucket < record.bucket) {
    record.bucket = bucket;
    queue_.push(~vertex, bucket);
  }
}

void ExactDistance::addWindow(int h, const Window& window) {
  if (keepsMiddles_) keepMiddle(h, window);
  WaitingWindows& waiting = waitingAt(h);
  const int bucket = queue_.bucketOf(leastDistance(window));
  waiting.first = pool_.add(waiting.first, window);
  if (bucket < waiting.bucket) {
    waiting.bucket = bucket;
    queue_.push(h, bucket);
  }
}

void ExactDistance::keepMiddle(int h, const Window& window) {
  const double length = geometry_.edgeLength[h];
  const double middle = length / 2;
  const double tolerance = kSeenTolerance * length;
  if (window.begin > middle + tolerance || window.end < middle - tolerance) return;
  const double distance = distanceAt(window, middle);
  MiddleRecord& record = middles_.touch(faceOf(h)).edge[cornerOf(h)];
  if (!(distance < record.distance * (1 - kImprovement)) || record.distance <= queue_.leastKey()) {
    return;
  }
  record = {distance, window.sourceX, window.depth};
}

MiddleArrival ExactDistance::middleOf(int h) const {
  const double middle = geometry_.edgeLength[h] / 2;
  // The source itself may lie on the edge.
  const PointLocation place = locate(mesh_, source_);
  const int t = mesh_.twin[h];
  if (place.simplex == Simplex::kEdge && (place.halfedge == h || place.halfedge == t)) {
    const double part = source_.bary[cornerOf(next(place.halfedge))];
    const double along = (place.halfedge == h ? 2 * part - 1 : 1 - 2 * part) * middle;
    return {std::abs(along), Vec2(along < 0 ? -1 : 1, 0)};
  }
  MiddleArrival best;
  for (const int side : {h, t}) {
    const MiddleRecords* records = side < 0 ? nullptr : middles_.find(faceOf(side));
    if (records == nullptr) continue;
    const MiddleRecord& record = records->edge[cornerOf(side)];
    if (!(record.distance < best.distance)) continue;
    const Vec2 toSource = Vec2(record.sourceX - middle, -record.depth).normalized();
    best = {record.distance, side == h ? toSource : Vec2(-toSource)};
  }
  // Or along the edge, from a vertex that paths turn round.
  for (const int end : {h, t}) {
    if (end < 0) continue;
    const double distance = (this->distance(mesh_.tail(end)) + middle) * (1 + kBentPenalty);
    if (distance < best.distance) best = {distance, Vec2(end == h ? -1 : 1, 0)};
  }
  return best;
}

void ExactDistance::keepSourceBeam(int face, const SurfacePoint& source) {
  Beam beam;
  beam.face = face;
  beam.source = pointInFace(geometry_, source);
  beam.isFull = true;
  beams_.push_back(beam);
}

/// Of the batch that is carried across the face of half-edge h, if the face may have points so far.
/// A beam may matter that has none: where it undercuts another.
void ExactDistance::keepWindowBeams(int h) {
  const double tail = vertices_.touch(mesh_.tail(h)).arrival.distance;
  const double diameter = std::max(
      {geometry_.edgeLength[h], geometry_.edgeLength[next(h)], geometry_.edgeLength[previous(h)]});
  if (tail + diameter < beamDistance_) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  const Vec2 origin = cornerInFace(geometry_, faceOf(h), cornerOf(h));
  for (const Window& window : batch_) {
    if (leastDistance(window) > beamDistance_) continue;
    const Vec2 source(window.sourceX, -window.depth);
    const Vec2 toEnd = Vec2(window.end, 0) - source;
    const Vec2 toBegin = Vec2(window.begin, 0) - source;
    beams_.push_back({faceOf(h), origin + rotate(along, source), window.offset,
                      rotate(along, toEnd.normalized()), rotate(along, toBegin.normalized()),
                      false});
  }
}

/// Of the wedge behind a vertex in the corner of half-edge h; angles are measured from h.
void ExactDistance::keepCornerBeam(int vertex, int h, double from, double to) {
  const double offset = vertices_.touch(vertex).arrival.distance;
  const double longest = std::max(geometry_.edgeLength[h], geometry_.edgeLength[previous(h)]);
  if (offset > beamDistance_ || offset + longest < beamDistance_) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  beams_.push_back({faceOf(h), cornerInFace(geometry_, faceOf(h), cornerOf(h)), offset,
                    rotate(along, unitVector(std::max(from, 0.0))),
                    rotate(along, unitVector(std::min(to, geometry_.cornerAngle[h]))), false});
}

void ExactDistance::setTarget(const SurfacePoint& target) {
  const PointLocation location = locate(mesh_, target);
  if (location.simplex == Simplex::kVertex) {
    throw Error(ErrorCode::kBadArgument, "a target at a vertex: ask for the vertex's distance");
  }
  targetPoint_ = target;
  target_ = {};
  targetFaces_[0] = target.face;
  const int t = location.simplex == Simplex::kEdge ? mesh_.twin[location.halfedge] : -1;
  targetFaces_[1] = t >= 0 ? faceOf(t) : -1;
}

/// The target in the frame of half-edge h of one of its faces.
Vec2 ExactDistance::targetOver(int h) const {
  const SurfacePoint target = inFace(mesh_, targetPoint_, faceOf(h));
  return Vec2(target.bary[cornerOf(next(h))] * geometry_.edgeLength[h], 0) +
         target.bary[cornerOf(previous(h))] * oppositeOverHalfedge(geometry_, h);
}

/// Takes an arrival at the target along `toSource`, in the frame of half-edge h.
void ExactDistance::arriveAtTarget(int h, const Arrival& arrival, const Vec2& toSource) {
  if (!(arrival.distance < target_.arrival.distance * (1 - kImprovement))) return;
  const Vec2 along = halfedgeInFace(geometry_, h) / geometry_.edgeLength[h];
  target_ = {arrival, faceOf(h), rotate(along, toSource.normalized())};
}

void ExactDistance::arriveAtTargetThrough(int h, const Window& window) {
  const Vec2 point = targetOver(h);
  const Vec2 toSource = Vec2(window.sourceX, -window.depth) - point;
  Arrival arrival{window.offset + toSource.norm(), window.offset, window.pseudoSource};
  const double crossing = point.y() > 0 ? crossingTowards(window, point) : point.x();
  const double nearest = std::clamp(crossing, window.begin, window.end);
  if (std::abs(crossing - nearest) <= kSeenTolerance * geometry_.edgeLength[h]) {
    arriveAtTarget(h, arrival, toSource);
  } else {
    const Vec2 toBend = Vec2(nearest, 0) - point;
    arrival.distance = (distanceAt(window, nearest) + toBend.norm()) * (1 + kBentPenalty);
    arriveAtTarget(h, arrival, toBend);
  }
}

}  // namespace karcher

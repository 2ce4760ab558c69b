#include "distance/path_distance.h"

#include <algorithm>
#include <cmath>

#include "distance/window_distance.h"
#include "intrinsic/angles.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// The distance through a window at x on its edge.
double distanceThrough(const Window& window, bool isFront, double x) {
  return isFront ? window.offset + window.sourceX * x : distanceAt(window, x);
}

Vec2 wayThrough(const Window& window, bool isFront, double x) {
  return isFront ? Vec2(window.sourceX, window.depth) : Vec2(x - window.sourceX, window.depth);
}

/// Removes the part of a front's window where paths over an end of its edge are shorter. `length`
/// is the length of the edge. Returns false if nothing remains.
bool trimFront(Window& window, double tailDistance, double headDistance, double length) {
  const double slope = window.sourceX;
  const double tail = beatingLength(tailDistance);
  if (window.offset > tail && slope < 1) {
    window.begin = std::max(window.begin, (window.offset - tail) / (1 - slope));
  }
  const double head = beatingLength(headDistance) + length;
  if (window.offset + slope * length > head - length && slope > -1) {
    window.end = std::min(window.end, (head - window.offset) / (1 + slope));
  }
  return window.begin < window.end;
}

}  // namespace

PathDistance::PathDistance(const Geometry& geometry, std::span<const SurfacePath> paths,
                           double limit, std::span<const double> widths)
    : geometry_(geometry),
      mesh_(*geometry.mesh),
      limit_(limit),
      widths_(widths),
      arrivals_(static_cast<size_t>(geometry.mesh->vertexCount())) {
  for (const SurfacePath& path : paths) markVertices(path);
  for (size_t i = 0; i < paths.size(); ++i) leavePath(bentPath(paths[i], static_cast<int>(i)));
  run();
  sortImages();
  widths_ = {};
}

void PathDistance::arrive(int vertex, double distance, double back, SideOfPath side) {
  VertexArrival& arrival = arrivals_[vertex];
  if (!(distance < arrival.distance)) return;
  arrival = {distance, back, side, false};
  if (distance > limit_ || !spreadsPaths(geometry_, vertex)) return;
  Waiting waiting;
  waiting.key = distance;
  waiting.number = ++count_;
  waiting.vertex = vertex;
  queue_.push(waiting);
}

void PathDistance::addWindow(int h, const Window& given, bool isFront, SideOfPath side) {
  Window window = given;
  const double length = geometry_.edgeLength[h];
  window.begin = std::max(window.begin, 0.0);
  window.end = std::min(window.end, length);
  const double tail = arrivals_[mesh_.tail(h)].distance;
  const double head = arrivals_[mesh_.head(h)].distance;
  const bool isLeft = isFront ? trimFront(window, tail, head, length)
                              : trimByTail(window, tail) && trimByHead(window, head, length);
  // If the center of a fan is nearer to the edge than the edge is long, a narrow window may hold
  // wide angles.
  const double leg = isFront ? length : leastDistance(window) - window.offset;
  const double narrowest =
      std::max(kStepRounding * length, kNarrowestWindow * std::min(length, leg));
  if (!isLeft || isTooNarrow(window, narrowest)) return;
  Waiting waiting;
  waiting.key = isFront ? std::min(distanceThrough(window, true, window.begin),
                                   distanceThrough(window, true, window.end))
                        : leastDistance(window);
  if (waiting.key > limit_) return;
  waiting.number = ++count_;
  waiting.halfedge = h;
  waiting.isFront = isFront;
  waiting.side = side;
  waiting.window = window;
  queue_.push(waiting);
}

void PathDistance::carryAcross(const Waiting& waiting) {
  const int h = waiting.halfedge;
  const int face = faceOf(h);
  const Window& window = waiting.window;
  const double length = geometry_.edgeLength[h];
  const Vec2 along = halfedgeInFace(geometry_, h) / length;
  const Vec2 origin = cornerInFace(geometry_, face, cornerOf(h));
  Image image;
  image.face = face;
  image.side = waiting.side;
  image.least = waiting.key;
  const Vec2 source =
      waiting.isFront ? Vec2(window.sourceX, window.depth) : Vec2(window.sourceX, -window.depth);
  if (waiting.isFront) {
    image.isFront = true;
    image.source = rotate(along, source);
    image.offset = window.offset - image.source.dot(origin);
    image.right = origin + window.end * along;
    image.left = origin + window.begin * along;
  } else {
    image.source = origin + rotate(along, source);
    image.offset = window.offset;
    image.right = rotate(along, (Vec2(window.end, 0) - source).normalized());
    image.left = rotate(along, (Vec2(window.begin, 0) - source).normalized());
  }
  images_.push_back(image);

  const Vec2 apex = oppositeOverHalfedge(geometry_, h);
  const double crossing = waiting.isFront ? apex.x() - apex.y() * window.sourceX / window.depth
                                          : crossingTowards(window, apex);
  if (crossing >= window.begin - kChainRounding * length &&
      crossing <= window.end + kChainRounding * length) {
    const Vec2 way = waiting.isFront ? source : Vec2(apex - source);
    const double leg = waiting.isFront ? source.dot(apex) : way.norm();
    const double back = geometry_.cumulatedAngle[previous(h)] + angleFromTo(-apex, -way);
    arrive(mesh_.opposite(h), window.offset + leg, back, waiting.side);
  }
  // The window continues to the sides at the tail and at the head.
  for (const bool isHead : {false, true}) {
    const int t = mesh_.twin[isHead ? next(h) : previous(h)];
    if (t < 0) continue;
    if (isHead ? window.end <= crossing : window.begin >= crossing) continue;
    const Vec2 from = isHead ? apex : Vec2(0, 0);
    const Vec2 to = isHead ? Vec2(length, 0) : apex;
    const double side = geometry_.edgeLength[t];
    const Vec2 axis = (to - from) / side;
    const auto hit = [&](double x) {
      const Vec2 way = wayThrough(window, waiting.isFront, x);
      const double across = cross(axis, way);
      return across > 0 ? std::clamp(cross(Vec2(x, 0) - from, way) / across, 0.0, side) : side;
    };
    Window carried = window;
    if (isHead) {
      carried.begin = window.begin <= crossing ? 0 : hit(window.begin);
      carried.end = hit(window.end);
    } else {
      carried.begin = hit(window.begin);
      carried.end = window.end >= crossing ? side : hit(window.end);
    }
    const Vec2 seen = rotateBack(axis, waiting.isFront ? source : Vec2(source - from));
    carried.sourceX = seen.x();
    carried.depth = waiting.isFront ? seen.y() : std::max(0.0, -seen.y());
    if (waiting.isFront && !(seen.y() > 0)) continue;
    if (waiting.isFront) carried.offset = window.offset + source.dot(from);
    // Paths over the other end of the crossed edge may be shorter than all paths of the window. If
    // so, the window ends here.
    const double far = arrivals_[isHead ? mesh_.tail(h) : mesh_.head(h)].distance;
    const Vec2 farPlace = isHead ? Vec2(0, 0) : Vec2(length, 0);
    const double farEnd = isHead ? carried.end : carried.begin;
    const Vec2 farHit = from + farEnd * axis;
    if (beatingLength(far) + (farHit - farPlace).norm() <
        distanceThrough(carried, waiting.isFront, farEnd)) {
      continue;
    }
    addWindow(t, carried, waiting.isFront, waiting.side);
  }
}

void PathDistance::run() {
  const int64_t most = static_cast<int64_t>(kMostWindowsPerFace) * mesh_.faceCount();
  for (int64_t steps = 0; !queue_.empty(); ++steps) {
    if (steps >= most) {
      throw Error(ErrorCode::kBadArgument,
                  "the distances from a path take more than 10,000 windows a face");
    }
    const Waiting waiting = queue_.top();
    queue_.pop();
    if (waiting.halfedge >= 0) {
      carryAcross(waiting);
    } else if (arrivals_[waiting.vertex].distance == waiting.key) {
      leaveVertex(waiting.vertex);
    }
  }
}

void PathDistance::sortImages() {
  Array<Image> sorted;
  for (const int i : sortedNumbers(images_.count(), [&](int a, int b) {
         return images_[a].face != images_[b].face ? images_[a].face < images_[b].face : a < b;
       })) {
    if (faces_.empty() || faces_.back() != images_[i].face) {
      faces_.push_back(images_[i].face);
      firstOfFace_.push_back(sorted.count());
    }
    sorted.push_back(images_[i]);
  }
  firstOfFace_.push_back(sorted.count());
  images_ = std::move(sorted);
}

PathDistance::Distance PathDistance::at(int face, const Vec2& place) const {
  Distance best;
  const auto offer = [&](double value, SideOfPath side) {
    if (value < best.value) best = {value, side};
  };
  for (int k = 0; k < 3; ++k) {
    const VertexArrival& arrival = arrivals_[mesh_.corner(face, k)];
    if (arrival.isOnPath) continue;
    offer(arrival.distance + (place - cornerInFace(geometry_, face, k)).norm(), arrival.side);
  }
  const auto found = std::lower_bound(faces_.begin(), faces_.end(), face);
  if (found == faces_.end() || *found != face) return best;
  const auto number = static_cast<int>(found - faces_.begin());
  const double gap = kChainRounding * geometry_.meanEdge;
  for (int i = firstOfFace_[number]; i < firstOfFace_[number + 1]; ++i) {
    const Image& image = images_[i];
    // The region behind an image's line does not belong to the image.
    const auto offerBeyond = [&](double value) {
      if (value >= image.least - gap) offer(std::max(value, image.least), image.side);
    };
    if (image.isFront) {
      const Vec2& forward = image.source;
      const Vec2 line = image.left - image.right;
      const Vec2 fromRight = place - image.right;
      if (cross(forward, fromRight) < -gap || cross(forward, place - image.left) > gap ||
          cross(line, fromRight) > gap * line.norm()) {
        continue;
      }
      offerBeyond(image.offset + forward.dot(place));
    } else {
      const Vec2 way = place - image.source;
      const double leg = way.norm();
      const double slack = kChainRounding * leg;
      if (cross(image.right, way) < -slack || cross(way, image.left) < -slack ||
          (image.right + image.left).dot(way) < -slack) {
        continue;
      }
      offerBeyond(image.offset + leg);
    }
  }
  return best;
}

PathDistance::Distance PathDistance::at(const SurfacePoint& point) const {
  Distance best;
  for (const PointFan::Corner& corner : fanAt(geometry_, point).corners) {
    const Distance here = at(corner.face, corner.middle);
    if (here.value < best.value) best = here;
  }
  return best;
}

Array<double> distancesFromPaths(const Geometry& geometry, std::span<const SurfacePath> paths,
                                 std::span<const SurfacePoint> points) {
  Array<double> distances(points.size(), kInfinity);
  bool isOpen = true;
  for (double limit = 2 * geometry.meanEdge; isOpen; limit *= 2) {
    if (limit > geometry.diagonal) limit = kInfinity;
    const PathDistance field(geometry, paths, limit);
    isOpen = false;
    for (int i = 0; i < distances.count(); ++i) {
      if (distances[i] < kInfinity) continue;
      const double distance = field.at(points[static_cast<size_t>(i)]).value;
      // A distance beyond the limit may not be the least.
      if (distance <= limit) {
        distances[i] = distance;
      } else {
        isOpen = true;
      }
    }
  }
  return distances;
}

}  // namespace karcher

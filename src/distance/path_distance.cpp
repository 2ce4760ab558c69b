#include "distance/path_distance.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "distance/window_distance.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sorted_numbers.h"

namespace karcher {
namespace {

/// Heights over an edge below this part of the face's height count as 0.
constexpr double kNoHeight = 1e-13;

Vec2 leftOf(const Vec2& v) { return {-v.y(), v.x()}; }

double angleFromTo(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

/// The distance through a window at x on its edge.
double distanceThrough(const Window& window, bool isFront, double x) {
  return isFront ? window.offset + window.sourceX * x : distanceAt(window, x);
}

Vec2 wayThrough(const Window& window, bool isFront, double x) {
  return isFront ? Vec2(window.sourceX, window.depth) : Vec2(x - window.sourceX, window.depth);
}

/// Trims what the paths over the ends of an edge of this length beat. Returns false if nothing is
/// left.
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
                           double limit)
    : geometry_(geometry),
      mesh_(*geometry.mesh),
      limit_(limit),
      arrivals_(static_cast<size_t>(geometry.mesh->vertexCount())) {
  for (const SurfacePath& path : paths) {
    for (const SurfacePoint& point : path.points) {
      const PointLocation location = locate(mesh_, point);
      if (location.simplex == Simplex::kVertex) {
        arrivals_[location.vertex] = {0, 0, SideOfPath::kEnd, true};
      }
    }
  }
  for (size_t i = 0; i < paths.size(); ++i) leavePath(paths[i], static_cast<int>(i));
  run();
  sortImages();
}

void PathDistance::leavePath(const SurfacePath& path, int number) {
  const auto refusePath = [&](const std::string& why) {
    throw Error(ErrorCode::kBadArgument, "path " + std::to_string(number) + " " + why);
  };
  Array<SurfacePoint> points;
  for (int i = 0; i < path.points.count(); ++i) {
    const SurfacePoint& point = path.points[i];
    if (i > 0 && commonFace(mesh_, path.points[i - 1], point) < 0) {
      refusePath("has points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                 " that have no face in common");
    }
    const double least = kLocalRounding * geometry_.meanEdge;
    if (points.empty() ||
        (position(mesh_, points.back()) - position(mesh_, point)).norm() > least ||
        commonFace(mesh_, points.back(), point) < 0) {
      points.push_back(point);
    }
  }
  const int count = points.count();
  if (count < 2) refusePath("has no length");
  const bool isClosed = samePlace(mesh_, points.front(), points.back());
  for (int i = 0; i + 1 < count; ++i) {
    const int face = commonFace(mesh_, points[i], points[i + 1]);
    const SurfacePoint a = inFace(mesh_, points[i], face);
    const SurfacePoint b = inFace(mesh_, points[i + 1], face);
    leavePiece(face, pointInFace(geometry_, a), pointInFace(geometry_, b));
    for (int k = 0; k < 3; ++k) {
      if (a.bary[k] != 0 || b.bary[k] != 0) continue;
      const int other = mesh_.twin[next(3 * face + k)];
      if (other < 0) continue;
      const int across = faceOf(other);
      leavePiece(across, pointInFace(geometry_, inFace(mesh_, a, across)),
                 pointInFace(geometry_, inFace(mesh_, b, across)));
    }
  }
  for (int i = 0; i < count; ++i) {
    if (isClosed && i == count - 1) break;
    const SurfacePoint* before = i > 0 ? &points[i - 1] : isClosed ? &points[count - 2] : nullptr;
    const SurfacePoint* after = i + 1 < count ? &points[i + 1] : nullptr;
    leaveTurn(points[i], before, after);
  }
}

/// Starts from a straight piece in a face: adds its image there, and sends a front to both sides.
void PathDistance::leavePiece(int face, const Vec2& from, const Vec2& to) {
  if (!((to - from).norm() > 0)) return;
  Image image;
  image.face = face;
  image.kind = Image::kPiece;
  image.source = from;
  image.end = to;
  images_.push_back(image);
  leaveFront(face, from, to, SideOfPath::kLeft);
  leaveFront(face, from, to, SideOfPath::kRight);
}

void PathDistance::leaveFront(int face, const Vec2& from, const Vec2& to, SideOfPath side) {
  const double width = (to - from).norm();
  const Vec2 along = (to - from) / width;
  const Vec2 way = (side == SideOfPath::kLeft ? 1.0 : -1.0) * leftOf(along);
  const double noHeight = kLocalRounding * geometry_.meanEdge;
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const double length = geometry_.edgeLength[h];
    const Vec2 tail = cornerInFace(geometry_, face, k);
    const Vec2 edge = halfedgeInFace(geometry_, h) / length;
    const double tailHeight = way.dot(tail - from);
    const double foot = along.dot(tail - from);
    if (tailHeight > noHeight && foot >= -kChainRounding * width &&
        foot <= (1 + kChainRounding) * width) {
      arrive(mesh_.tail(h), tailHeight, directionAtTail(geometry_, h, -way), side);
    }
    // The part of the edge over the piece.
    const double out = way.x() * edge.y() - way.y() * edge.x();
    const int t = mesh_.twin[h];
    if (t < 0 || !(out > 0)) continue;
    double begin = 0;
    double end = length;
    const auto keepWhere = [&](double atTail, double slope) {
      // atTail + slope x >= 0
      if (slope > 0) begin = std::max(begin, -atTail / slope);
      if (slope < 0) end = std::min(end, -atTail / slope);
      if (slope == 0 && atTail < 0) end = begin;
    };
    keepWhere(foot, along.dot(edge));
    keepWhere(width - foot, -along.dot(edge));
    keepWhere(tailHeight, way.dot(edge));
    if (isTooNarrow({begin, end}, kNarrowestWindow * length)) continue;
    if (!(tailHeight + way.dot(edge) * (begin + end) / 2 > noHeight)) continue;
    const double offset = tailHeight + way.dot(edge) * length;
    addWindow(t, {length - end, length - begin, -way.dot(edge), out, offset}, true, side);
  }
}

/// The angles around a point.
PathDistance::Fan PathDistance::fanOf(const SurfacePoint& point) const {
  Fan fan;
  const PointLocation location = locate(mesh_, point);
  const auto add = [&](int face, double begin, double width, double inFrame) {
    const Vec2 middle = pointInFace(geometry_, inFace(mesh_, point, face));
    fan.corners.push_back({face, begin, begin + width, inFrame, middle});
    fan.total = begin + width;
  };
  if (location.simplex == Simplex::kFace) {
    add(point.face, 0, 2 * kPi, 0);
  } else if (location.simplex == Simplex::kEdge) {
    const int h = location.halfedge;
    add(faceOf(h), 0, kPi, angleOf(halfedgeInFace(geometry_, h)));
    const int t = mesh_.twin[h];
    if (t >= 0) add(faceOf(t), kPi, kPi, angleOf(halfedgeInFace(geometry_, t)));
    fan.isRound = t >= 0;
  } else {
    for (const int h : outgoingHalfedges(mesh_, location.vertex)) {
      add(faceOf(h), geometry_.cumulatedAngle[h], geometry_.cornerAngle[h],
          angleOf(halfedgeInFace(geometry_, h)));
    }
    fan.isRound = !mesh_.onBoundary[location.vertex];
  }
  return fan;
}

/// The direction in a fan of a point that shares a face with the fan's center.
double PathDistance::directionIn(const Fan& fan, const SurfacePoint& point,
                                 const SurfacePoint& towards) const {
  const int face = commonFace(mesh_, point, towards);
  for (const Corner& corner : fan.corners) {
    if (corner.face != face) continue;
    const Vec2 way = pointInFace(geometry_, inFace(mesh_, towards, face)) - corner.middle;
    const double width = corner.end - corner.begin;
    double angle = std::remainder(angleOf(way) - corner.inFrame - width / 2, 2 * kPi);
    angle += width / 2;
    return corner.begin + angle;
  }
  throw Error(ErrorCode::kBadArgument, "a path has a point in no face");
}

/// Starts from a point where a path turns or ends, with the fans between the right angles to its
/// pieces there.
void PathDistance::leaveTurn(const SurfacePoint& point, const SurfacePoint* before,
                             const SurfacePoint* after) {
  const Fan fan = fanOf(point);
  const double right = kPi / 2;
  // Adjacent windows of one front are off each other by rounding. The windows beside such a gap
  // find paths through it, with an error of second order.
  const auto leave = [&](double from, double to, SideOfPath side) {
    if (to - from > kChainRounding) leaveFan(fan, from, to, 0, side);
  };
  // Counterclockwise from one direction to another, on the surface.
  const auto leaveBetween = [&](double from, double to, SideOfPath side) {
    if (to > from) {
      leave(from + right, to - right, side);
    } else if (fan.isRound) {
      leave(from + right, to + fan.total - right, side);
    } else {
      leave(from + right, kInfinity, side);
      leave(-kInfinity, to - right, side);
    }
  };
  if (before != nullptr && after != nullptr) {
    const double back = directionIn(fan, point, *before);
    const double ahead = directionIn(fan, point, *after);
    leaveBetween(ahead, back, SideOfPath::kLeft);
    leaveBetween(back, ahead, SideOfPath::kRight);
    return;
  }
  const double only = directionIn(fan, point, after != nullptr ? *after : *before);
  if (fan.isRound) {
    leave(only + right, only + fan.total - right, SideOfPath::kEnd);
    return;
  }
  // On the boundary both sides are known.
  leave(only + right, kInfinity, after != nullptr ? SideOfPath::kLeft : SideOfPath::kRight);
  leave(-kInfinity, only - right, after != nullptr ? SideOfPath::kRight : SideOfPath::kLeft);
}

void PathDistance::leaveFan(const Fan& fan, double from, double to, double offset,
                            SideOfPath side) {
  for (const Corner& corner : fan.corners) {
    for (const int turn : {-1, 0, 1}) {
      if (turn != 0 && !fan.isRound) continue;
      const double begin = std::max(from + turn * fan.total, corner.begin);
      const double end = std::min(to + turn * fan.total, corner.end);
      if (!(end >= begin)) continue;
      leaveCorner(corner.face, corner.middle, corner.inFrame + begin - corner.begin,
                  corner.inFrame + end - corner.begin, offset, side);
    }
  }
}

/// Starts from a point of a face, in the directions between two angles of its frame.
void PathDistance::leaveCorner(int face, const Vec2& middle, double from, double to, double offset,
                               SideOfPath side) {
  // Each part of a fan is narrower than half a turn.
  const int parts = std::max(1, static_cast<int>(std::ceil((to - from) / (kPi / 2))));
  for (int part = 0; part < parts; ++part) {
    const double begin = from + (to - from) * part / parts;
    const double end = from + (to - from) * (part + 1) / parts;
    Image image;
    image.face = face;
    image.side = side;
    image.offset = offset;
    image.least = offset;
    image.source = middle;
    image.right = unitVector(begin);
    image.left = unitVector(end);
    images_.push_back(image);
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * face + k;
      const double length = geometry_.edgeLength[h];
      const Vec2 toTail = cornerInFace(geometry_, face, k) - middle;
      if (!(toTail.norm() > kLocalRounding * length)) continue;
      const Vec2 edge = halfedgeInFace(geometry_, h) / length;
      const double width = angleFromTo(toTail, toTail + length * edge);
      const double near = (begin + end) / 2;
      const double tailAngle = near + std::remainder(angleOf(toTail) - near, 2 * kPi);
      if (tailAngle >= begin - kChainRounding && tailAngle <= end + kChainRounding) {
        arrive(mesh_.tail(h), offset + toTail.norm(), directionAtTail(geometry_, h, -toTail), side);
      }
      const double height = cross(toTail, edge);
      const int t = mesh_.twin[h];
      if (t < 0 || !(height > kNoHeight * doubleArea(geometry_, face) / length)) continue;
      const double start =
          near + std::remainder(angleOf(toTail) + width / 2 - near, 2 * kPi) - width / 2;
      const double foot = -toTail.dot(edge);
      const double down = std::atan2(foot, height);  // from the tail to the foot of the height
      const auto hit = [&](double angle) { return foot + height * std::tan(angle - start - down); };
      const double first = begin > start ? hit(begin) : 0;
      const double last = end < start + width ? hit(end) : length;
      if (begin >= start + width || end <= start) continue;
      addWindow(t, {length - last, length - first, length - foot, height, offset}, false, side);
    }
  }
}

void PathDistance::leaveVertex(int vertex) {
  const VertexArrival arrival = arrivals_[vertex];
  const Fan fan = fanOf(vertexPoint(mesh_, vertex));
  const double from = arrival.back + kPi - kChainRounding;
  if (fan.isRound) {
    leaveFan(fan, from, arrival.back + fan.total - kPi + kChainRounding, arrival.distance,
             arrival.side);
  } else {
    leaveFan(fan, from, kInfinity, arrival.distance, arrival.side);
    leaveFan(fan, -kInfinity, arrival.back - kPi + kChainRounding, arrival.distance, arrival.side);
  }
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
  if (!isLeft || isTooNarrow(window, kNarrowestWindow * length)) return;
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
    image.kind = Image::kFront;
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
  // Over the tail's side, and over the head's.
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
    // Drops the window if the vertex at the other end of the edge that it came through beats all of
    // it.
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
    const Vec2 way = place - image.source;
    // The region behind an edge along the image's border is no part of it.
    const auto offerBeyond = [&](double value) {
      if (value >= image.least - gap) offer(value, image.side);
    };
    if (image.kind == Image::kPiece) {
      const Vec2 along = image.end - image.source;
      const double part = way.dot(along) / along.squaredNorm();
      // A point nearest to an end belongs to the fan there.
      if (part < -kChainRounding || part > 1 + kChainRounding) continue;
      offer((way - part * along).norm(),
            cross(along, way) >= 0 ? SideOfPath::kLeft : SideOfPath::kRight);
    } else if (image.kind == Image::kFront) {
      const Vec2& forward = image.source;
      if (cross(forward, place - image.right) < -gap || cross(forward, place - image.left) > gap) {
        continue;
      }
      offerBeyond(image.offset + forward.dot(place));
    } else {
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
  for (const Corner& corner : fanOf(point).corners) {
    const Distance here = at(corner.face, corner.middle);
    if (here.value < best.value) best = here;
  }
  return best;
}

}  // namespace karcher

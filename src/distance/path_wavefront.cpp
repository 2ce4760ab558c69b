#include <algorithm>
#include <cmath>
#include <string>

#include "distance/path_distance.h"
#include "intrinsic/angles.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"
#include "mesh/rounding.h"

/// The wavefront that leaves paths: straight fronts from their pieces, fans where they turn or end,
/// and fans from vertices at which shortest connections turn.
namespace karcher {
namespace {

Vec2 leftOf(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace

Array<SurfacePoint> pointsApart(const Geometry& geometry, const SurfacePath& path, int number) {
  const TriangleMesh& mesh = *geometry.mesh;
  const Array<SurfacePoint>& points = path.points;
  const auto refusePath = [&](const std::string& why) {
    throw Error(ErrorCode::kBadArgument, "path " + std::to_string(number) + " " + why);
  };
  Array<SurfacePoint> apart;
  for (int i = 0; i < points.count(); ++i) {
    if (i > 0 && !haveCommonFace(mesh, points[i - 1], points[i])) {
      refusePath("has points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                 " that have no face in common");
    }
    // If the last kept point shares no face with this one, the path needs the omitted point between
    // them.
    if (i > 0 && !haveCommonFace(mesh, apart.back(), points[i])) apart.push_back(points[i - 1]);
    if (apart.empty() || (position(mesh, apart.back()) - position(mesh, points[i])).norm() >
                             kLocalRounding * geometry.meanEdge) {
      apart.push_back(points[i]);
    } else if (apart.count() > 1 && i + 1 == points.count()) {
      // The last point itself stays, so that a closed path stays closed.
      if (haveCommonFace(mesh, apart[apart.count() - 2], points[i])) apart.pop_back();
      apart.push_back(points[i]);
    }
  }
  if (apart.count() < 2) refusePath("has no length");
  return apart;
}

/// The number of parts of a path along which the width is linear; 0 for fewer than two widths.
int PathDistance::partsOf(const SurfacePath& path) const {
  const int count = static_cast<int>(widths_.size());
  if (count < 2) return 0;
  return samePlace(mesh_, path.points.front(), path.points.back()) ? count : count - 1;
}

/// The distance with which fronts start at a place of a path: the greatest width minus the width at
/// this place, or 0 without widths or without a length of the path. `length` is the length of the
/// path up to the place.
double PathDistance::startAt(const SurfacePath& path, double length) const {
  const int parts = partsOf(path);
  if (parts == 0 || !(path.length() > 0)) return 0;
  const double at = std::min(length / path.length(), 1.0) * parts;
  const int k = std::min(static_cast<int>(at), parts - 1);
  const double from = widths_[static_cast<size_t>(k)];
  const double to = widths_[static_cast<size_t>(k + 1) % widths_.size()];
  return *std::max_element(widths_.begin(), widths_.end()) - from - (to - from) * (at - k);
}

/// The rate at which `startAt` grows along the piece after a point.
double PathDistance::growthAfter(const SurfacePath& path, int index) const {
  const double from = path.lengths[index];
  const double to = path.lengths[index + 1];
  return (startAt(path, to) - startAt(path, from)) / (to - from);
}

/// The path with additional points where the slope of the width changes.
SurfacePath PathDistance::bentPath(const SurfacePath& path, int number) const {
  SurfacePath bent = pathThrough(mesh_, pointsApart(geometry_, path, number));
  const int parts = partsOf(bent);
  if (parts < 2) return bent;
  const double part = bent.length() / parts;
  SurfacePath joined;
  for (int k = 0; k < parts; ++k) appendPart(mesh_, bent, k * part, (k + 1) * part, joined);
  joined.points.back() = bent.points.back();
  return pathThrough(mesh_, pointsApart(geometry_, joined, number));
}

/// Sets the distances of the vertices on a path.
void PathDistance::markVertices(const SurfacePath& given) {
  if (given.points.empty()) return;
  SurfacePath path = given;
  measure(mesh_, path);
  for (int i = 0; i < path.points.count(); ++i) {
    const PointLocation location = locate(mesh_, path.points[i]);
    if (location.simplex != Simplex::kVertex) continue;
    VertexArrival& arrival = arrivals_[location.vertex];
    arrival.distance = std::min(arrival.distance, startAt(path, path.lengths[i]));
    arrival.isOnPath = true;
  }
}

/// Sends out the fronts of all straight pieces and the fans of all turns.
void PathDistance::leavePath(const SurfacePath& path) {
  const Array<SurfacePoint>& points = path.points;
  for (int i = 0; i + 1 < points.count(); ++i) {
    const int face = commonFace(mesh_, points[i], points[i + 1]);
    const SurfacePoint a = inFace(mesh_, points[i], face);
    const SurfacePoint b = inFace(mesh_, points[i + 1], face);
    const double start = startAt(path, path.lengths[i]);
    const double growth = growthAfter(path, i);
    // The loop visits the piece's face and, if the piece lies on an edge, also the face beyond the
    // edge.
    for (int k = -1; k < 3; ++k) {
      if (k >= 0 && (a.bary[k] != 0 || b.bary[k] != 0)) continue;
      const int other = k < 0 ? 3 * face : mesh_.twin[next(3 * face + k)];
      if (other < 0 || !(std::abs(growth) < 1)) continue;
      const Vec2 from = pointInFace(geometry_, inFace(mesh_, a, faceOf(other)));
      const Vec2 to = pointInFace(geometry_, inFace(mesh_, b, faceOf(other)));
      if (!((to - from).norm() > 0)) continue;
      for (const SideOfPath side : {SideOfPath::kLeft, SideOfPath::kRight}) {
        leaveFront(faceOf(other), from, to, start, growth, side);
      }
    }
    leaveTurn(path, i);
  }
  if (!samePlace(mesh_, points.front(), points.back())) leaveTurn(path, points.count() - 1);
}

/// Sends out a front to one side of a straight piece in a face, and adds the front's image in this
/// face.
void PathDistance::leaveFront(int face, const Vec2& from, const Vec2& to, double start,
                              double growth, SideOfPath side) {
  const double noHeight = kLocalRounding * geometry_.meanEdge;
  const bool isLeft = side == SideOfPath::kLeft;
  const Vec2 along = (to - from).normalized();
  const Vec2 aside = (isLeft ? 1.0 : -1.0) * leftOf(along);
  const double rise = std::sqrt((1 - growth) * (1 + growth));
  const Vec2 way = growth * along + rise * aside;
  // This unit vector is perpendicular to `way`, on the side towards which the piece leads.
  const Vec2 across = rise * along - growth * aside;
  const double width = across.dot(to - from);
  Image image;
  image.face = face;
  image.isFront = true;
  image.side = side;
  image.offset = start - way.dot(from);
  image.least = std::min(start, image.offset + way.dot(to));
  image.source = way;
  image.right = isLeft ? to : from;
  image.left = isLeft ? from : to;
  images_.push_back(image);
  for (int k = 0; k < 3; ++k) {
    const int h = 3 * face + k;
    const double length = geometry_.edgeLength[h];
    const Vec2 tail = cornerInFace(geometry_, face, k);
    const Vec2 edge = halfedgeInFace(geometry_, h) / length;
    const double tailHeight = aside.dot(tail - from);
    const double atTail = start + way.dot(tail - from);
    const double foot = across.dot(tail - from);
    if (tailHeight > noHeight && foot >= -kChainRounding * width &&
        foot <= (1 + kChainRounding) * width) {
      arrive(mesh_.tail(h), atTail, directionAtTail(geometry_, h, -way), side);
    }
    // The following finds the part of the edge that the front reaches.
    const double out = way.x() * edge.y() - way.y() * edge.x();
    const int t = mesh_.twin[h];
    if (t < 0 || !(out > 0)) continue;
    double begin = 0;
    double end = length;
    const auto keepWhere = [&](double here, double slope) {
      // This solves here + slope x >= 0 for x.
      if (slope > 0) begin = std::max(begin, -here / slope);
      if (slope < 0) end = std::min(end, -here / slope);
      if (slope == 0 && here < 0) end = begin;
    };
    keepWhere(foot, across.dot(edge));
    keepWhere(width - foot, -across.dot(edge));
    keepWhere(tailHeight, aside.dot(edge));
    if (isTooNarrow({begin, end}, kNarrowestWindow * length)) continue;
    if (!(tailHeight + aside.dot(edge) * (begin + end) / 2 > noHeight)) continue;
    const double slope = way.dot(edge);
    addWindow(t, {length - end, length - begin, -slope, out, atTail + slope * length}, true, side);
  }
}

/// Sends out the fans of a point where a path turns or ends. A fan has the directions between the
/// fronts of the path's pieces there.
void PathDistance::leaveTurn(const SurfacePath& path, int index) {
  struct Piece {
    double angle = 0;    ///< the piece's direction
    double opening = 0;  ///< the angle between the piece and its fronts
  };
  const Array<SurfacePoint>& points = path.points;
  const int last = points.count() - 1;
  const PointFan fan = fanAt(geometry_, points[index]);
  const double start = startAt(path, path.lengths[index]);
  const bool hasAhead = index < last;
  const bool hasBack = index > 0 || samePlace(mesh_, points[0], points[last]);
  Piece ahead;
  Piece back;
  for (const bool isAhead : {true, false}) {
    if (!(isAhead ? hasAhead : hasBack)) continue;
    const int piece = isAhead ? index : (index > 0 ? index : last) - 1;
    const double rate = growthAfter(path, piece) * (isAhead ? 1 : -1);
    const double growth = std::abs(rate) < 1 ? rate : std::copysign(1, rate);
    const SurfacePoint& other = points[isAhead ? piece + 1 : piece];
    (isAhead ? ahead : back) =
        Piece{angleTowards(geometry_, fan, points[index], other), std::acos(growth)};
  }
  if (!hasAhead) ahead = back;
  if (!hasBack) back = ahead;
  // Rounding leaves gaps between adjacent windows of one front. The windows beside a gap find paths
  // through it, with an error of second order.
  const auto leave = [&](double from, double to, SideOfPath side) {
    if (to - from > kChainRounding) leaveFan(fan, from, to, start, side);
  };
  // The fan covers the directions counterclockwise from one piece to another. At a point of the
  // boundary, the boundary may divide the fan into two parts. If a path ends there, the first part
  // lies on one side of the path and the second part on the other side.
  const auto leaveBetween = [&](const Piece& one, const Piece& other, SideOfPath side,
                                SideOfPath second) {
    const double from = one.angle + one.opening;
    const double to = other.angle - other.opening;
    if (other.angle > one.angle) {
      leave(from, to, side);
    } else if (fan.isRound) {
      leave(from, to + fan.total, side);
    } else {
      leave(from, kInfinity, side);
      leave(-kInfinity, to, second);
    }
  };
  if (hasAhead && hasBack) {
    leaveBetween(ahead, back, SideOfPath::kLeft, SideOfPath::kLeft);
    leaveBetween(back, ahead, SideOfPath::kRight, SideOfPath::kRight);
    return;
  }
  const SideOfPath first = hasAhead ? SideOfPath::kLeft : SideOfPath::kRight;
  const SideOfPath second = hasAhead ? SideOfPath::kRight : SideOfPath::kLeft;
  leaveBetween(ahead, back, fan.isRound ? SideOfPath::kEnd : first, second);
}

void PathDistance::leaveFan(const PointFan& fan, double from, double to, double offset,
                            SideOfPath side) {
  for (const PointFan::Corner& corner : fan.corners) {
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

/// Sends out the part of a fan in one face. It starts at the point `middle` and has the directions
/// between the angles `from` and `to`, in the face's frame.
void PathDistance::leaveCorner(int face, const Vec2& middle, double from, double to, double offset,
                               SideOfPath side) {
  // The sector of an image must be narrower than half a turn, so a wide fan is divided.
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
      const double tailAngle = near + withoutTurns(angleOf(toTail) - near);
      if (tailAngle >= begin - kChainRounding && tailAngle <= end + kChainRounding) {
        arrive(mesh_.tail(h), offset + toTail.norm(), directionAtTail(geometry_, h, -toTail), side);
      }
      const double height = cross(toTail, edge);
      const int t = mesh_.twin[h];
      if (t < 0 || !(height > kLocalRounding * doubleArea(geometry_, face) / length)) continue;
      const double start = near + withoutTurns(angleOf(toTail) + width / 2 - near) - width / 2;
      const double foot = -toTail.dot(edge);
      // the angle from the tail to the foot of the height
      const double down = std::atan2(foot, height);
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
  const PointFan fan = fanAt(geometry_, vertexPoint(mesh_, vertex));
  const double from = arrival.back + kPi - kChainRounding;
  if (fan.isRound) {
    leaveFan(fan, from, arrival.back + fan.total - kPi + kChainRounding, arrival.distance,
             arrival.side);
  } else {
    leaveFan(fan, from, kInfinity, arrival.distance, arrival.side);
    leaveFan(fan, -kInfinity, arrival.back - kPi + kChainRounding, arrival.distance, arrival.side);
  }
}

}  // namespace karcher

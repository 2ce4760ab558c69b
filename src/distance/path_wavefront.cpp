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
    // If the last point kept shares no face with this one, the omitted point between them is
    // needed.
    if (i > 0 && !haveCommonFace(mesh, apart.back(), points[i])) apart.push_back(points[i - 1]);
    if (apart.empty() || (position(mesh, apart.back()) - position(mesh, points[i])).norm() >
                             kLocalRounding * geometry.meanEdge) {
      apart.push_back(points[i]);
    }
  }
  if (apart.count() < 2) refusePath("has no length");
  return apart;
}

void PathDistance::leavePath(const SurfacePath& path, int number) {
  const Array<SurfacePoint> points = pointsApart(geometry_, path, number);
  const int count = points.count();
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

/// Sends out a front from a straight piece in a face to both sides, and adds the piece's image
/// there.
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
    // The part of the edge that lies over the piece.
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

/// Sends out the fans of a point where a path turns or ends: the directions between the
/// perpendiculars to its pieces there.
void PathDistance::leaveTurn(const SurfacePoint& point, const SurfacePoint* before,
                             const SurfacePoint* after) {
  const PointFan fan = fanAt(geometry_, point);
  const double right = kPi / 2;
  // Adjacent windows of one front differ by rounding. The windows beside such a gap find paths
  // through it, with an error of second order.
  const auto leave = [&](double from, double to, SideOfPath side) {
    if (to - from > kChainRounding) leaveFan(fan, from, to, 0, side);
  };
  // The fan counterclockwise from one direction to another, on the surface.
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
    const double back = angleTowards(geometry_, fan, point, *before);
    const double ahead = angleTowards(geometry_, fan, point, *after);
    leaveBetween(ahead, back, SideOfPath::kLeft);
    leaveBetween(back, ahead, SideOfPath::kRight);
    return;
  }
  const double only = angleTowards(geometry_, fan, point, after != nullptr ? *after : *before);
  if (fan.isRound) {
    leave(only + right, only + fan.total - right, SideOfPath::kEnd);
    return;
  }
  // At a point of the boundary the fan has two parts, one on each side of the path.
  leave(only + right, kInfinity, after != nullptr ? SideOfPath::kLeft : SideOfPath::kRight);
  leave(-kInfinity, only - right, after != nullptr ? SideOfPath::kRight : SideOfPath::kLeft);
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

/// Sends out the part of a fan in one face: from a point of the face, in the directions between two
/// angles of its frame.
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
      if (t < 0 || !(height > kLocalRounding * doubleArea(geometry_, face) / length)) continue;
      const double start =
          near + std::remainder(angleOf(toTail) + width / 2 - near, 2 * kPi) - width / 2;
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

#include "distance/sight.h"

#include <algorithm>

#include "distance/window.h"
#include "intrinsic/angles.h"
#include "mesh/rounding.h"

namespace karcher {
namespace {

/// The largest number of bends of a path. Only solvers find paths with more bends.
constexpr int kMostBends = 8;
/// The largest number of strips that the search tries for a path. Each strip after the first has a
/// better aim than the previous one, or passes a vertex on the other side.
constexpr int kMostWalks = 6;

/// A threshold for the ratio of a path's length to the length of the line in space. Above it, the
/// search compares the path with paths to either side, since several paths may be straight over a
/// ridge or around a limb.
constexpr double kSmallDetour = 1.1;
constexpr double kAside = 0.7;  ///< the angle between these paths and the first, in radians
/// A threshold for the same ratio. Above it, the search rejects the path, since it may not be the
/// shortest. If a path is the shortest of those compared so far and a vertex beside it has a
/// curvature above kSharp, the search rejects all paths.
constexpr double kMostDetour = 1.4;
constexpr double kSharp = 0.25;  ///< the absolute angle defect of a vertex, in radians

/// The strip of faces between a source and a vertex, and the path in it. The strip is unfolded in
/// the frame of the source's face, with the source at the origin.
class SightLine {
 public:
  SightLine(const Geometry& geometry, const SightSource& source, int vertex)
      : geometry_(geometry), mesh_(*geometry.mesh), source_(source), vertex_(vertex) {}

  std::optional<Sight> find() {
    for (int k = 0; k < 3; ++k) {
      const int h = 3 * source_.face + k;
      if (mesh_.tail(h) == vertex_) {
        arrive(h, source_.corners[k], halfedgeInFace(geometry_, h));
        return sight();
      }
    }
    const Vec3 way = mesh_.positions[vertex_] - source_.position;
    const double chord = way.norm();
    const Vec2 aim = longAs(way, {way.dot(source_.x), way.dot(source_.y)});
    std::optional<Sight> best;
    for (const double turn : {0.0, -kAside, kAside}) {
      std::optional<Sight> found = search(rotate(unitVector(turn), aim));
      if (turn == 0 && (!found || found->distance <= kSmallDetour * chord)) return found;
      if (!found || (best && best->distance <= found->distance)) continue;
      if (passesSharpVertex()) return std::nullopt;
      best = found;
    }
    return best->distance <= kMostDetour * chord ? best : std::nullopt;
  }

 private:
  /// The path that begins in the direction of an aim.
  std::optional<Sight> search(Vec2 aim) {
    for (int walk = 0; walk < kMostWalks; ++walk) {
      if (!follow(aim)) return std::nullopt;
      if (leaving_ < 0) {
        // Full steps may alternate between two aims, so steps after the first are half as long.
        aim += (walk == 0 ? 1 : 0.5) * better_;
        continue;
      }
      bendCount_ = 0;
      if (!pullTight(Vec2::Zero(), at_, 0, sideCount_)) return std::nullopt;
      const int passed = passedOnWrongSide();
      if (passed < 0) return sight();
      aim = seenOnOtherSide(sides_[passed]);
    }
    return std::nullopt;
  }

  /// A vertex beside the strip. It has no initial values, since most of the array stays unused.
  struct Side {
    double x;
    double y;
    int vertex;
    int sign;  ///< the side on which the vertex lies: 1 for the right, -1 for the left

    Vec2 at() const { return {x, y}; }
  };

  static Vec2 longAs(const Vec3& vector, const Vec2& projected) {
    return projected * (vector.norm() / projected.norm());
  }

  /// Follows the line to an aim across faces, up to a face with the target vertex. If the aim lies
  /// in an earlier face, `leaving_` is negative and `better_` leads from the aim to a better one.
  /// Returns false if the line cannot continue.
  bool follow(const Vec2& aim) {
    leaving_ = -1;
    sideCount_ = 0;
    int exit = 0;
    while (exit < 3 && !(cross(source_.corners[exit], aim) >= 0 &&
                         cross(aim, source_.corners[(exit + 1) % 3]) > 0)) {
      ++exit;
    }
    if (exit == 3) return false;
    int h = 3 * source_.face + exit;
    Vec2 right = source_.corners[exit];
    Vec2 left = source_.corners[(exit + 1) % 3];
    sides_[sideCount_++] = {right.x(), right.y(), mesh_.tail(h), 1};
    sides_[sideCount_++] = {left.x(), left.y(), mesh_.head(h), -1};
    for (int faces = 0; faces < kMostFacesOfSight; ++faces) {
      const int twin = mesh_.twin[h];
      if (twin < 0) return false;
      const Vec2 across = (right - left) / geometry_.edgeLength[twin];
      const Vec2 apex = left + rotate(across, oppositeOverHalfedge(geometry_, twin));
      const int last = previous(twin);
      const int vertex = mesh_.tail(last);
      if (vertex == vertex_) {
        arrive(last, apex, left - apex);
        return true;
      }
      const bool isOnRight = cross(apex, aim) > 0;
      (isOnRight ? right : left) = apex;
      h = isOnRight ? last : next(twin);
      sides_[sideCount_++] = {apex.x(), apex.y(), vertex, isOnRight ? 1 : -1};
      if (cross(left - right, aim - right) > 0) return aimBetter(h, right, left, aim);
    }
    return false;
  }

  void arrive(int leaving, const Vec2& at, const Vec2& edge) {
    leaving_ = leaving;
    at_ = at;
    edge_ = edge;
  }

  /// Improves an aim that lies in the face of half-edge h, whose ends are at `right` and `left`.
  bool aimBetter(int h, const Vec2& right, const Vec2& left, const Vec2& aim) {
    const int f = faceOf(h);
    // The rotation from the face's frame to the source's.
    const Vec2 turn =
        rotateBack(halfedgeInFace(geometry_, h), left - right) / square(geometry_.edgeLength[h]);
    const Vec2 inFace = cornerInFace(geometry_, f, cornerOf(h)) + rotateBack(turn, aim - right);
    const Vec3 there = position(mesh_, SurfacePoint{f, barycentric(geometry_, f, inFace)});
    const Vec3 off = mesh_.positions[vertex_] - there;
    better_ = rotate(turn, longAs(off, toFace(geometry_, f, off)));
    return better_.allFinite();
  }

  /// Bends the path between two places around vertices beside the strip that are in the path's way.
  /// Considers only the vertices first <= i < last. Returns false if the path bends too often.
  bool pullTight(const Vec2& from, const Vec2& to, int first, int last) {
    const Vec2 way = to - from;
    int bend = -1;
    double most = 0;
    for (int i = first; i < last; ++i) {
      const Vec2 off = sides_[i].at() - from;
      const double area = -sides_[i].sign * cross(off, way);
      // Vertices behind `from` are not in the way.
      if (area <= 0 || off.dot(way) <= 0) continue;
      const double sine = area / off.norm();
      if (!(sine > most)) continue;
      most = sine;
      bend = i;
    }
    if (bend < 0) return true;
    if (bendCount_ == kMostBends) return false;
    const Vec2 at = sides_[bend].at();
    if (!pullTight(from, at, first, bend)) return false;
    if (bendCount_ == kMostBends) return false;
    bends_[bendCount_++] = bend;
    return pullTight(at, to, bend + 1, last);
  }

  Vec2 bendAt(int k) const { return sides_[bends_[k]].at(); }
  /// The two ends of the path's straight part k.
  Vec2 partStart(int k) const { return k == 0 ? Vec2(0, 0) : bendAt(k - 1); }
  Vec2 partEnd(int k) const { return k == bendCount_ ? at_ : bendAt(k); }

  double length() const {
    double sum = 0;
    for (int k = 0; k <= bendCount_; ++k) sum += (partEnd(k) - partStart(k)).norm();
    return sum;
  }

  /// The index of a vertex beside the strip that a shorter path passes on the other side, or -1.
  int passedOnWrongSide() const {
    for (int k = 0; k < bendCount_; ++k) {
      const Vec2 before = bendAt(k) - partStart(k);
      const Vec2 after = partEnd(k + 1) - bendAt(k);
      const double angle = angleBetween(before, after);
      const int vertex = sides_[bends_[k]].vertex;
      if (angle > kChainRounding - curvature(vertex) && !mesh_.onBoundary[vertex]) return bends_[k];
    }
    for (int k = 0; k <= bendCount_; ++k) {
      const int passed = passedTooNear(partStart(k), partEnd(k));
      if (passed >= 0) return passed;
    }
    return -1;
  }

  /// Returns the index of a vertex that a straight part passes on the wrong side, or -1. Two
  /// straight paths lead around a vertex of positive curvature; the shorter of them passes the
  /// vertex at the greater distance. If both have the same length, the path to the left of the
  /// vertex counts as shorter.
  int passedTooNear(const Vec2& from, const Vec2& to) const {
    const Vec2 way = to - from;
    const double squared = way.squaredNorm();
    for (int i = 0; i < sideCount_; ++i) {
      const Side& side = sides_[i];
      const Vec2 off = side.at() - from;
      const double before = off.dot(way);
      if (before <= 0 || before >= squared) continue;
      const double bend = curvature(side.vertex);
      if (bend <= kChainRounding || mesh_.onBoundary[side.vertex]) continue;
      const double least =
          (1 - side.sign * kChainRounding) * bend / 2 * before * (squared - before);
      if (std::abs(cross(off, way)) * squared < least) return i;
    }
    return -1;
  }

  bool passesSharpVertex() const {
    return std::any_of(sides_, sides_ + sideCount_, [&](const Side& side) {
      return std::abs(curvature(side.vertex)) > kSharp && !mesh_.onBoundary[side.vertex];
    });
  }

  double curvature(int vertex) const { return 2 * kPi - geometry_.totalAngle[vertex]; }

  /// The position of the target if the faces are unfolded on the other side of a vertex beside the
  /// strip.
  Vec2 seenOnOtherSide(const Side& side) const {
    const Vec2 turn = unitVector(-side.sign * curvature(side.vertex));
    return side.at() + rotate(turn, at_ - side.at());
  }

  Sight sight() const {
    const Vec2 back = partStart(bendCount_) - at_;
    const double distance = length();
    const double inCorner = angleFromTo(edge_, back);
    return {distance, logVectorAlong(geometry_, vertex_, distance,
                                     geometry_.cumulatedAngle[leaving_] + inCorner)};
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const SightSource& source_;
  int vertex_;
  Side sides_[kMostFacesOfSight + 2];
  int sideCount_ = 0;
  /// the numbers, in `sides_`, of the vertices at which the path bends
  int bends_[kMostBends] = {};
  int bendCount_ = 0;
  int leaving_ = -1;            ///< the half-edge that leaves the target in the last face
  Vec2 at_ = Vec2::Zero();      ///< the place of the target
  Vec2 better_ = Vec2::Zero();  ///< the vector from the aim to a better one
  Vec2 edge_ = Vec2::Zero();    ///< the vector of the half-edge `leaving_`
};

}  // namespace

namespace {

SightSource sourceInFace(const Geometry& geometry, const SurfacePoint& point) {
  SightSource source;
  source.face = point.face;
  source.position = position(*geometry.mesh, point);
  source.x = toSpace(geometry, point.face, Vec2(1, 0));
  source.y = toSpace(geometry, point.face, Vec2(0, 1));
  for (int k = 0; k < 3; ++k) {
    source.corners[k] = cornerInFace(geometry, point.face, k) - pointInFace(geometry, point);
  }
  return source;
}

/// Whether paths from a source at a vertex to another vertex begin in the face of this source. They
/// do if, seen along the face's normal, the other vertex lies in the angle of the face's corner at
/// the source.
bool isAhead(const Geometry& geometry, const SightSource& source, int vertex) {
  const Vec3 way = geometry.mesh->positions[vertex] - source.position;
  const Vec2 aim(way.dot(source.x), way.dot(source.y));
  for (int k = 0; k < 3; ++k) {
    if (source.corners[k] != Vec2::Zero()) continue;
    return cross(source.corners[(k + 1) % 3], aim) >= 0 &&
           cross(aim, source.corners[(k + 2) % 3]) > 0;
  }
  return false;
}

}  // namespace

void findSightSources(const Geometry& geometry, const SurfacePoint& point, SightSources& sources) {
  const TriangleMesh& mesh = *geometry.mesh;
  const PointLocation location = locate(mesh, point);
  sources.clear();
  if (location.simplex != Simplex::kVertex) {
    sources.push_back(sourceInFace(geometry, point));
    return;
  }
  for (const int h : outgoingHalfedges(mesh, location.vertex)) {
    SightSource source = sourceInFace(geometry, edgePoint(h, 0));
    source.corners[cornerOf(h)] = Vec2::Zero();
    sources.push_back(source);
  }
}

std::optional<Sight> sightFrom(const Geometry& geometry, const SightSources& sources, int vertex) {
  if (sources.count() == 1) return SightLine(geometry, sources[0], vertex).find();
  for (const SightSource& source : sources) {
    if (isAhead(geometry, source, vertex)) return SightLine(geometry, source, vertex).find();
  }
  return std::nullopt;
}

}  // namespace karcher

#include "curves/offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "curves/cornered_offset.h"
#include "distance/path_distance.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "mesh/sign_change.h"

namespace karcher {
namespace {

/// The tracer divides a side that the isoline crosses twice, for instance in the tip of a gap, only
/// if the side is longer than this, relative to the scale. On a shorter side, no point lies across
/// the line from both ends by more than half the side's length, since distances are Lipschitz. This
/// half is the tolerance.
constexpr double kShortestSide = 2 * kOffsetTolerance;

/// The number of steps of a search for the extremum on a side. Each keeps 0.62 of the interval.
constexpr int kExtremumSteps = 14;

/// The largest number of halvings of a chord that deviates from the distance.
constexpr int kMostChordHalvings = 14;

/// A corner of a piece of a face. All pieces that meet at the corner, also those in the other face
/// of an edge, use exactly the same weights for it.
struct PieceCorner {
  Vec3 bary;
  Vec2 place;
  double distance;
};

struct Piece {
  PieceCorner corners[3];

  const PieceCorner& operator[](int k) const { return corners[k]; }
};

/// The key of a piece's side that the isoline crosses. Both pieces at the side compute the same
/// key.
using CrossingKey = std::array<double, 5>;

struct LinePoint {
  SurfacePoint point;
  SideOfPath side = SideOfPath::kEnd;
};

/// The part of the isoline in a piece, from crossing to crossing, with nearer points on the left.
struct Strand {
  int from = 0;
  int to = 0;
  Array<LinePoint> inner;
};

class OffsetTracer {
 public:
  OffsetTracer(const Geometry& geometry, const PathDistance& field, double distance, double scale)
      : geometry_(geometry),
        mesh_(*geometry.mesh),
        field_(field),
        distance_(distance),
        scale_(scale) {}

  void trace() {
    for (const int face : field_.faces()) {
      Piece piece;
      for (int k = 0; k < 3; ++k) {
        piece.corners[k].bary = Vec3::Unit(k);
        piece.corners[k].place = cornerInFace(geometry_, face, k);
        piece.corners[k].distance = field_.atVertex(mesh_.corner(face, k));
      }
      visit(face, piece);
    }
  }

  /// The joined strands; the last point of a closed line is its first.
  Array<Array<LinePoint>> lines() const {
    Array<int> strandFrom(crossings_.size(), -1);
    Array<uint8_t> isEntered(crossings_.size(), 0);
    for (int i = 0; i < strands_.count(); ++i) {
      strandFrom[strands_[i].from] = i;
      isEntered[strands_[i].to] = 1;
    }
    Array<uint8_t> used(strands_.size(), 0);
    Array<Array<LinePoint>> lines;
    const auto follow = [&](int start) {
      Array<LinePoint> line{crossings_[strands_[start].from]};
      for (int i = start; i >= 0 && used[i] == 0; i = strandFrom[strands_[i].to]) {
        used[i] = 1;
        for (const LinePoint& point : strands_[i].inner) line.push_back(point);
        line.push_back(crossings_[strands_[i].to]);
      }
      lines.push_back(std::move(line));
    };
    for (int i = 0; i < strands_.count(); ++i) {
      if (used[i] == 0 && isEntered[strands_[i].from] == 0) follow(i);
    }
    for (int i = 0; i < strands_.count(); ++i) {
      if (used[i] == 0) follow(i);
    }
    return lines;
  }

  /// The place between consecutive points a and b at which the side changes, still on a's side.
  LinePoint changeBetween(const LinePoint& a, const LinePoint& b) const {
    LinePoint near = a;
    LinePoint far = b;
    for (int i = 0; i < std::numeric_limits<double>::digits; ++i) {
      const SurfacePoint middle = pointBetween(mesh_, near.point, far.point, 0.5);
      const SideOfPath side = field_.at(middle).side;
      (side == a.side ? near : far) = {middle, side};
    }
    return near;
  }

 private:
  bool isNearer(double distance) const { return distance < distance_; }

  void visit(int face, const Piece& corners) {
    if (++pieces_ > kMostOffsetPieces) {
      throw Error(ErrorCode::kBadArgument,
                  "the distance is so small beside the faces that it takes more than 20,000,000 "
                  "pieces of faces");
    }
    const Vec2 middle = (corners[0].place + corners[1].place + corners[2].place) / 3;
    double radius = 0;
    int longest = 0;
    double lengths[3];
    for (int k = 0; k < 3; ++k) {
      radius = std::max(radius, (corners[k].place - middle).norm());
      lengths[k] = (corners[(k + 1) % 3].place - corners[k].place).norm();
      if (lengths[k] > lengths[longest]) longest = k;
    }
    // Distances beyond the limit of the field count as the limit.
    const double atMiddle = std::min(field_.at(face, middle).value, kOffsetReach * distance_);
    if (std::abs(atMiddle - distance_) > radius * (1 + 1e-9)) return;
    int divided = lengths[longest] > kLongestSide * scale_ ? longest : -1;
    Vec3 at = (corners[longest].bary + corners[(longest + 1) % 3].bary) / 2;
    for (int k = 0; k < 3 && divided != longest; ++k) {
      if (divided >= 0 && lengths[k] <= lengths[divided]) continue;
      if (const auto hidden = hiddenBetween(face, corners[k], corners[(k + 1) % 3], lengths[k])) {
        divided = k;
        at = *hidden;
      }
    }
    if (divided < 0) {
      traceIn(face, corners);
      return;
    }
    const PieceCorner& a = corners[divided];
    const PieceCorner& b = corners[(divided + 1) % 3];
    const PieceCorner& c = corners[(divided + 2) % 3];
    const PieceCorner between = cornerAt(face, at);
    visit(face, {{a, between, c}});
    visit(face, {{between, b, c}});
  }

  PieceCorner cornerAt(int face, const Vec3& bary) const {
    return {bary, pointInFace(geometry_, {face, bary}), distanceAt(face, bary)};
  }

  /// The distance at a point. Both faces at an edge evaluate it in the same order, so that they get
  /// the same value.
  double distanceAt(int face, const Vec3& bary) const {
    for (int k = 0; k < 3; ++k) {
      if (bary[k] == 0) return atEdge(edgeOf(face, k), alongEdge(face, k, bary)).value;
    }
    return field_.at(face, pointInFace(geometry_, {face, bary})).value;
  }

  /// The half-edge that represents the edge opposite to a corner: the same in both faces.
  int edgeOf(int face, int corner) const {
    const int h = next(3 * face + corner);
    return mesh_.twin[h] < 0 ? h : std::min(h, mesh_.twin[h]);
  }

  double alongEdge(int face, int corner, const Vec3& bary) const {
    const int h = next(3 * face + corner);
    return edgeOf(face, corner) == h ? bary[cornerOf(next(h))] : bary[cornerOf(h)];
  }

  PathDistance::Distance atEdge(int h, double t) const {
    const SurfacePoint point = edgePoint(h, t);
    PathDistance::Distance here = field_.at(point.face, pointInFace(geometry_, point));
    if (mesh_.twin[h] < 0) return here;
    const SurfacePoint other = edgePoint(mesh_.twin[h], 1 - t);
    const PathDistance::Distance there = field_.at(other.face, pointInFace(geometry_, other));
    return there.value < here.value ? there : here;
  }

  /// A side of a piece, the same for both pieces at it. On an edge of the mesh, its parameter goes
  /// from `from` to `to`; inside a face, from 0 to 1.
  struct Side {
    int halfedge = -1;
    int face = -1;
    double from = 0;
    double to = 1;
    double atFrom = 0;
    double atTo = 0;
    Vec2 start = Vec2::Zero();
    Vec2 way = Vec2::Zero();
    CrossingKey key{};
  };

  Side sideBetween(int face, const PieceCorner& a, const PieceCorner& b) const {
    Side side;
    side.face = face;
    const auto inOrder = [&](bool isSo) { return isSo ? std::pair(&a, &b) : std::pair(&b, &a); };
    for (int k = 0; k < 3; ++k) {
      if (a.bary[k] != 0 || b.bary[k] != 0) continue;
      side.halfedge = edgeOf(face, k);
      const auto [first, second] = inOrder(alongEdge(face, k, a.bary) < alongEdge(face, k, b.bary));
      side.from = alongEdge(face, k, first->bary);
      side.to = alongEdge(face, k, second->bary);
      side.atFrom = first->distance;
      side.atTo = second->distance;
      side.key = {-1.0 - side.halfedge, side.from, side.to, 0, 0};
      return side;
    }
    const auto [first, second] =
        inOrder(std::pair(a.bary[1], a.bary[2]) < std::pair(b.bary[1], b.bary[2]));
    side.atFrom = first->distance;
    side.atTo = second->distance;
    side.start = first->place;
    side.way = second->place - first->place;
    side.key = {double(face), first->bary[1], first->bary[2], second->bary[1], second->bary[2]};
    return side;
  }

  double valueOn(const Side& side, double t) const {
    if (side.halfedge >= 0) return atEdge(side.halfedge, t).value;
    return field_.at(side.face, side.start + t * side.way).value;
  }

  /// A point of a side that lies across the isoline from both ends of the side, if the search finds
  /// one. There the tracer divides both pieces at the side. Short sides are not searched.
  std::optional<Vec3> hiddenBetween(int face, const PieceCorner& a, const PieceCorner& b,
                                    double length) const {
    const bool nearer = isNearer(a.distance);
    if (nearer != isNearer(b.distance) || length <= kShortestSide * scale_) return {};
    // The distances of two points differ by at most the length of a path between them.
    const double known = std::min(a.distance, kOffsetReach * distance_) +
                         std::min(b.distance, kOffsetReach * distance_) - 2 * distance_;
    if (std::abs(known) > length) return {};
    const Side side = sideBetween(face, a, b);
    const double golden = std::numbers::phi - 1;
    double low = side.from;
    double high = side.to;
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double atLeft = valueOn(side, left);
    double atRight = valueOn(side, right);
    for (int i = 0; i < kExtremumSteps; ++i) {
      if (isNearer(atLeft) != nearer) return placeOn(side, face, left);
      if (isNearer(atRight) != nearer) return placeOn(side, face, right);
      if (nearer ? atLeft > atRight : atLeft < atRight) {
        high = std::exchange(right, left);
        left = high - golden * (high - low);
        atRight = std::exchange(atLeft, valueOn(side, left));
      } else {
        low = std::exchange(left, right);
        right = low + golden * (high - low);
        atLeft = std::exchange(atRight, valueOn(side, right));
      }
    }
    return {};
  }

  /// The barycentric weights of a side's point: on an edge exactly the same in both of its faces.
  Vec3 placeOn(const Side& side, int face, double t) const {
    if (side.halfedge >= 0) {
      const bool isOwn = faceOf(side.halfedge) == face;
      const int h = isOwn ? side.halfedge : mesh_.twin[side.halfedge];
      Vec3 bary = Vec3::Zero();
      bary[cornerOf(h)] = isOwn ? 1 - t : t;
      bary[cornerOf(next(h))] = isOwn ? t : 1 - t;
      return bary;
    }
    const auto& [_, first1, first2, second1, second2] = side.key;
    const double second = first1 + t * (second1 - first1);
    const double third = first2 + t * (second2 - first2);
    return {1 - second - third, second, third};
  }

  /// The index of the isoline's crossing between a nearer and a farther corner.
  int crossing(int face, const PieceCorner& a, const PieceCorner& b) {
    const Side side = sideBetween(face, a, b);
    const auto [entry, isNew] = numbers_.try_emplace(side.key, crossings_.count());
    if (!isNew) return entry->second;
    const double t =
        cut(side.from, side.to, side.atFrom, side.atTo, [&](double s) { return valueOn(side, s); });
    crossings_.push_back(
        side.halfedge < 0 ? pointAt(face, side.start + t * side.way)
                          : LinePoint{edgePoint(side.halfedge, t), atEdge(side.halfedge, t).side});
    return crossings_.count() - 1;
  }

  /// The parameter between `from` and `to` at which the values pass the distance.
  template <class Value>
  double cut(double from, double to, double atFrom, double atTo, const Value& valueAt) const {
    const auto beyond = [&](double value) {
      return std::abs(value - distance_) <= kLocalRounding * distance_ ? 0 : value - distance_;
    };
    return signChange(from, to, beyond(atFrom), beyond(atTo), kStepRounding * (from + to),
                      [&](double s) { return beyond(valueAt(s)); });
  }

  LinePoint pointAt(int face, const Vec2& place) const {
    return {clampedPoint(face, barycentric(geometry_, face, place)), field_.at(face, place).side};
  }

  void traceIn(int face, const Piece& corners) {
    int enter = -1;
    int leave = -1;
    for (int k = 0; k < 3; ++k) {
      const bool here = isNearer(corners[k].distance);
      if (here == isNearer(corners[(k + 1) % 3].distance)) continue;
      // Nearer points lie on the left of the line. So the line begins where the piece's boundary,
      // followed counterclockwise, leaves the nearer points.
      (here ? leave : enter) = k;
    }
    if (enter < 0) return;
    const auto on = [&](int k) { return crossing(face, corners[k], corners[(k + 1) % 3]); };
    Strand strand;
    strand.from = on(leave);
    strand.to = on(enter);
    const auto placeOf = [&](int number) {
      return pointInFace(geometry_, inFace(mesh_, crossings_[number].point, face));
    };
    refine(face, placeOf(strand.from), placeOf(strand.to), kMostChordHalvings, strand.inner);
    strands_.push_back(std::move(strand));
  }

  /// Appends points between two others, so that chords stay at the distance up to the tolerance.
  void refine(int face, const Vec2& from, const Vec2& to, int halvings, Array<LinePoint>& inner) {
    const Vec2 middle = (from + to) / 2;
    const double atMiddle = field_.at(face, middle).value;
    const auto keeps = [&](double value) {
      return std::abs(value - distance_) <= kOffsetTolerance * scale_;
    };
    // A chord may cross the line in its middle, so its quarters count, too.
    if (halvings == 0 || (keeps(atMiddle) && keeps(field_.at(face, (from + middle) / 2).value) &&
                          keeps(field_.at(face, (middle + to) / 2).value))) {
      return;
    }
    const Vec2 chord = to - from;
    // If the middle is nearer than the distance, the search goes away from the nearer points,
    // otherwise towards them.
    const double sign = isNearer(atMiddle) ? 1 : -1;
    const Vec2 aside = sign * Vec2(chord.y(), -chord.x());
    double edge = kInfinity;
    const Vec3 here = barycentric(geometry_, face, middle);
    const Vec3 there = barycentric(geometry_, face, middle + aside);
    for (int k = 0; k < 3; ++k) {
      if (there[k] < here[k]) edge = std::min(edge, here[k] / (here[k] - there[k]));
    }
    const auto value = [&](double s) { return field_.at(face, middle + s * aside).value; };
    double part = 0;
    double reach = std::min(1.0, edge);
    double atPart = atMiddle;
    // The tip of a gap may lie farther away than the chord is long. So the step doubles while this
    // leads nearer to the line, up to the edge of the face, along which the line may run.
    while (true) {
      const double atReach = value(reach);
      if (isNearer(atReach) != isNearer(atPart)) {
        part = cut(part, reach, atPart, atReach, value);
        break;
      }
      if (!(std::abs(atReach - distance_) < std::abs(atPart - distance_))) break;
      part = reach;
      atPart = atReach;
      if (reach == edge) break;
      reach = std::min(2 * reach, edge);
    }
    if (part == 0 && !keeps(atMiddle)) return;
    const Vec2 place = middle + part * aside;
    refine(face, from, place, halvings - 1, inner);
    inner.push_back(pointAt(face, place));
    refine(face, place, to, halvings - 1, inner);
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  const PathDistance& field_;
  double distance_;
  double scale_;  ///< The length to which tolerances are relative.
  int64_t pieces_ = 0;
  std::map<CrossingKey, int> numbers_;
  Array<LinePoint> crossings_;
  Array<Strand> strands_;
};

Isoline isolineOf(const TriangleMesh& mesh, Array<SurfacePoint> points, bool closed) {
  SurfacePath path = pathThrough(mesh, std::move(points));
  const double length = path.length();
  return {std::move(path.points), closed, length};
}

Array<SurfacePoint> pointsOf(const Array<LinePoint>& line) {
  Array<SurfacePoint> points;
  for (const LinePoint& point : line) points.push_back(point.point);
  return points;
}

/// Appends the parts of a line between changes of the side.
void appendRuns(const OffsetTracer& tracer, Array<LinePoint> line, bool closed,
                Array<OffsetRun>& runs) {
  const auto changes = [](const LinePoint& a, const LinePoint& b) { return a.side != b.side; };
  const auto change = std::adjacent_find(line.begin(), line.end(), changes);
  if (change == line.end()) {
    runs.push_back({pointsOf(line), line.front().side, closed});
    return;
  }
  // The first run of a closed line with changes begins at a change.
  if (closed) {
    line.pop_back();
    std::rotate(line.begin(), change + 1, line.end());
    line.push_back(line.front());
  }
  OffsetRun run{{}, line.front().side, false};
  if (closed) run.points.push_back(tracer.changeBetween(line[0], line[line.count() - 2]).point);
  run.points.push_back(line.front().point);
  for (int i = 1; i < line.count(); ++i) {
    const LinePoint& here = line[i];
    if (changes(line[i - 1], here)) {
      run.points.push_back(tracer.changeBetween(line[i - 1], here).point);
      runs.push_back(std::move(run));
      if (closed && i + 1 == line.count()) return;
      run = {{tracer.changeBetween(here, line[i - 1]).point}, here.side, false};
    }
    run.points.push_back(here.point);
  }
  runs.push_back(std::move(run));
}

}  // namespace

Array<OffsetRun> offsetRuns(const Geometry& geometry, const PathDistance& field, double distance,
                            double scale) {
  OffsetTracer tracer(geometry, field, distance, scale);
  tracer.trace();
  Array<OffsetRun> runs;
  for (Array<LinePoint>& line : tracer.lines()) {
    const bool closed = samePlace(*geometry.mesh, line.front().point, line.back().point);
    appendRuns(tracer, std::move(line), closed, runs);
  }
  return runs;
}

Array<Isoline> offsetLines(const Geometry& geometry, std::span<const SurfacePath> paths,
                           std::span<const double> distances, OffsetSide side,
                           const OffsetCorners& corners) {
  double distance = 0;
  double least = kInfinity;
  for (const double one : distances) {
    distance = std::max(distance, one);
    least = one >= 0 && std::isfinite(one) ? std::min(least, one) : -1;
  }
  if (!(distance > 0) || !(least >= 0)) {
    throw Error(ErrorCode::kBadArgument, "the distance of an offset must be a positive number");
  }
  if (corners.shape != CornerShape::kRound) {
    if (distances.size() > 1) {
      throw Error(ErrorCode::kBadArgument, "corners of several distances must be round");
    }
    return corneredOffset(geometry, paths, distance, side, corners);
  }
  const PathDistance field(geometry, paths, kOffsetReach * distance, distances);
  const double scale = std::max(least, kNarrowestOffset * distance);
  const TriangleMesh& mesh = *geometry.mesh;
  Array<Isoline> lines;
  if (side == OffsetSide::kBoth) {
    OffsetTracer tracer(geometry, field, distance, scale);
    tracer.trace();
    for (const Array<LinePoint>& line : tracer.lines()) {
      const bool closed = samePlace(mesh, line.front().point, line.back().point);
      lines.push_back(isolineOf(mesh, pointsOf(line), closed));
    }
    return lines;
  }
  const bool isLeft = side == OffsetSide::kLeft;
  for (OffsetRun& run : offsetRuns(geometry, field, distance, scale)) {
    if (run.side != (isLeft ? SideOfPath::kLeft : SideOfPath::kRight)) continue;
    if (run.points.count() < 2) continue;
    if (isLeft) std::reverse(run.points.begin(), run.points.end());
    lines.push_back(isolineOf(mesh, std::move(run.points), run.isClosed));
  }
  return lines;
}

}  // namespace karcher

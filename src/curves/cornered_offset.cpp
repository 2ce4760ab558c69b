#include "curves/cornered_offset.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distance/find_path.h"
#include "intrinsic/straightest.h"
#include "mesh/error.h"
#include "mesh/rounding.h"
#include "regions/region.h"

namespace karcher {
namespace {

enum Side { kLeftSide, kRightSide };

/// A place at which a path is divided. The perpendiculars `before` bound the strip of the previous
/// piece, the perpendiculars `after` the strip of the next one. The arrays are indexed by `Side`.
struct Division {
  int index = 0;  ///< the index of the path's point
  SurfacePath before[2];
  SurfacePath after[2];
  SurfacePath tip[2];  ///< from the end of `before` to the end of `after`; empty without a tip
};

/// The first point that two polylines of geodesics share.
struct Meeting {
  int first = 0;
  int second = 0;
  SurfacePoint point;
};

std::optional<Meeting> meet(const Geometry& geometry, const SurfacePath& one,
                            const SurfacePath& other) {
  const TriangleMesh& mesh = *geometry.mesh;
  const auto placed = [&](const SurfacePath& path, int i) {
    const int face = path.points[i].face;
    return std::pair(pointInFace(geometry, inFace(mesh, path.points[i - 1], face)),
                     pointInFace(geometry, path.points[i]));
  };
  for (int i = 1; i < one.points.count(); ++i) {
    for (int j = 1; j < other.points.count(); ++j) {
      const int face = one.points[i].face;
      if (other.points[j].face != face) continue;
      const auto [a, b] = placed(one, i);
      const auto [c, d] = placed(other, j);
      const double across = cross(b - a, d - c);
      if (across == 0) continue;
      const double s = cross(c - a, d - c) / across;
      const double t = cross(c - a, b - a) / across;
      const auto isOn = [](double x) { return x >= -kLocalRounding && x <= 1 + kLocalRounding; };
      if (!isOn(s) || !isOn(t)) continue;
      return Meeting{i, j, clampedPoint(face, barycentric(geometry, face, a + s * (b - a)))};
    }
  }
  return std::nullopt;
}

class CorneredOffset {
 public:
  CorneredOffset(const Geometry& geometry, double distance, const OffsetCorners& corners)
      : geometry_(geometry), mesh_(*geometry.mesh), distance_(distance), corners_(corners) {}

  void add(const SurfacePath& path, int number) {
    const Array<SurfacePoint> points = pointsApart(geometry_, path, number);
    const int last = points.count() - 1;
    const bool closed = samePlace(mesh_, points.front(), points.back());
    const Array<Division> divisions = divide(points, closed);
    if (divisions.empty()) return addPiece(path, nullptr, nullptr);
    for (const Division& division : divisions) addLines(division);
    const auto piece = [&](const Division* from, const Division* to) {
      Array<SurfacePoint> part;
      const int begin = from != nullptr ? from->index : 0;
      const int end = to != nullptr ? to->index : last;
      for (int i = begin; i != end; i = closed ? (i + 1) % last : i + 1) part.push_back(points[i]);
      part.push_back(points[end]);
      addPiece(pathThrough(mesh_, std::move(part)), from, to);
    };
    const int count = divisions.count();
    for (int i = 0; i + 1 < count; ++i) piece(&divisions[i], &divisions[i + 1]);
    if (closed) {
      piece(&divisions[count - 1], &divisions[0]);
    } else {
      piece(nullptr, &divisions[0]);
      piece(&divisions[count - 1], nullptr);
    }
  }

  Array<Isoline> lines(OffsetSide side) const {
    const Arrangement all = arrange(geometry_, lines_);
    const Region region = covered(all);
    Array<uint8_t> sides(static_cast<size_t>(all.halfedgeCount()), 0);
    for (const PathUse& use : all.uses) sides[use.halfedge] |= sideOf_[use.path];
    const int wanted = side == OffsetSide::kLeft ? 1 : side == OffsetSide::kRight ? 2 : 7;
    const auto isWanted = [&](int h) {
      const int t = all.twin[h];
      return t >= 0 && ((sides[h] | sides[t]) & wanted) != 0;
    };
    Array<Isoline> result;
    for (Array<int>& loop : boundaryOf(all, region)) {
      // A loop with unwanted half-edges is rotated to begin with one, so that no wanted line runs
      // through the loop's start.
      const auto other = std::find_if_not(loop.begin(), loop.end(), isWanted);
      const bool closed = other == loop.end();
      if (!closed) std::rotate(loop.begin(), other, loop.end());
      Array<SurfacePoint> points;
      for (int i = 0; i <= loop.count(); ++i) {
        if (i < loop.count() && isWanted(loop[i])) {
          points.push_back(vertexInFace(mesh_, all, all.face(loop[i]), all.tail[loop[i]]));
        } else if (!points.empty()) {
          const int h = loop[i - 1];
          points.push_back(vertexInFace(mesh_, all, all.face(h), all.head(h)));
          if (side == OffsetSide::kLeft) std::reverse(points.begin(), points.end());
          SurfacePath path = pathThrough(mesh_, std::move(points));
          const double length = path.length();
          result.push_back({std::move(path.points), closed, length});
          points = {};
        }
      }
    }
    return result;
  }

 private:
  struct Piece {
    std::unique_ptr<PathDistance> field;
    bool isOpenAtStart = false;
    bool isOpenAtEnd = false;
    Vec3 start;
    Vec3 end;
  };

  /// The divisions of a path; empty if no corner needs a tip, or if a piece would end where it
  /// starts.
  Array<Division> divide(const Array<SurfacePoint>& points, bool closed) const {
    const int last = points.count() - 1;
    Array<Division> divisions;
    double turned = 0;
    bool hasCorner = false;
    for (int i = closed ? 0 : 1; i < last; ++i) {
      const SurfacePoint& before = points[i > 0 ? i - 1 : last - 1];
      const double turn = turnAt(points[i], before, points[i + 1]);
      turned += turn;
      if (turn <= kLeastCorner && turned <= kPi / 2) continue;
      std::optional<Division> division = divisionAt(points, i, before);
      if (!division) continue;
      hasCorner = hasCorner || turn > kLeastCorner;
      divisions.push_back(std::move(*division));
      turned = 0;
    }
    if (!hasCorner) return {};
    // A piece must not end where it starts.
    for (int k = 0; k < divisions.count(); ++k) {
      const int from = divisions[k].index;
      const bool isLast = k + 1 == divisions.count();
      if (isLast && !closed) break;
      const int to = isLast ? divisions[0].index + last : divisions[k + 1].index;
      if (!samePlace(mesh_, points[from], points[to % last])) continue;
      const int middle = (from + to) / 2 % last;
      std::optional<Division> division;
      if (to - from > 2) {
        division = divisionAt(points, middle, points[middle > 0 ? middle - 1 : last - 1]);
      }
      if (!division) return {};
      divisions.insert(divisions.begin() + k + 1, std::move(*division));
      ++k;
    }
    return divisions;
  }

  /// The angle by which a path turns at a point, with the point's total angle scaled to 2 pi; 0 on
  /// the boundary of the surface.
  double turnAt(const SurfacePoint& point, const SurfacePoint& before,
                const SurfacePoint& after) const {
    const PointFan fan = fanAt(geometry_, point);
    if (!fan.isRound) return 0;
    const double angle =
        angleTowards(geometry_, fan, point, before) - angleTowards(geometry_, fan, point, after);
    return std::abs(kPi - std::abs(angle) * 2 * kPi / fan.total);
  }

  /// The division at a point; empty for a point on the boundary of the surface, and if a
  /// perpendicular on the corner's outer side meets the boundary.
  std::optional<Division> divisionAt(const Array<SurfacePoint>& points, int index,
                                     const SurfacePoint& before) const {
    const SurfacePoint& point = points[index];
    const PointFan fan = fanAt(geometry_, point);
    if (!fan.isRound) return std::nullopt;
    const double back = angleTowards(geometry_, fan, point, before);
    const double ahead = angleTowards(geometry_, fan, point, points[index + 1]);
    Division division;
    division.index = index;
    for (const Side side : {kLeftSide, kRightSide}) {
      const double sign = side == kLeftSide ? 1 : -1;
      const StraightestPath leaving = perpendicular(point, fan, ahead + sign * kPi / 2);
      const StraightestPath arriving = perpendicular(point, fan, back - sign * kPi / 2);
      division.before[side] = arriving.path;
      division.after[side] = leaving.path;
      double between = sign * (back - ahead);
      if (between < 0) between += fan.total;
      if (between - kPi < kChainRounding || between - kPi > kPi - kChainRounding) continue;
      if (leaving.stop != TraceStop::kComplete || arriving.stop != TraceStop::kComplete) {
        return std::nullopt;
      }
      division.tip[side] = tipBetween(arriving, leaving, sign);
    }
    return division;
  }

  StraightestPath perpendicular(const SurfacePoint& point, const PointFan& fan,
                                double angle) const {
    angle -= fan.total * std::floor(angle / fan.total);
    const PointFan::Corner* corner = &fan.corners[0];
    for (const PointFan::Corner& one : fan.corners) {
      if (one.begin <= angle) corner = &one;
    }
    return traceStraightest(geometry_, inFace(mesh_, point, corner->face),
                            distance_ * unitVector(corner->inFrame + angle - corner->begin));
  }

  SurfacePath tipBetween(const StraightestPath& arriving, const StraightestPath& leaving,
                         double sign) const {
    const SurfacePoint& from = arriving.path.end();
    const SurfacePoint& to = leaving.path.end();
    const double limit = corners_.miterLimit;
    const double reach = distance_ * std::sqrt(std::max(limit * limit - 1, 0.0));
    if (corners_.shape == CornerShape::kMiter && reach > 0) {
      const auto sideOf = [&](const StraightestPath& end, double turn) {
        const Vec2 aside(-end.direction.y(), end.direction.x());
        return traceStraightest(geometry_, end.path.end(), turn * reach * aside).path;
      };
      const SurfacePath forward = sideOf(arriving, -sign);
      const SurfacePath backward = sideOf(leaving, sign);
      if (const std::optional<Meeting> meeting = meet(geometry_, forward, backward)) {
        Array<SurfacePoint> tip(forward.points.begin(), forward.points.begin() + meeting->first);
        tip.push_back(meeting->point);
        for (int j = meeting->second - 1; j >= 0; --j) tip.push_back(backward.points[j]);
        return pathThrough(mesh_, std::move(tip));
      }
    }
    FindPathWorkspace workspace;
    SurfacePath chord;
    findPath(geometry_, from, to, workspace, chord);
    return chord;
  }

  void addLine(SurfacePath path, int sides) {
    if (path.points.count() < 2) return;
    lines_.push_back(std::move(path));
    sideOf_.push_back(static_cast<uint8_t>(sides));
  }

  void addLines(const Division& division) {
    for (const Side side : {kLeftSide, kRightSide}) {
      const int bit = 1 << side;
      const int first = lines_.count();
      addLine(division.before[side], bit);
      addLine(division.after[side], bit);
      if (division.tip[side].points.count() < 2) continue;
      addLine(division.tip[side], bit);
      tips_.push_back({first, 3});
    }
  }

  /// Adds the piece of a path between two divisions. A null division stands for an end of the path.
  void addPiece(const SurfacePath& path, const Division* from, const Division* to) {
    Piece piece;
    piece.field =
        std::make_unique<PathDistance>(geometry_, std::span(&path, 1), kOffsetReach * distance_);
    piece.isOpenAtStart = from == nullptr;
    piece.isOpenAtEnd = to == nullptr;
    piece.start = position(mesh_, path.points.front());
    piece.end = position(mesh_, path.points.back());
    for (OffsetRun& run : offsetRuns(geometry_, *piece.field, distance_, distance_)) {
      if (run.side == SideOfPath::kEnd) {
        if (from == nullptr || to == nullptr) addLine(pathThrough(mesh_, run.points), 4);
        continue;
      }
      const Side side = run.side == SideOfPath::kLeft ? kLeftSide : kRightSide;
      for (int round = 0; round < 2 && !run.isClosed; ++round) {
        leadToEnd(run.points, from != nullptr ? &from->after[side] : nullptr,
                  to != nullptr ? &to->before[side] : nullptr);
        std::reverse(run.points.begin(), run.points.end());
      }
      addLine(pathThrough(mesh_, std::move(run.points)), 1 << side);
    }
    pieces_.push_back(std::move(piece));
    if (pieces_.size() * static_cast<uint64_t>(mesh_.vertexCount()) > kMostCorneredVertices) {
      throw Error(ErrorCode::kBadArgument,
                  "there are more than " + std::to_string(pieces_.size() - 1) +
                      " corners: on a surface of " + std::to_string(mesh_.vertexCount()) +
                      " vertices so many must be round");
    }
  }

  /// Leads the end of a run to the end of a perpendicular, where the side of the strip ends. Of the
  /// two perpendiculars, it is the first one that ends no farther from the run's last point than
  /// the longest chord is long. If neither does, the run stays as it is. A run that should end at a
  /// perpendicular misses its end by at most the height of a chord.
  void leadToEnd(Array<SurfacePoint>& run, const SurfacePath* one, const SurfacePath* other) const {
    for (const SurfacePath* end : {one, other}) {
      if (end == nullptr || run.count() < 3) continue;
      const Vec3 away = position(mesh_, end->end()) - position(mesh_, run.back());
      if (away.norm() > kLongestSide * distance_) continue;
      FindPathWorkspace workspace;
      SurfacePath path;
      if (!findPath(geometry_, run[run.count() - 2], end->end(), workspace, path)) continue;
      run.resize(run.size() - 2);
      run.insert(run.end(), path.points.begin(), path.points.end());
      return;
    }
  }

  Region covered(const Arrangement& all) const {
    Region region(static_cast<size_t>(all.cellCount()), 0);
    for (const PathRange& tip : tips_) {
      try {
        region = combined(region, enclosed(all, tip, FillRule::kEvenOdd), Boolean::kUnion);
      } catch (const Error& error) {
        // The lines of a tip may go around a handle of the surface that is no wider than the tip.
        // Then they enclose nothing.
        if (error.code() != ErrorCode::kBadArgument) throw;
      }
    }
    const Array<SurfacePoint> inside = pointsInside(geometry_, all);
    for (int c = 0; c < all.cellCount(); ++c) {
      for (const Piece& piece : pieces_) {
        if (region[c] != 0) break;
        region[c] = isInStrip(piece, inside[c]) ? 1 : 0;
      }
    }
    return region;
  }

  bool isInStrip(const Piece& piece, const SurfacePoint& point) const {
    const PathDistance::Distance there = piece.field->at(point);
    if (there.value > distance_) return false;
    if (there.side != SideOfPath::kEnd) return true;
    const Vec3 place = position(mesh_, point);
    const bool isAtStart = (place - piece.start).norm() < (place - piece.end).norm();
    return isAtStart ? piece.isOpenAtStart : piece.isOpenAtEnd;
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  double distance_;
  OffsetCorners corners_;
  std::vector<Piece> pieces_;
  Array<SurfacePath> lines_;
  /// the bits of each line: 1 on the left side, 2 on the right side, 4 around an end
  Array<uint8_t> sideOf_;
  Array<PathRange> tips_;
};

}  // namespace

Array<Isoline> corneredOffset(const Geometry& geometry, std::span<const SurfacePath> paths,
                              double distance, OffsetSide side, const OffsetCorners& corners) {
  if (!(corners.miterLimit >= 1)) {
    throw Error(ErrorCode::kBadArgument, "the limit of mitres must be a number of at least 1");
  }
  CorneredOffset offset(geometry, distance, corners);
  for (size_t i = 0; i < paths.size(); ++i) offset.add(paths[i], static_cast<int>(i));
  return offset.lines(side);
}

}  // namespace karcher

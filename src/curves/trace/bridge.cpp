#include "curves/trace/bridge.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "curves/trace/branches.h"
#include "intrinsic/surface_path.h"
#include "rcm/deepest_zero.h"

namespace karcher {
namespace {

/// A step is divided at most so often: enough for one over the whole of a large surface.
constexpr int kMostDivisions = 200'000;
/// Steps that wait for their turn: each division leaves one, and the finest is 2^-30.
constexpr int kMostWaiting = 32;
static_assert(kFinestDivision * (1 << (kMostWaiting - 2)) > 1);
/// Over a shorter part of the segment the scheme's curve is as good as its chord.
constexpr double kShortInterval = 1.0 / 32;
constexpr int kMostPieces = 8;
/// A step in a face that comes nearer to an edge than this part of its length may bend across it.
constexpr double kEdgeMargin = 0.25;

using Interval = BridgeWorkspace::Interval;

class JumpSearch {
 public:
  JumpSearch(FieldBlend& fields, const SegmentBasis& basis, const Array<double>& pointWeights,
             Method method, Array<double>& weights)
      : geometry_(fields.geometry()),
        mesh_(*geometry_.mesh),
        fields_(fields),
        basis_(basis),
        pointWeights_(pointWeights),
        method_(method),
        longest_(kLongestStep * geometry_.meanEdge),
        weights_(weights) {}

  /// Whether the way from one converged sample to the next breaks in either direction, and how.
  /// `middle`: the weights in the middle of it, or none.
  std::optional<SampleStatus> run(const CurveSample& from, const CurveSample& to, Weights middle) {
    if (!middle.empty() && isContinuous(from.point, to.point, middle)) return std::nullopt;
    bool differ = false;
    std::optional<SampleStatus> reason = follow(from, to, middle, Direction::kBoth, &differ);
    if (!differ) return reason;
    reason = follow(from, to, middle, Direction::kForwards);
    return reason ? reason : follow(from, to, middle, Direction::kBackwards);
  }

 private:
  /// Searches start at the earlier end of a step, at the later one, or at each of them as long as
  /// both find the same.
  enum class Direction { kForwards, kBackwards, kBoth };

  /// Follows the curve along a step. Of both directions: sets `differ` and stops where they find
  /// different centers. `middle`: the weights in the middle of the step where it is known that
  /// these do not tell, or none.
  std::optional<SampleStatus> follow(const CurveSample& from, const CurveSample& to, Weights middle,
                                     Direction direction, bool* differ = nullptr) {
    Step waiting[kMostWaiting];
    waiting[0] = {{from.t, from.point}, {to.t, to.point}};
    int steps = 1;
    for (int count = 0; steps > 0 && count < kMostDivisions; ++count) {
      const Step step = waiting[--steps];
      const Vec3 a = position(mesh_, step.from.point);
      const Vec3 b = position(mesh_, step.to.point);
      const double length = (b - a).norm();
      // A short step may hide a jump back that is a little longer.
      if (length <= longest_ / 2) continue;
      if (step.to.t - step.from.t <= kFinestDivision) {
        if (length > longest_) return SampleStatus::kJump;
        continue;
      }
      const double t = (step.from.t + step.to.t) / 2;
      Weights weights = middle;
      if (count > 0 || middle.empty()) {
        weightsAt(basis_, pointWeights_, t, weights_);
        weights = weights_;
        if (isContinuous(step.from.point, step.to.point, weights)) continue;
      }
      const bool backwards = direction == Direction::kBackwards;
      const SurfacePoint& start = backwards ? step.to.point : step.from.point;
      const CenterOfMass center = findCenter(fields_, weights, start, method_);
      if (direction == Direction::kBoth) {
        const CenterOfMass other = findCenter(fields_, weights, step.to.point, method_);
        if (other.status != center.status || other.point.face != center.point.face ||
            other.point.bary != center.point.bary) {
          *differ = true;
          return std::nullopt;
        }
      }
      if (center.status != Status::kConverged) return sampleStatus(center.status);
      waiting[steps++] = {step.from, {t, center.point}};
      waiting[steps++] = {{t, center.point}, step.to};
    }
    return steps == 0 ? std::nullopt : std::optional<SampleStatus>(SampleStatus::kJump);
  }

  struct Place {
    double t = 0;
    SurfacePoint point;
  };
  struct Step {
    Place from;
    Place to;
  };

  /// Whether the weights in the middle of a step tell that it does not break.
  bool isContinuous(const SurfacePoint& from, const SurfacePoint& to, Weights middle) const {
    return staysInCell(from, to, middle) || crossesAnEdge(from, to, middle);
  }

  /// In one cell the zero of the field moves continuously, and stays the center there if the step
  /// keeps away from the edges, so that no other cell has a deeper zero, and its middle, by the
  /// weights there, lies between its ends.
  bool staysInCell(const SurfacePoint& from, const SurfacePoint& to, Weights middleWeights) const {
    if (from.face != to.face) return false;
    const Cells& cells = fields_.cells();
    const CellPoint start = cells.at(from);
    const CellPoint end = cells.at(to);
    const int cell = start.cell;
    if (cell != end.cell) return false;
    const Vec3& a = start.bary;
    const Vec3& b = end.bary;
    const auto length = [&](const Vec3& off) {
      return lengthInFace(from.face, cells.inFace(cell, off));
    };
    const double margin = kEdgeMargin * length(b - a);
    const Vec3 least = a.cwiseMin(b);
    const double area = doubleArea(geometry_, from.face) / (cells.cut() ? 4 : 1);
    for (int k = 0; k < 3; ++k) {
      const double opposite = cells.cut()
                                  ? length(Vec3::Unit((k + 2) % 3) - Vec3::Unit((k + 1) % 3))
                                  : geometry_.edgeLength[3 * from.face + (k + 1) % 3];
      if (least[k] * area / opposite < margin) return false;
    }
    CellZero zero;
    if (!fields_.findZero(cell, middleWeights, zero)) return false;
    if (!isTheOnlyZero(zero, std::min(least.minCoeff(), zero.depth()) / 2) &&
        !turnsBesideNoEdge(zero)) {
      return false;
    }
    return length(zero.bary - (a + b) / 2) < margin;
  }

  /// From one face into the next over the edge between them: where the zeros of both faces' fields
  /// in the middle lie side by side, between the ends of the step and away from the other edges,
  /// the zero passes from one to the other without a jump.
  bool crossesAnEdge(const SurfacePoint& from, const SurfacePoint& to,
                     Weights middleWeights) const {
    if (fields_.cells().cut() || from.face == to.face) return false;
    int h = 3 * from.face;
    const int end = h + 3;
    while (h < end && (mesh_.twin[h] < 0 || faceOf(mesh_.twin[h]) != to.face)) ++h;
    if (h == end) return false;
    const int twin = mesh_.twin[h];
    const Vec2 a = besideEdge(h, from.bary);
    const Vec2 b = acrossEdge(twin, to.bary);
    const double margin = kEdgeMargin * (b - a).norm();
    CellZero zeroA;
    CellZero zeroB;
    if (keptOff(h, from.bary) < margin || keptOff(twin, to.bary) < margin ||
        !fields_.findZero(from.face, middleWeights, zeroA) ||
        !fields_.findZero(to.face, middleWeights, zeroB)) {
      return false;
    }
    const Vec2 middleA = besideEdge(h, zeroA.bary);
    const Vec2 middleB = acrossEdge(twin, zeroB.bary);
    return (middleA - middleB).norm() <= longest_ / 4 && (middleA - (a + b) / 2).norm() < margin &&
           (middleB - (a + b) / 2).norm() < margin && keptOff(h, zeroA.bary) >= margin &&
           keptOff(twin, zeroB.bary) >= margin && isAlone(h, zeroA) && isAlone(twin, zeroB) &&
           gapAtEdge(h, zeroA) <= longest_ / 2;
  }

  /// How far apart the zeros of both faces lie where the zero comes to half-edge h, at most. In the
  /// other face the values at the ends are turned relative to each other (CellZero::holonomy);
  /// where they point against each other, and so cancel out at the edge, what is left is at right
  /// angles to them.
  double gapAtEdge(int h, const CellZero& zero) const {
    const Vec2& tail = zero.field.corner[cornerOf(h)];
    const Vec2& head = zero.field.corner[cornerOf(next(h))];
    const double both = tail.norm() + head.norm();
    if (!(both > 0)) return 0;
    const Vec2 left = Vec2(-tail.y(), tail.x()) * (zero.holonomy * head.norm() / both);
    const Vec2 b = zero.field.corner[1] - zero.field.corner[0];
    const Vec2 c = zero.field.corner[2] - zero.field.corner[0];
    const double scale = 1 / cross(b, c);
    const double along = cross(left, c) * scale;
    const double up = cross(b, left) * scale;
    return lengthInFace(faceOf(h), {-along - up, along, up});
  }

  /// A point of a half-edge's face, which may lie beyond it, with the half-edge as x axis.
  Vec2 besideEdge(int h, const Vec3& bary) const {
    const int face = faceOf(h);
    return rotateBack(
        halfedgeInFace(geometry_, h).normalized(),
        pointInFace(geometry_, {face, bary}) - cornerInFace(geometry_, face, cornerOf(h)));
  }

  /// The same in the frame of the half-edge's twin.
  Vec2 acrossEdge(int h, const Vec3& bary) const {
    return Vec2(geometry_.edgeLength[h], 0) - besideEdge(h, bary);
  }

  /// How far a point of a half-edge's face lies from the lines of the other two edges.
  double keptOff(int h, const Vec3& bary) const {
    const double area = doubleArea(geometry_, faceOf(h));
    const int edges[] = {next(h), previous(h)};
    return std::min(bary[cornerOf(h)] * area / geometry_.edgeLength[edges[0]],
                    bary[cornerOf(next(h))] * area / geometry_.edgeLength[edges[1]]);
  }

  /// Whether no face over the other two edges can have a zero as well.
  static bool isAlone(int h, const CellZero& zero) {
    return isTheOnlyZero(zero, std::min(zero.bary[cornerOf(h)], zero.bary[cornerOf(next(h))]) / 2);
  }

  /// Whether the values at the ends of each edge make angles so far from 0 and pi that no face
  /// beside has a zero, nor would if they turned as much again (isTheOnlyZero).
  static bool turnsBesideNoEdge(const CellZero& zero) {
    constexpr double kRoom = 2;
    const double bound = kRoom * kRoom * zero.holonomy * zero.holonomy;
    for (int k = 0; k < 3; ++k) {
      const Vec2& a = zero.field.corner[k];
      const Vec2& b = zero.field.corner[(k + 1) % 3];
      const double sine = cross(a, b);
      if (!(sine * sine > bound * a.squaredNorm() * b.squaredNorm())) return false;
    }
    return true;
  }

  /// Of a difference of barycentric weights.
  double lengthInFace(int face, const Vec3& off) const {
    const Vec2 vector =
        off[1] * cornerInFace(geometry_, face, 1) + off[2] * cornerInFace(geometry_, face, 2);
    return vector.norm();
  }

  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  FieldBlend& fields_;
  const SegmentBasis& basis_;
  const Array<double>& pointWeights_;
  Method method_;
  double longest_;
  Array<double>& weights_;
};

bool isConverged(const CurveSample& sample) { return sample.status == SampleStatus::kConverged; }

/// The steps between converged samples that break.
void findJumps(JumpSearch& search, const PieceWeights* table, const Array<CurveSample>& samples,
               Array<std::pair<int, SampleStatus>>& jumps) {
  jumps.clear();
  for (int i = 0; i + 1 < samples.count(); ++i) {
    if (!isConverged(samples[i]) || !isConverged(samples[i + 1])) continue;
    const std::optional<SampleStatus> reason =
        search.run(samples[i], samples[i + 1], table ? table->middles.row(i) : Weights());
    if (reason) jumps.emplace_back(i, *reason);
  }
}

/// Appends an interval, as one with the last where they meet.
void addInterval(Array<Interval>& intervals, const Interval& interval) {
  if (!intervals.empty() && intervals.back().last >= interval.first) {
    intervals.back().last = interval.last;
    intervals.back().keepsLast = interval.keepsLast;
  } else {
    intervals.push_back(interval);
  }
}

void findIntervals(const Array<CurveSample>& samples,
                   const Array<std::pair<int, SampleStatus>>& jumps, Array<Interval>& intervals) {
  intervals.clear();
  const int count = samples.count();
  auto jump = jumps.begin();
  for (int i = 0; i < count; ++i) {
    if (samples[i].status != SampleStatus::kConverged) {
      int end = i;
      while (end < count && samples[end].status != SampleStatus::kConverged) ++end;
      addInterval(intervals, {std::max(i - 1, 0), std::min(end, count - 1), i > 0, end < count,
                              samples[i].status});
      i = end;
    }
    if (jump != jumps.end() && jump->first == i) {
      addInterval(intervals, {i, i + 1, true, true, jump->second});
      ++jump;
    }
  }
}

/// Lays bridges over one segment.
class BridgeBuilder {
 public:
  BridgeBuilder(const Geometry& geometry, const Array<PointField*>& points,
                const SegmentBasis& basis, const Array<double>& pointWeights,
                BridgeWorkspace& workspace)
      : geometry_(geometry),
        basis_(basis),
        pointWeights_(pointWeights),
        nodes_(nodesOf(basis)),
        workspace_(workspace),
        averaging_(workspace.subdivision),
        points_(workspace.points) {
    points_.clear();
    for (const PointField* point : points) points_.push_back(point->point());
  }

  /// The line between the ends; null ones are the scheme's own. Between neighbouring samples it is
  /// straight.
  const ParametricLine& build(double t0, double t1, const SurfacePoint* from,
                              const SurfacePoint* to, bool betweenNeighbours) {
    ParametricLine& line = workspace_.line;
    line.t.clear();
    line.path.points.clear();
    line.path.lengths.clear();
    double start = t0;
    for (const double node : nodes_) {
      if (!(node > t0 && node < t1)) continue;
      weightsAt(basis_, pointWeights_, node, workspace_.weights);
      const SurfacePoint& passed = points_[heaviest(workspace_.weights)];
      append(start, node, from, &passed, betweenNeighbours, line);
      start = node;
      from = &passed;
    }
    append(start, t1, from, to, betweenNeighbours, line);
    return line;
  }

 private:
  void append(double t0, double t1, const SurfacePoint* from, const SurfacePoint* to,
              bool betweenNeighbours, ParametricLine& line) {
    if (from != nullptr && to != nullptr && (betweenNeighbours || t1 - t0 <= kShortInterval)) {
      const SurfacePoint ends[] = {*from, *to};
      appendBezier(geometry_, ends, t0, t1, averaging_, line);
      return;
    }
    Array<SurfacePoint>& polygon = workspace_.polygon;
    makePolygon(t0, t1, polygon);
    pullEnds(polygon, from, to);
    const int pieces = (polygon.count() - 1) / 3;
    for (int j = 0; j < pieces; ++j) {
      appendBezier(geometry_, std::span(polygon).subspan(static_cast<size_t>(3 * j), 4),
                   t0 + (t1 - t0) * j / pieces, t0 + (t1 - t0) * (j + 1) / pieces, averaging_,
                   line);
    }
    line.t.back() = t1;
  }

  /// The control points of cubic pieces one after the other, ends shared.
  void makePolygon(double t0, double t1, Array<SurfacePoint>& polygon) {
    const double wanted = (t1 - t0) * (points_.count() - 1) / 3;
    const int pieces =
        points_.count() <= 4 ? 1 : std::clamp(static_cast<int>(std::ceil(wanted)), 1, kMostPieces);
    polygon.clear();
    for (int j = 0; j < pieces; ++j) {
      findBezierWeights(t0 + (t1 - t0) * j / pieces, t0 + (t1 - t0) * (j + 1) / pieces);
      for (size_t k = j == 0 ? 0 : 1; k < 4; ++k) {
        polygon.push_back(repeatedAverage(geometry_, points_, workspace_.bezier[k], averaging_));
      }
    }
  }

  /// The weights of the control points of the cubic Bezier curve that interpolates the basis at
  /// four parameters of [t0, t1]: the curve itself where the basis is of degree 3 at most.
  void findBezierWeights(double t0, double t1) {
    auto& [first, second, third, last] = workspace_.bezier;
    weightsAt(basis_, pointWeights_, t0, first);
    weightsAt(basis_, pointWeights_, t0 + (t1 - t0) / 3, second);
    weightsAt(basis_, pointWeights_, t0 + (t1 - t0) * 2 / 3, third);
    weightsAt(basis_, pointWeights_, t1, last);
    for (int i = 0; i < first.count(); ++i) {
      const double b = second[i];
      const double c = third[i];
      second[i] = (-5 * first[i] + 18 * b - 9 * c + 2 * last[i]) / 6;
      third[i] = (2 * first[i] - 9 * b + 18 * c - 5 * last[i]) / 6;
    }
  }

  /// Moves the polygon's ends to the given points. The farther these are, as a part of the
  /// polygon's length, the nearer come its other points to the path between the ends, so that a
  /// short bridge makes no long way round.
  void pullEnds(Array<SurfacePoint>& polygon, const SurfacePoint* from, const SurfacePoint* to) {
    double length = 0;
    for (int i = 1; i < polygon.count(); ++i) length += distance(polygon[i - 1], polygon[i]);
    double pull = 0;
    if (from != nullptr) pull += distance(polygon.front(), *from);
    if (to != nullptr) pull += distance(polygon.back(), *to);
    if (!(pull > 0)) return;
    if (from != nullptr) polygon.front() = *from;
    if (to != nullptr) polygon.back() = *to;
    SurfacePath& chord = workspace_.chord;
    geodesicLine(geometry_, polygon.front(), polygon.back(), averaging_.geodesics, chord);
    const double kept = length / (length + pull);
    const int last = polygon.count() - 1;
    for (int i = 1; i < last; ++i) {
      const SurfacePoint onChord = pointAlong(*geometry_.mesh, chord, chord.length() * i / last);
      polygon[i] = averageAlongGeodesic(geometry_, onChord, polygon[i], kept, averaging_);
    }
  }

  double distance(const SurfacePoint& a, const SurfacePoint& b) {
    geodesicLine(geometry_, a, b, averaging_.geodesics, averaging_.line);
    return averaging_.line.length();
  }

  const Geometry& geometry_;
  const SegmentBasis& basis_;
  const Array<double>& pointWeights_;
  const Array<double> nodes_;
  BridgeWorkspace& workspace_;
  SubdivisionWorkspace& averaging_;
  Array<SurfacePoint>& points_;
};

/// Appends a bridge, in the memory of one that is spare.
Bridge& addBridge(Array<Bridge>& spare, Array<Bridge>& bridges) {
  if (spare.empty()) return bridges.emplace_back();
  bridges.push_back(std::move(spare.back()));
  spare.pop_back();
  return bridges.back();
}

}  // namespace

SurfacePoint pointAt(const TriangleMesh& mesh, const Bridge& bridge, double t) {
  const ParametricLine& line = bridge.line;
  const auto after = std::upper_bound(line.t.begin() + 1, line.t.end() - 1, t);
  const int i = static_cast<int>(after - line.t.begin());
  const double duration = line.t[i] - line.t[i - 1];
  const double s = duration > 0 ? std::clamp((t - line.t[i - 1]) / duration, 0.0, 1.0) : 1;
  return pointBetween(mesh, line.path.points[i - 1], line.path.points[i], s);
}

void appendPart(const TriangleMesh& mesh, const Bridge& bridge, double from, double to,
                Array<SurfacePoint>& out) {
  const ParametricLine& line = bridge.line;
  const auto first = std::upper_bound(line.t.begin(), line.t.end(), from) - line.t.begin();
  for (int i = static_cast<int>(first); i < line.t.count() && line.t[i] < to; ++i) {
    out.push_back(line.path.points[i]);
  }
  out.push_back(pointAt(mesh, bridge, to));
}

const Bridge* bridgeOver(const Array<Bridge>& bridges, double t) {
  for (const Bridge& bridge : bridges) {
    if (bridge.t0 <= t && t <= bridge.t1) return &bridge;
  }
  return nullptr;
}

void bridgeSegment(SegmentFields& fields, const SegmentBasis& basis,
                   const Array<double>& pointWeights, const PieceWeights* table, Method method,
                   Array<CurveSample>& samples, BridgeWorkspace& workspace,
                   Array<Bridge>& bridges) {
  std::move(bridges.begin(), bridges.end(), std::back_inserter(workspace.spare));
  bridges.clear();
  JumpSearch search(fields.blend, basis, pointWeights, method, workspace.weights);
  findJumps(search, table, samples, workspace.jumps);
  const bool isWhole =
      workspace.jumps.empty() && std::all_of(samples.begin(), samples.end(), isConverged);
  if (isWhole) return;
  // Samples that a tolerance placed are dense enough for the branch that they follow; the paper's
  // method is from start to end.
  if (table != nullptr && method == Method::kKarcher) {
    takeBestBranches(fields, table->samples, method, samples, workspace.back);
    findJumps(search, table, samples, workspace.jumps);
  }
  const Geometry& geometry = fields.blend.geometry();
  BridgeBuilder builder(geometry, fields.points, basis, pointWeights, workspace);
  findIntervals(samples, workspace.jumps, workspace.intervals);
  for (const Interval& interval : workspace.intervals) {
    CurveSample& first = samples[interval.first];
    CurveSample& last = samples[interval.last];
    Bridge& bridge = addBridge(workspace.spare, bridges);
    bridge.t0 = first.t;
    bridge.t1 = last.t;
    bridge.reason = interval.reason;
    const ParametricLine& line = builder.build(
        bridge.t0, bridge.t1, interval.keepsFirst ? &first.point : nullptr,
        interval.keepsLast ? &last.point : nullptr, interval.last - interval.first == 1);
    makeRoom(line.t.size(), bridge.line.path);
    bridge.line.t.reserve(bridge.line.path.points.capacity());
    bridge.line = line;
    for (int i = interval.first; i <= interval.last; ++i) {
      if (i == interval.first && interval.keepsFirst) continue;
      if (i == interval.last && interval.keepsLast) continue;
      samples[i].point = pointAt(*geometry.mesh, bridge, samples[i].t);
      samples[i].status = SampleStatus::kBridged;
    }
  }
}

}  // namespace karcher

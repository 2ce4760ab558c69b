#include "curves/trace/bridge.h"

#include <algorithm>

#include "curves/trace/branches.h"
#include "intrinsic/surface_path.h"

namespace karcher {
namespace {

/// In an interval of t up to this length, the subdivision curve is no better than its chord.
constexpr double kShortInterval = 1.0 / 32;
constexpr int kMostPieces = 8;

using Interval = BridgeWorkspace::Interval;

/// Appends an interval, or merges it with the last one if they touch.
void addInterval(Array<Interval>& intervals, const Interval& interval) {
  if (!intervals.empty() && intervals.back().last >= interval.first) {
    intervals.back().last = interval.last;
    intervals.back().keepsLast = interval.keepsLast;
  } else {
    intervals.push_back(interval);
  }
}

void findIntervals(const Array<CurveSample>& samples, const Array<Jump>& jumps,
                   Array<Interval>& intervals) {
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
    if (jump != jumps.end() && jump->step == i) {
      addInterval(intervals, {i, i + 1, true, true, jump->reason});
      ++jump;
    }
  }
}

/// Builds the bridges of one segment.
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

  /// Builds the line between two ends. A null end stands for the end of the subdivision curve.
  /// Between neighbouring samples the line is straight.
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

  /// Writes the control points of consecutive cubic pieces, which share their ends.
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

  /// Finds the weights of the segment's points for each control point of a cubic Bezier curve. This
  /// curve interpolates the basis at four parameters of [t0, t1]. It reproduces a polynomial basis
  /// of degree at most 3 exactly.
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

  /// Moves the polygon's ends to the given points. The other points move towards the path between
  /// the ends, by an amount that grows with the motion of the ends relative to the polygon's
  /// length. So a short bridge has no long detour.
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
    findPath(geometry_, polygon.front(), polygon.back(), averaging_.paths, chord);
    const double kept = length / (length + pull);
    const int last = polygon.count() - 1;
    for (int i = 1; i < last; ++i) {
      const SurfacePoint onChord = pointAlong(*geometry_.mesh, chord, chord.length() * i / last);
      polygon[i] = averageAlongGeodesic(geometry_, onChord, polygon[i], kept, averaging_);
    }
  }

  double distance(const SurfacePoint& a, const SurfacePoint& b) {
    findPath(geometry_, a, b, averaging_.paths, averaging_.line);
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
  bridges.clear();
  const auto lookForJumps = [&] {
    findJumps(fields.blend, basis, pointWeights, table, method, samples, workspace.weights,
              workspace.jumps);
  };
  lookForJumps();
  const bool isWhole =
      workspace.jumps.empty() && std::all_of(samples.begin(), samples.end(), isConverged);
  if (isWhole) return;
  // Adaptive samples (no table) skip this step, since they are dense enough only for the branch
  // that they follow. The paper's method skips it, too: its result depends on the start of the
  // search and not on a branch.
  if (table != nullptr && goesOnWhereIndefinite(method)) {
    takeBestBranches(fields, table->samples, method, samples, workspace.back);
    lookForJumps();
  }
  const Geometry& geometry = fields.blend.geometry();
  BridgeBuilder builder(geometry, fields.points, basis, pointWeights, workspace);
  findIntervals(samples, workspace.jumps, workspace.intervals);
  for (const Interval& interval : workspace.intervals) {
    CurveSample& first = samples[interval.first];
    CurveSample& last = samples[interval.last];
    Bridge& bridge = bridges.emplace_back();
    bridge.t0 = first.t;
    bridge.t1 = last.t;
    bridge.reason = interval.reason;
    const ParametricLine& line = builder.build(
        bridge.t0, bridge.t1, interval.keepsFirst ? &first.point : nullptr,
        interval.keepsLast ? &last.point : nullptr, interval.last - interval.first == 1);
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

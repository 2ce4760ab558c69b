#include "curves/trace/jumps.h"

#include <algorithm>
#include <optional>

#include "mesh/rounding.h"
#include "rcm/deepest_zero.h"

namespace karcher {
namespace {

/// The largest number of divisions of a step. It suffices for a step across a large surface.
constexpr int kMostDivisions = 200'000;
/// The least distance of a step from an edge, relative to the length of the step. A step that comes
/// nearer may bend across the edge.
constexpr double kEdgeMargin = 0.25;

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

  /// The reason why the curve between two converged samples breaks, in either direction; empty if
  /// it does not break. `middle` has the weights in the middle, or is empty.
  std::optional<SampleStatus> run(const CurveSample& from, const CurveSample& to, Weights middle) {
    if (!middle.empty() && isContinuous(from.point, to.point, middle)) return std::nullopt;
    bool differ = false;
    std::optional<SampleStatus> reason = follow(from, to, middle, Direction::kBoth, &differ);
    if (!differ) return reason;
    reason = follow(from, to, middle, Direction::kForwards);
    return reason ? reason : follow(from, to, middle, Direction::kBackwards);
  }

 private:
  /// Searches start at the earlier end of a step, at the later one, or at both as long as both find
  /// the same center.
  enum class Direction { kForwards, kBackwards, kBoth };

  /// Follows the curve along a step. With kBoth, it sets `differ` and stops where the searches find
  /// different centers. `middle` has the weights in the middle of the step if they are known to be
  /// inconclusive, or is empty.
  std::optional<SampleStatus> follow(const CurveSample& from, const CurveSample& to, Weights middle,
                                     Direction direction, bool* differ = nullptr) {
    waiting_.assign(1, {{from.t, from.point}, {to.t, to.point}});
    for (int count = 0; !waiting_.empty() && count < kMostDivisions; ++count) {
      const Step step = waiting_.back();
      waiting_.pop_back();
      const Vec3 a = position(mesh_, step.from.point);
      const Vec3 b = position(mesh_, step.to.point);
      const double length = (b - a).norm();
      // The limit is half of the longest step. The curve may jump back against its motion within a
      // step, and this jump is a little longer than the step.
      if (length <= longest_ / 2) continue;
      if (step.to.t - step.from.t <= kChainRounding) {
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
      const SearchEnd center = findCenter(fields_, weights, start, method_);
      if (direction == Direction::kBoth) {
        const SearchEnd other = findCenter(fields_, weights, step.to.point, method_);
        if (other.status != center.status || other.point.face != center.point.face ||
            other.point.bary != center.point.bary) {
          *differ = true;
          return std::nullopt;
        }
      }
      if (center.status != Status::kConverged) return sampleStatus(center.status);
      waiting_.push_back({step.from, {t, center.point}});
      waiting_.push_back({{t, center.point}, step.to});
    }
    return waiting_.empty() ? std::nullopt : std::optional<SampleStatus>(SampleStatus::kJump);
  }

  struct Place {
    double t = 0;
    SurfacePoint point;
  };
  struct Step {
    Place from;
    Place to;
  };

  /// Whether the weights in the middle of a step prove that it does not break.
  bool isContinuous(const SurfacePoint& from, const SurfacePoint& to, Weights middle) const {
    return staysInCell(from, to, middle) || crossesAnEdge(from, to, middle);
  }

  /// Whether the zero of the field in one cell moves continuously and stays the center. It does if
  /// the step keeps away from the edges, so that no other cell has a deeper zero, and if the zero
  /// for the weights in the step's middle lies between the step's ends.
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

  /// Whether the zero passes from one face into the next without a jump. It does if the weights in
  /// the middle of the step give the fields of both faces zeros that lie side by side, between the
  /// ends of the step and away from the other edges.
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

  /// The largest distance between the zeros of both faces when the zero reaches half-edge h. There
  /// the values at the ends of h are opposite and cancel. The faces turn these values relative to
  /// each other (CellZero::holonomy), so that a component perpendicular to them remains and
  /// separates the zeros.
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

  /// A point in the plane of a half-edge's face, in the frame whose x axis is the half-edge.
  Vec2 besideEdge(int h, const Vec3& bary) const {
    const int face = faceOf(h);
    return rotateBack(
        halfedgeInFace(geometry_, h).normalized(),
        pointInFace(geometry_, {face, bary}) - cornerInFace(geometry_, face, cornerOf(h)));
  }

  /// The same as `besideEdge`, but in the frame of the half-edge's twin.
  Vec2 acrossEdge(int h, const Vec3& bary) const {
    return Vec2(geometry_.edgeLength[h], 0) - besideEdge(h, bary);
  }

  /// The smaller one of a point's distances from two lines: those along the other two edges of the
  /// half-edge's face.
  double keptOff(int h, const Vec3& bary) const {
    const double area = doubleArea(geometry_, faceOf(h));
    const int edges[] = {next(h), previous(h)};
    return std::min(bary[cornerOf(h)] * area / geometry_.edgeLength[edges[0]],
                    bary[cornerOf(next(h))] * area / geometry_.edgeLength[edges[1]]);
  }

  /// Whether no face across the other two edges can have a zero.
  static bool isAlone(int h, const CellZero& zero) {
    return isTheOnlyZero(zero, std::min(zero.bary[cornerOf(h)], zero.bary[cornerOf(next(h))]) / 2);
  }

  /// Whether no adjacent face has a zero, by a margin. The angle between the values at the ends of
  /// each edge must be so far from 0 and pi that no zero would appear if the values turned twice as
  /// much as they may (isTheOnlyZero).
  static bool turnsBesideNoEdge(const CellZero& zero) {
    const double bound = square(2 * zero.holonomy);
    for (int k = 0; k < 3; ++k) {
      const Vec2& a = zero.field.corner[k];
      const Vec2& b = zero.field.corner[(k + 1) % 3];
      const double sine = cross(a, b);
      if (!(sine * sine > bound * a.squaredNorm() * b.squaredNorm())) return false;
    }
    return true;
  }

  /// The length of a difference of barycentric weights.
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
  Array<Step> waiting_;
};

}  // namespace

void findJumps(FieldBlend& fields, const SegmentBasis& basis, const Array<double>& pointWeights,
               const PieceWeights* table, Method method, const Array<CurveSample>& samples,
               Array<double>& weights, Array<Jump>& jumps) {
  JumpSearch search(fields, basis, pointWeights, method, weights);
  jumps.clear();
  for (int i = 0; i + 1 < samples.count(); ++i) {
    if (!isConverged(samples[i]) || !isConverged(samples[i + 1])) continue;
    const std::optional<SampleStatus> reason =
        search.run(samples[i], samples[i + 1], table ? table->middles.row(i) : Weights());
    if (reason) jumps.push_back({i, *reason});
  }
}

}  // namespace karcher

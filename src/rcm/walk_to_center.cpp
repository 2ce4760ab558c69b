#include "rcm/walk_to_center.h"

#include <algorithm>
#include <optional>

#include "intrinsic/straightest.h"
#include "mesh/rounding.h"
#include "rcm/deepest_zero.h"

namespace karcher {
namespace {

constexpr int kMaxFaces = 400;
constexpr int kMostDescents = 60;
/// the longest step of a descent, relative to the mesh's extent
constexpr double kLongestDescent = 0.5;
/// The least weight of a zero that counts as near. If a weight is smaller, the zero is distant, and
/// the search descends before it walks.
constexpr double kFarWeight = -6;

int smallestCorner(const Vec3& b) {
  return b[0] < b[1] ? (b[0] < b[2] ? 0 : 2) : (b[1] < b[2] ? 1 : 2);
}

/// The zero of a cell's field; empty if the Hessian is not positive definite.
std::optional<CellZero> zeroOfCell(FieldBlend& fields, Weights weights, int cell) {
  CellZero zero;
  if (!fields.findZero(cell, weights, zero)) return std::nullopt;
  return zero;
}

/// The zero in a cell or on an edge around the tail of a half-edge; the tail itself if there is no
/// such zero. The result does not depend on the cell from which the search came.
SearchEnd centerAroundTail(FieldBlend& fields, Weights weights, int halfedge) {
  const Cells& cells = fields.cells();
  const int first = cells.firstAround(halfedge);
  bool definite = true;
  double nearest = -kInfinity;
  for (const int h : HalfedgesAround<Cells>(cells, first)) {
    const std::optional<CellZero> zero = zeroOfCell(fields, weights, faceOf(h));
    definite = definite && zero;
    if (zero) {
      nearest = std::max(nearest, zero->depth());
      if (zero->depth() >= -kInsideTolerance) {
        return {deepestZero(fields, weights, faceOf(h), *zero), Status::kConverged, 0};
      }
    }
  }
  if (!definite) return {cells.tailOf(first), Status::kIndefinite, 0};

  // Among zeros between two cells, the zero farthest from the ends of its edge counts.
  double farthest = 0;
  SurfacePoint between;
  for (const int h : HalfedgesAround<Cells>(cells, first)) {
    const int twin = cells.twin(h);
    if (twin < 0) continue;
    const Vec3 left = zeroOfCell(fields, weights, faceOf(h))->bary;
    const Vec3 right = zeroOfCell(fields, weights, faceOf(twin))->bary;
    const double s = fields.zeroAlongEdge(h, weights);
    if (left[cornerOf(previous(h))] < 0 && right[cornerOf(previous(twin))] < 0 &&
        std::min(s, 1 - s) > farthest) {
      farthest = std::min(s, 1 - s);
      between = cells.pointOnEdge(h, s);
    }
  }
  if (farthest > 0) return {between, Status::kConverged, 0};

  // The largest distance, relative to an edge, by which the field's discontinuity moves a zero.
  constexpr double kMostMoved = 0.5;
  const Status status = cells.twin(first) < 0    ? Status::kBoundary
                        : nearest >= -kMostMoved ? Status::kConverged
                                                 : Status::kNoProgress;
  return {cells.tailOf(first), status, 0};
}

class ZeroWalk {
 public:
  ZeroWalk(FieldBlend& fields, Weights weights)
      : fields_(fields), geometry_(fields.geometry()), cells_(fields.cells()), weights_(weights) {}

  /// Searches from a point; `zero` is the zero of the point's cell, if known.
  SearchEnd run(const SurfacePoint& start, const std::optional<CellZero>& zero) {
    if (zero && zero->depth() >= kFarWeight) return walk(start, zero);
    const SurfacePoint near = descend(start);
    SearchEnd result = walk(near, zeroOfCell(fields_, weights_, cells_.at(near).cell));
    result.iterations += descents_;
    return result;
  }

 private:
  /// Gradient descent by the natural step, p <- exp_p(sum_i w_i log_p(p_i)), until the zero is
  /// near.
  SurfacePoint descend(SurfacePoint point) {
    int crossingsLeft = mostCrossingsOfSearch(*geometry_.mesh);
    while (descents_ < kMostDescents && crossingsLeft > 0) {
      ++descents_;
      // Without a bound on the step, weights far from 0 and 1 would lead to steps that wind around
      // the surface many times.
      const Vec2 wanted = -fields_.at(point, weights_) / 2;
      const Vec2 step = wanted * std::min(1.0, kLongestDescent * geometry_.extent / wanted.norm());
      StraightestPath& way = fields_.step();
      traceStraightest(geometry_, point, step, way, {.maxCrossings = crossingsLeft});
      crossingsLeft -= way.path.points.count() / 2;
      point = way.path.end();
      const std::optional<CellZero> zero = zeroOfCell(fields_, weights_, cells_.at(point).cell);
      if (zero && zero->depth() > kFarWeight) break;
      if (step.norm() < 1e-3 * geometry_.meanEdge) break;
    }
    return point;
  }

  /// Walks from a point near the zero; `zero` is the zero of the point's cell.
  SearchEnd walk(const SurfacePoint& start, std::optional<CellZero> zero) {
    const int first = cells_.at(start).cell;
    int cell = first;
    int history[kHistory];
    for (int step = 1; step <= kMaxFaces; ++step) {
      if (step > 1) zero = zeroOfCell(fields_, weights_, cell);
      if (!zero) return {cell == first ? start : centroid(cell), Status::kIndefinite, step};
      const int corner = smallestCorner(zero->bary);
      if (zero->bary[corner] >= -kInsideTolerance) {
        return {deepestZero(fields_, weights_, cell, *zero), Status::kConverged, step};
      }
      const int h = exitEdge(cell, zero->bary, corner);
      const int twin = cells_.twin(h);
      if (twin < 0) {
        return {cells_.pointOnEdge(h, fields_.zeroAlongEdge(h, weights_)), Status::kBoundary, step};
      }
      const int onward = faceOf(twin);
      if (step > 1 && onward == history[(step - 2) % kHistory]) return betweenFaces(h, step);
      const int known = std::min(step - 1, kHistory);
      if (std::find(history, history + known, onward) != history + known) {
        SearchEnd result = centerAroundTail(fields_, weights_, 3 * cell + largest(zero->bary));
        result.iterations = step;
        return result;
      }
      history[(step - 1) % kHistory] = cell;
      cell = onward;
    }
    return {centroid(cell), Status::kLimit, kMaxFaces};
  }

  /// The zero between two cells, if the zero of each cell lies beyond the common edge.
  SearchEnd betweenFaces(int h, int step) {
    SearchEnd result = centerBetween(fields_, weights_, h);
    result.iterations = step;
    return result;
  }

  /// The edge beyond which the zero lies farthest. It is a boundary edge only if the zero lies
  /// beyond no interior edge.
  int exitEdge(int cell, const Vec3& zero, int corner) const {
    const int h = 3 * cell + (corner + 1) % 3;
    if (cells_.twin(h) >= 0) return h;
    int best = h;
    double weight = 0;
    for (int k = 0; k < 3; ++k) {
      const int other = 3 * cell + (k + 1) % 3;
      if (zero[k] < weight && cells_.twin(other) >= 0) {
        weight = zero[k];
        best = other;
      }
    }
    return best;
  }

  static int largest(const Vec3& b) {
    return b[0] > b[1] ? (b[0] > b[2] ? 0 : 2) : (b[1] > b[2] ? 1 : 2);
  }

  SurfacePoint centroid(int cell) const { return cells_.point(cell, Vec3::Constant(1.0 / 3)); }

  /// The number of cells that the walk remembers. If the walk returns to a remembered cell, the
  /// zero lies between faces.
  static constexpr int kHistory = 16;

  FieldBlend& fields_;
  const Geometry& geometry_;
  const Cells& cells_;
  Weights weights_;
  int descents_ = 0;
};

SearchEnd walkThroughCuts(FieldBlend& fields, Weights weights, const SurfacePoint& start) {
  return ZeroWalk(fields, weights)
      .run(start, zeroOfCell(fields, weights, fields.cells().at(start).cell));
}

}  // namespace

SearchEnd centerBetween(FieldBlend& fields, Weights weights, int h) {
  const double s = fields.zeroAlongEdge(h, weights);
  if (s > 0 && s < 1) return {fields.cells().pointOnEdge(h, s), Status::kConverged, 0};
  return centerAroundTail(fields, weights, s > 0 ? next(h) : h);
}

bool isZero(FieldBlend& fields, Weights weights, const SurfacePoint& point) {
  // The fields' rounding is relative to the sum of absolute weights, which may be far larger than
  // 1.
  double sum = 0;
  for (const double weight : weights) sum += std::abs(weight);
  const Vec2 gradient = fields.at(point, weights);
  if (!(gradient.norm() <= kLocalRounding * sum * fields.geometry().diagonal)) return false;
  return zeroOfCell(fields, weights, fields.cells().at(point).cell).has_value();
}

SearchEnd walkToCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start) {
  if (fields.cells().cut()) return walkThroughCuts(fields, weights, start);
  // Fast path: most samples of a curve lie in the face of the previous sample, and no other zero is
  // near.
  CellZero zero;
  if (!fields.findZero(start.face, weights, zero)) {
    return ZeroWalk(fields, weights).run(start, std::nullopt);
  }
  const double depth = zero.depth();
  if (depth >= -kInsideTolerance && isTheOnlyZero(zero, depth)) {
    return {clampedPoint(start.face, zero.bary), Status::kConverged, 1};
  }
  return ZeroWalk(fields, weights).run(start, zero);
}

}  // namespace karcher

#include "rcm/deepest_zero.h"

#include <algorithm>

#include "rcm/walk_to_center.h"

namespace karcher {
namespace {

class DeepestZero {
 public:
  DeepestZero(FieldBlend& fields, Weights weights, int cell, const CellZero& zero)
      : fields_(fields), cells_(fields.cells()), weights_(weights), cell_(cell), best_(zero) {}

  SurfacePoint run() {
    // Each step goes to a deeper zero. So the loop visits no cell twice, and ends.
    bool isDeeper = true;
    while (isDeeper && best_.depth() < kNearEdge) isDeeper = goDeeper();
    return cells_.point(cell_, best_.bary);
  }

 private:
  bool goDeeper() {
    const int cell = cell_;
    bool doubtful[3];
    for (int k = 0; k < 3; ++k) doubtful[k] = isDoubtful(k);
    for (int k = 0; k < 3; ++k) {
      if (doubtful[k]) tryAcross(3 * cell + (k + 1) % 3);
      if (doubtful[(k + 1) % 3] && doubtful[(k + 2) % 3]) tryAround(3 * cell + k);
    }
    return cell_ != cell;
  }

  /// Whether the cell beyond the edge opposite to corner k may also have a zero (isTheOnlyZero).
  bool isDoubtful(int k) const {
    if (best_.bary[k] >= kNearEdge) return false;
    const int i = k == 2 ? 0 : k + 1;
    const int j = k == 0 ? 2 : k - 1;
    const Vec2& a = best_.field.corner[i];
    const Vec2& b = best_.field.corner[j];
    const double sine = cross(a, b);
    return sine * sine <= best_.holonomy * best_.holonomy * a.squaredNorm() * b.squaredNorm();
  }

  void tryCell(int cell) {
    CellZero other;
    if (!fields_.findZero(cell, weights_, other)) return;
    if (other.depth() < -kInsideTolerance || other.depth() <= best_.depth()) return;
    best_ = other;
    cell_ = cell;
  }

  void tryAcross(int h) {
    const int twin = cells_.twin(h);
    if (twin >= 0) tryCell(faceOf(twin));
  }

  void tryAround(int h) {
    for (const int around : cells_.around(h)) {
      if (around != h) tryCell(faceOf(around));
    }
  }

  FieldBlend& fields_;
  const Cells& cells_;
  Weights weights_;
  int cell_;
  CellZero best_;
};

}  // namespace

SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int cell, const CellZero& zero) {
  if (isTheOnlyZero(zero, zero.depth())) return fields.cells().point(cell, zero.bary);
  return DeepestZero(fields, weights, cell, zero).run();
}

}  // namespace karcher

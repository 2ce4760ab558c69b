#include "rcm/deepest_zero.h"

#include <algorithm>

#include "rcm/center_of_mass.h"

namespace karcher {
namespace {

/// Each step goes to a deeper zero: more than two or three only where faces are all slivers.
constexpr int kMostMoves = 8;

class DeepestZero {
 public:
  DeepestZero(FieldBlend& fields, Weights weights, int face, const FaceZero& zero)
      : fields_(fields),
        geometry_(fields.geometry()),
        mesh_(*geometry_.mesh),
        weights_(weights),
        face_(face),
        best_(zero) {}

  SurfacePoint run() {
    for (int step = 0; step < kMostMoves && best_.depth() < kNearEdge; ++step) {
      if (!goDeeper()) break;
    }
    return clampedPoint(face_, best_.bary);
  }

 private:
  bool goDeeper() {
    const int face = face_;
    bool doubtful[3];
    for (int k = 0; k < 3; ++k) doubtful[k] = isDoubtful(k);
    for (int k = 0; k < 3; ++k) {
      if (doubtful[k]) tryAcross(3 * face + (k + 1) % 3);
      if (doubtful[(k + 1) % 3] && doubtful[(k + 2) % 3]) tryAround(3 * face + k);
    }
    return face_ != face;
  }

  /// Whether the face across the edge opposite to corner k may have a zero as well (isTheOnlyZero).
  bool isDoubtful(int k) const {
    if (best_.bary[k] >= kNearEdge) return false;
    const int i = k == 2 ? 0 : k + 1;
    const int j = k == 0 ? 2 : k - 1;
    const Vec2& a = best_.field.corner[i];
    const Vec2& b = best_.field.corner[j];
    const double sine = cross(a, b);
    return sine * sine <= best_.jump * best_.jump * a.squaredNorm() * b.squaredNorm();
  }

  void tryFace(int face) {
    FaceZero other;
    if (!fields_.findZero(face, weights_, other)) return;
    if (other.depth() < -kInsideTolerance || other.depth() <= best_.depth()) return;
    best_ = other;
    face_ = face;
  }

  void tryAcross(int h) {
    const int twin = mesh_.twin[h];
    if (twin >= 0) tryFace(faceOf(twin));
  }

  void tryAround(int h) {
    const int first = mesh_.outgoing[mesh_.tail(h)];
    int around = first;
    do {
      if (around != h) tryFace(faceOf(around));
      around = rotateLeft(mesh_, around);
    } while (around >= 0 && around != first);
  }

  FieldBlend& fields_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Weights weights_;
  int face_;
  FaceZero best_;
};

}  // namespace

SurfacePoint deepestZero(FieldBlend& fields, Weights weights, int face, const FaceZero& zero) {
  if (isTheOnlyZero(zero, zero.depth())) return clampedPoint(face, zero.bary);
  return DeepestZero(fields, weights, face, zero).run();
}

}  // namespace karcher

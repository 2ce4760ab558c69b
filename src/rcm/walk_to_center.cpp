#include <algorithm>
#include <optional>

#include "intrinsic/straightest.h"
#include "rcm/center_of_mass.h"
#include "rcm/deepest_zero.h"

namespace karcher {

const char* statusName(Status status) {
  switch (status) {
    case Status::kConverged:
      return "converged";
    case Status::kIndefinite:
      return "indefinite";
    case Status::kBoundary:
      return "boundary";
    case Status::kNoProgress:
      return "noProgress";
    case Status::kLimit:
      return "limit";
    case Status::kJump:
      return "jump";
    case Status::kBridged:
      return "bridged";
  }
  return "unknown";
}

namespace {

constexpr int kMaxFaces = 400;
constexpr int kMaxLeaps = 60;
constexpr double kLongestLeap = 0.5;  ///< of the bounding box's diagonal
/// A zero whose weights in a face go below this is far away: leap instead of walking there.
constexpr double kFarWeight = -6;

int smallestCorner(const Vec3& b) {
  return b[0] < b[1] ? (b[0] < b[2] ? 0 : 2) : (b[1] < b[2] ? 1 : 2);
}

/// The zero of a face's field; none where the Hessian is not positive definite.
std::optional<FaceZero> zeroOfFace(FieldBlend& fields, Weights weights, int face) {
  FaceZero zero;
  if (!fields.findZero(face, weights, zero)) return std::nullopt;
  return zero;
}

/// The zero among the faces and edges around a vertex: the same answer whichever face the search
/// came from. The vertex itself where each face places its zero in another.
CenterOfMass centerAroundVertex(FieldBlend& fields, Weights weights, int vertex) {
  const TriangleMesh& mesh = *fields.geometry().mesh;
  const int first = mesh.outgoing[vertex];
  bool definite = true;
  double nearest = -kInfinity;
  int h = first;
  do {
    const std::optional<FaceZero> zero = zeroOfFace(fields, weights, faceOf(h));
    definite = definite && zero;
    if (zero) {
      nearest = std::max(nearest, zero->depth());
      if (zero->depth() >= -kInsideTolerance) {
        return {deepestZero(fields, weights, faceOf(h), *zero), Status::kConverged, 0};
      }
    }
    h = rotateLeft(mesh, h);
  } while (h >= 0 && h != first);
  if (!definite) return {vertexPoint(mesh, vertex), Status::kIndefinite, 0};

  // Of zeros between two faces the one that lies farthest from the ends of its edge.
  double farthest = 0;
  SurfacePoint between;
  h = first;
  do {
    const int twin = mesh.twin[h];
    if (twin >= 0) {
      const Vec3 left = zeroOfFace(fields, weights, faceOf(h))->bary;
      const Vec3 right = zeroOfFace(fields, weights, faceOf(twin))->bary;
      const double s = fields.zeroAlongEdge(h, weights);
      if (left[cornerOf(previous(h))] < 0 && right[cornerOf(previous(twin))] < 0 &&
          std::min(s, 1 - s) > farthest) {
        farthest = std::min(s, 1 - s);
        between = edgePoint(h, s);
      }
    }
    h = rotateLeft(mesh, h);
  } while (h >= 0 && h != first);
  if (farthest > 0) return {between, Status::kConverged, 0};

  // The field jumps by a small part of an edge from face to face, no more.
  constexpr double kLargestJump = 0.5;
  const Status status = mesh.onBoundary[vertex]    ? Status::kBoundary
                        : nearest >= -kLargestJump ? Status::kConverged
                                                   : Status::kNoProgress;
  return {vertexPoint(mesh, vertex), status, 0};
}

class ZeroWalk {
 public:
  ZeroWalk(FieldBlend& fields, Weights weights)
      : fields_(fields), geometry_(fields.geometry()), mesh_(*geometry_.mesh), weights_(weights) {}

  /// From a point, with the zero of its face.
  CenterOfMass run(const SurfacePoint& start, const std::optional<FaceZero>& zero) {
    if (zero && zero->depth() >= kFarWeight) return walk(start, zero);
    const SurfacePoint near = leap(start);
    CenterOfMass result = walk(near, zeroOfFace(fields_, weights_, near.face));
    result.iterations += leaps_;
    return result;
  }

 private:
  /// Gradient descent by the natural step, p <- exp_p(sum_i w_i log_p(p_i)), until the zero is
  /// near.
  SurfacePoint leap(SurfacePoint point) {
    while (leaps_ < kMaxLeaps) {
      ++leaps_;
      const TriangleField field = fields_.blend(point.face, weights_);
      // Weights far from 0 and 1 ask for steps that would wind round the surface again and again.
      const Vec2 wanted = -field.at(point.bary) / 2;
      const Vec2 step = wanted * std::min(1.0, kLongestLeap * geometry_.diagonal / wanted.norm());
      const StraightestPath path = traceStraightest(geometry_, point, step);
      point = path.points.back();
      const std::optional<FaceZero> zero = zeroOfFace(fields_, weights_, point.face);
      if (zero && zero->depth() > kFarWeight) break;
      if (step.norm() < 1e-3 * geometry_.meanEdge) break;
    }
    return point;
  }

  /// From a point near the zero, with the zero of its face.
  CenterOfMass walk(const SurfacePoint& start, std::optional<FaceZero> zero) {
    int face = start.face;
    int history[kHistory];
    for (int step = 1; step <= kMaxFaces; ++step) {
      if (step > 1) zero = zeroOfFace(fields_, weights_, face);
      if (!zero) return {face == start.face ? start : centroid(face), Status::kIndefinite, step};
      const int corner = smallestCorner(zero->bary);
      if (zero->bary[corner] >= -kInsideTolerance) {
        return {deepestZero(fields_, weights_, face, *zero), Status::kConverged, step};
      }
      const int h = exitEdge(face, zero->bary, corner);
      const int twin = mesh_.twin[h];
      if (twin < 0) {
        return {edgePoint(h, fields_.zeroAlongEdge(h, weights_)), Status::kBoundary, step};
      }
      const int onward = faceOf(twin);
      if (step > 1 && onward == history[(step - 2) % kHistory]) return betweenFaces(h, step);
      const int known = std::min(step - 1, kHistory);
      if (std::find(history, history + known, onward) != history + known) {
        CenterOfMass result =
            centerAroundVertex(fields_, weights_, mesh_.corner(face, largest(zero->bary)));
        result.iterations = step;
        return result;
      }
      history[(step - 1) % kHistory] = face;
      face = onward;
    }
    return {centroid(face), Status::kLimit, kMaxFaces};
  }

  /// Two faces that each place the zero behind their common edge.
  CenterOfMass betweenFaces(int h, int step) {
    const double s = fields_.zeroAlongEdge(h, weights_);
    if (s > 0 && s < 1) return {edgePoint(h, s), Status::kConverged, step};
    CenterOfMass result =
        centerAroundVertex(fields_, weights_, s > 0 ? mesh_.head(h) : mesh_.tail(h));
    result.iterations = step;
    return result;
  }

  /// The edge behind which the zero lies farthest; an edge of the boundary only where the zero lies
  /// behind no other.
  int exitEdge(int face, const Vec3& zero, int corner) const {
    const int h = 3 * face + (corner + 1) % 3;
    if (mesh_.twin[h] >= 0) return h;
    int best = h;
    double weight = 0;
    for (int k = 0; k < 3; ++k) {
      const int other = 3 * face + (k + 1) % 3;
      if (zero[k] < weight && mesh_.twin[other] >= 0) {
        weight = zero[k];
        best = other;
      }
    }
    return best;
  }

  static int largest(const Vec3& b) {
    return b[0] > b[1] ? (b[0] > b[2] ? 0 : 2) : (b[1] > b[2] ? 1 : 2);
  }

  static SurfacePoint centroid(int face) { return {face, Vec3::Constant(1.0 / 3)}; }

  /// Faces left in the last steps: coming back to one means that the zero lies between faces.
  static constexpr int kHistory = 16;

  FieldBlend& fields_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Weights weights_;
  int leaps_ = 0;
};

}  // namespace

CenterOfMass walkToCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start) {
  // Most samples of a curve lie in the face of the one before, and no other zero is near: all that
  // they need, in one function.
  FaceZero zero;
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

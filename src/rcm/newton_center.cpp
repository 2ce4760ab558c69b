#include <algorithm>

#include "intrinsic/straightest.h"
#include "rcm/paper_method.h"
#include "rcm/walk_to_center.h"

/// Algorithm 1 of C. Mancinelli, E. Puppo, "Computing the Riemannian Center of Mass on Meshes". The
/// paper does not specify the tolerance and the bound on iterations. Nor does it specify how the
/// search continues if no point of a geodesic has a smaller gradient than the start (see goOn).
namespace karcher {
namespace {

constexpr int kMaxIterations = 100;
/// The largest length of the gradient at a zero, relative to the bounding box's diagonal.
constexpr double kGradientTolerance = 1e-10;

struct Candidate {
  SurfacePoint point;
  double gradient = kInfinity;
};

class NewtonSearch {
 public:
  NewtonSearch(FieldBlend& fields, Weights weights, const SurfacePoint& start)
      : fields_(fields),
        geometry_(fields.geometry()),
        mesh_(*geometry_.mesh),
        weights_(weights),
        point_(start),
        crossingsLeft_(mostCrossingsOfSearch(mesh_)) {}

  SearchEnd run() {
    const double tolerance = kGradientTolerance * geometry_.diagonal;
    int iteration = 1;
    for (; iteration <= kMaxIterations && crossingsLeft_ > 0; ++iteration) {
      const TriangleField field = fields_.blend(point_.face, weights_);
      const Hessian h = hessian(geometry_, point_.face, field);
      if (!h.positiveDefinite()) return {point_, Status::kIndefinite, iteration};
      const Vec3 zero = field.zeroDirection();
      const Vec2 gradient = field.at(point_.bary);
      steps_.gradients = {gradient.norm(), steps_.gradients[0], steps_.gradients[1]};
      if (zero.sum() > 0 && zero.minCoeff() >= -kInsideTolerance * zero.sum()) {
        steps_.inside = true;
        return {clampedPoint(point_.face, zero / zero.sum()), Status::kConverged, iteration};
      }
      if (gradient.norm() <= tolerance) return {point_, Status::kConverged, iteration};
      const Candidate best = bestAlongStep(newtonStep(h, gradient), gradient.norm());
      if (best.gradient < gradient.norm()) {
        point_ = best.point;
        facesTried_ = 0;
        turnedFrom_ = -1;
      } else if (!goOn(field, newtonStep(h, gradient))) {
        return {point_, status_, iteration};
      }
    }
    return {point_, Status::kLimit, iteration - 1};
  }

  const NewtonSteps& steps() const { return steps_; }

 private:
  Vec2 newtonStep(const Hessian& h, const Vec2& gradient) const {
    const double determinant = h.xx * h.yy - h.xy * h.xy;
    Vec2 step(-(h.yy * gradient.x() - h.xy * gradient.y()) / determinant,
              -(h.xx * gradient.y() - h.xy * gradient.x()) / determinant);
    const double length = step.norm();
    if (length > geometry_.extent) step *= geometry_.extent / length;
    return step;
  }

  /// Traces the geodesic along the step. The candidates are the geodesic's end and its joints,
  /// where it crosses edges. Returns the candidate with the smallest gradient. `before` is the
  /// gradient at the start.
  Candidate bestAlongStep(const Vec2& step, double before) {
    Candidate best;
    int bestJoint = 0;
    double gradient = before;
    traceStraightest(geometry_, point_, step, fields_.step(), {.maxCrossings = crossingsLeft_});
    const SurfacePath& path = fields_.step().path;
    crossingsLeft_ -= path.points.count() / 2;
    for (int i = 1; i < path.points.count(); ++i) {
      const SurfacePoint& p = path.points[i];
      gradient = fields_.blend(p.face, weights_).at(p.bary).norm();
      if (gradient >= best.gradient) continue;
      best = {p, gradient};
      bestJoint = i;
    }
    ++steps_.traced;
    if (best.gradient >= before) {
      ++steps_.stuck;
    } else if (bestJoint < path.points.count() - 1) {
      ++steps_.shortened;
      if (gradient >= before) ++steps_.needed;
    }
    return best;
  }

  /// Continues if neither the joints nor the end of the geodesic are better than its start. Inside
  /// a face, the search moves to the best point of the step inside the face. On an edge, the search
  /// ends at a zero on the edge if each face has its zero beyond the edge; else it enters the other
  /// face. At a vertex, the search tries the faces around it in turn. Returns false if the search
  /// ends; status_ then has its status.
  bool goOn(const TriangleField& field, const Vec2& step) {
    const PointLocation location = locate(mesh_, point_);
    if (location.simplex == Simplex::kFace) return shortenStep(field, step);
    if (location.simplex == Simplex::kEdge) return crossEdge(location.halfedge);
    return turnAtVertex(location.vertex);
  }

  bool shortenStep(const TriangleField& field, const Vec2& step) {
    const Vec2 x = pointInFace(geometry_, point_);
    const Vec2 here = field.at(point_.bary);
    const Vec2 change = field.at(barycentric(geometry_, point_.face, x + step)) - here;
    const double part = -here.dot(change) / change.squaredNorm();
    const Vec3 bary = barycentric(geometry_, point_.face, x + part * step);
    const bool better = part > 1e-6 && bary.minCoeff() > 0;
    status_ = Status::kNoProgress;
    if (better) point_.bary = bary;
    return better;
  }

  bool crossEdge(int h) {
    const int twin = mesh_.twin[h];
    if (twin < 0) {
      status_ = Status::kBoundary;
      point_ = edgePoint(h, fields_.zeroAlongEdge(h, weights_));
      return false;
    }
    // The two faces have different gradients at the same place, so that a smaller gradient in the
    // other face is no progress.
    const int edge = std::min(h, twin);
    const bool cameBack = facesTried_ > 0 || crossed_ == edge;
    if (cameBack && zeroLiesBehind(h) && zeroLiesBehind(twin)) {
      const SearchEnd between = centerBetween(fields_, weights_, h);
      if (between.status == Status::kConverged) {
        point_ = between.point;
        status_ = between.status;
        return false;
      }
    }
    if (facesTried_ == 0) {
      ++facesTried_;
      crossed_ = edge;
      point_ = edgePoint(twin, point_.bary[cornerOf(h)]);
      return true;
    }
    point_ = edgePoint(h, fields_.zeroAlongEdge(h, weights_));
    status_ = Status::kNoProgress;
    return false;
  }

  bool turnAtVertex(int vertex) {
    int h = 3 * point_.face;
    while (mesh_.tail(h) != vertex) ++h;
    if (turnedFrom_ < 0) turnedFrom_ = h;
    const int left = rotateLeft(mesh_, h);
    const int on = left >= 0 ? left : mesh_.outgoing[vertex];
    status_ = mesh_.onBoundary[vertex] ? Status::kBoundary : Status::kNoProgress;
    point_ = edgePoint(on, 0);
    return ++facesTried_ < kMaxIterations && on != turnedFrom_;
  }

  /// Whether the face of h has the zero of its field on the far side of h.
  bool zeroLiesBehind(int h) {
    const TriangleField field = fields_.blend(faceOf(h), weights_);
    if (!hessian(geometry_, faceOf(h), field).positiveDefinite()) return false;
    const Vec3 zero = field.zeroDirection();
    return zero.sum() > 0 && zero[cornerOf(previous(h))] <= 0;
  }

  FieldBlend& fields_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  Weights weights_;
  SurfacePoint point_;
  int crossingsLeft_;
  NewtonSteps steps_;
  Status status_ = Status::kNoProgress;
  /// The number of faces around the same edge or vertex that the search left without progress.
  int facesTried_ = 0;
  int turnedFrom_ = -1;  ///< the half-edge from the vertex in the first of the faces tried there
  int crossed_ = -1;     ///< the last edge crossed without progress, by its lower half-edge
};

}  // namespace

SearchEnd newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start) {
  NewtonSteps steps;
  return newtonCenter(fields, weights, start, steps);
}

SearchEnd newtonCenter(FieldBlend& fields, Weights weights, const SurfacePoint& start,
                       NewtonSteps& steps) {
  NewtonSearch search(fields, weights, start);
  SearchEnd center = search.run();
  steps = search.steps();
  return center;
}

}  // namespace karcher

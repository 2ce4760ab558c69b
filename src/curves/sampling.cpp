#include "curves/sampling.h"

#include <algorithm>

#include "intrinsic/local_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// Intervals of a segment before any bisection, a control point: fewer would miss a bend between
/// their ends.
constexpr int kIntervalsAPoint = 2;
constexpr int kFewestIntervals = 8;
constexpr int kMostBisections = 15;
/// The samples between which the curve is farthest from the geodesic are not the ones looked at.
constexpr double kGeodesicMargin = 0.7;
/// Bisections where samples do not converge.
constexpr int kMostAtBorder = 8;
constexpr int kMostInside = 2;

double distanceToLine(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (a + s * along - p).norm();
}

class AdaptiveTrace {
 public:
  AdaptiveTrace(SegmentFields& fields, const Basis& basis, Method method, double tolerance)
      : geometry_(fields.blend.geometry()),
        points_(fields.points),
        fields_(fields.blend),
        basis_(basis),
        method_(method),
        tolerance_(tolerance * geometry_.diagonal) {}

  Array<CurveSample> run() {
    samples_.push_back(end(0));
    const CurveSample last = end(1);
    const int intervals = std::max(kFewestIntervals, kIntervalsAPoint * points_.count());
    for (int k = 1; k <= intervals; ++k) {
      const double t = static_cast<double>(k) / intervals;
      const CurveSample next = k == intervals ? last : sample(t, samples_.back());
      refine(CurveSample(samples_.back()), next, 0);
      samples_.push_back(next);
    }
    return std::move(samples_);
  }

 private:
  /// Appends the samples that are needed between two.
  void refine(const CurveSample& from, const CurveSample& to, int bisections) {
    const CurveSample middle = sample((from.t + to.t) / 2, from);
    const int lost = (from.status != Status::kConverged) + (middle.status != Status::kConverged) +
                     (to.status != Status::kConverged);
    const int most = lost == 0 ? kMostBisections : lost < 3 ? kMostAtBorder : kMostInside;
    if (bisections >= most || (lost == 0 && isFine(from, middle, to))) return;
    refine(from, middle, bisections + 1);
    samples_.push_back(middle);
    refine(middle, to, bisections + 1);
  }

  /// Whether the curve keeps to the geodesic: in the middle, and before and after it, since a curve
  /// may cross it there, or bend where it crosses an edge of the mesh.
  bool isFine(const CurveSample& from, const CurveSample& middle, const CurveSample& to) {
    const double limit = kGeodesicMargin * tolerance_;
    if (!findGeodesic(from.point, to.point)) return false;
    if (distanceFromGeodesic(middle.point) > limit) return false;
    const CurveSample before = sample((from.t + middle.t) / 2, from);
    const CurveSample after = sample((middle.t + to.t) / 2, middle);
    return before.status == Status::kConverged && after.status == Status::kConverged &&
           distanceFromGeodesic(before.point) <= limit &&
           distanceFromGeodesic(after.point) <= limit;
  }

  bool findGeodesic(const SurfacePoint& from, const SurfacePoint& to) {
    path_.assign(1, from);
    double length = 0;
    return appendLocalPath(geometry_, from, to, workspace_, path_, length);
  }

  double distanceFromGeodesic(const SurfacePoint& point) {
    const TriangleMesh& mesh = *geometry_.mesh;
    const Vec3 p = position(mesh, point);
    double nearest = kInfinity;
    Vec3 last = position(mesh, path_[0]);
    for (int i = 1; i < path_.count(); ++i) {
      const Vec3 here = position(mesh, path_[i]);
      nearest = std::min(nearest, distanceToLine(p, last, here));
      last = here;
    }
    return nearest;
  }

  CurveSample end(double t) {
    const Array<double> weights = basis_(t);
    return find(t, weights, points_[heaviest(weights)]->point());
  }

  CurveSample sample(double t, const CurveSample& before) {
    const Array<double> weights = basis_(t);
    const bool warm = before.status == Status::kConverged;
    return find(t, weights, warm ? before.point : points_[heaviest(weights)]->point());
  }

  CurveSample find(double t, Weights weights, const SurfacePoint& start) {
    const CenterOfMass center = findCenter(fields_, weights, start, method_);
    return {t, center.point, center.status};
  }

  const Geometry& geometry_;
  const Array<PointField*>& points_;
  FieldBlend& fields_;
  const Basis& basis_;
  Method method_;
  double tolerance_;
  Array<CurveSample> samples_;
  LocalPathWorkspace workspace_;
  Array<SurfacePoint> path_;
};

}  // namespace

void checkTolerance(double tolerance) {
  constexpr double kLeast = 1e-7;
  if (tolerance >= kLeast && tolerance <= 1) return;
  throw Error(
      ErrorCode::kBadArgument,
      "a tolerance is a part of the bounding box, from 1e-7 to 1, not " + inSentence(tolerance));
}

Array<CurveSample> traceAdaptively(SegmentFields& fields, const Basis& basis, Method method,
                                   double tolerance) {
  return AdaptiveTrace(fields, basis, method, tolerance).run();
}

}  // namespace karcher

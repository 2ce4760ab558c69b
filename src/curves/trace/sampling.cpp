#include "curves/trace/sampling.h"

#include <algorithm>

#include "intrinsic/local_path.h"
#include "intrinsic/surface_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// Before any bisection, a segment has this many intervals for each control point. With fewer, a
/// bend between the ends of an interval would be missed.
constexpr int kIntervalsAPoint = 2;
constexpr int kFewestIntervals = 8;
constexpr int kMostBisections = 20;
/// The number of evaluations in an interval: `kLooksAFace` for each face that the geodesic crosses,
/// but at least `kFewestLooks` and at most `kMostLooks`.
constexpr int kLooksAFace = 3;
constexpr int kFewestLooks = 12;
constexpr int kMostLooks = 256;
/// The longest step between two evaluations in different faces, relative to steps of equal length
/// along the geodesic. The function bisects longer steps.
constexpr double kLongestOfSteps = 1.5;
constexpr int kMostHalvings = 4;
/// The largest numbers of bisections where samples do not converge: at the border of such a
/// stretch, and inside it.
constexpr int kMostAtBorder = 8;
constexpr int kMostInside = 2;

Vec3 offLine(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return p - (a + s * along);
}

class AdaptiveTrace {
 public:
  AdaptiveTrace(SegmentFields& fields, const BasisWriter& basis, Method method, double tolerance,
                SamplingWorkspace& workspace, Array<CurveSample>& samples)
      : geometry_(fields.blend.geometry()),
        segment_(fields),
        points_(fields.points),
        fields_(fields.blend),
        basis_(basis),
        method_(method),
        tolerance_(tolerance * geometry_.diagonal),
        samples_(samples),
        workspace_(workspace) {}

  void run(const Array<double>& nodes) {
    samples_.assign(1, fromHeaviest(0));
    const CurveSample last = fromHeaviest(1);
    const int pieces = nodes.count() + 1;
    const int wanted = std::max(kFewestIntervals, kIntervalsAPoint * points_.count());
    const int intervals = std::max((wanted + pieces - 1) / pieces, kIntervalsAPoint);
    double start = 0;
    for (int piece = 0; piece < pieces; ++piece) {
      const double stop = piece + 1 < pieces ? nodes[piece] : 1;
      for (int k = 1; k <= intervals; ++k) {
        const double t = k == intervals ? stop : start + (stop - start) * k / intervals;
        const CurveSample next = t == 1           ? last
                                 : k == intervals ? fromHeaviest(t)
                                                  : sample(t, samples_.back());
        refine(CurveSample(samples_.back()), next, 0);
        samples_.push_back(next);
      }
      start = stop;
    }
  }

 private:
  /// Appends the samples that are needed between two others.
  void refine(const CurveSample& from, const CurveSample& to, int bisections) {
    const CurveSample middle = sample((from.t + to.t) / 2, from);
    const int lost = (from.status != SampleStatus::kConverged) +
                     (middle.status != SampleStatus::kConverged) +
                     (to.status != SampleStatus::kConverged);
    const int most = lost == 0 ? kMostBisections : lost < 3 ? kMostAtBorder : kMostInside;
    if (bisections >= most || samples_.count() >= kMostSamples) return;
    if (lost == 0 && isFine(from, middle, to)) return;
    refine(from, middle, bisections + 1);
    samples_.push_back(middle);
    refine(middle, to, bisections + 1);
  }

  /// A sample, its position, and its offset from the geodesic.
  struct Look {
    CurveSample sample;
    Vec3 position = Vec3::Zero();
    Vec3 off = Vec3::Zero();
  };

  /// Whether the curve stays near the geodesic. Since the curve may bend or jump at edges, the
  /// function evaluates it in each face that the geodesic crosses. Between two evaluations the
  /// curve may deviate further. The function adds the largest change of the deviation from one
  /// evaluation to the next.
  bool isFine(const CurveSample& from, const CurveSample& middle, const CurveSample& to) {
    workspace_.path.points.assign(1, from.point);
    if (!appendLocalPath(geometry_, from.point, to.point, workspace_.strip, workspace_.path.points))
      return false;
    measure(*geometry_.mesh, workspace_.path);
    if (offGeodesic(position(*geometry_.mesh, middle.point)).norm() > tolerance_) return false;
    const int looks =
        std::clamp(kLooksAFace * (workspace_.path.points.count() - 1), kFewestLooks, kMostLooks);
    longestStep_ = kLongestOfSteps * workspace_.path.length() / looks;
    farthest_ = largestChange_ = 0;
    Look before{from, position(*geometry_.mesh, from.point)};
    for (int k = 1; k <= looks; ++k) {
      const Look next = k < looks ? look(from.t + (to.t - from.t) * k / looks, before.sample)
                                  : Look{to, position(*geometry_.mesh, to.point)};
      if (!isFineBetween(before, next, kMostHalvings)) return false;
      before = next;
    }
    return true;
  }

  /// Whether the curve stays near the geodesic between two evaluations. If it moves fast, or the
  /// faces of the evaluations do not meet, it may have crossed another face in between; so the
  /// function bisects the interval.
  bool isFineBetween(const Look& from, const Look& to, int divisions) {
    if (to.sample.status != SampleStatus::kConverged) return false;
    const int face = from.sample.point.face;
    const int onward = to.sample.point.face;
    const bool isLong = (to.position - from.position).norm() > longestStep_;
    if (divisions > 0 && face != onward && (isLong || !haveCommonEdge(face, onward))) {
      const Look middle = look((from.sample.t + to.sample.t) / 2, from.sample);
      return isFineBetween(from, middle, divisions - 1) && isFineBetween(middle, to, divisions - 1);
    }
    farthest_ = std::max(farthest_, to.off.norm());
    largestChange_ = std::max(largestChange_, (to.off - from.off).norm());
    return farthest_ + largestChange_ <= tolerance_;
  }

  bool haveCommonEdge(int face, int other) const {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int twin = geometry_.mesh->twin[h];
      if (twin >= 0 && faceOf(twin) == other) return true;
    }
    return false;
  }

  Look look(double t, const CurveSample& before) {
    Look result{sample(t, before)};
    result.position = position(*geometry_.mesh, result.sample.point);
    result.off = offGeodesic(result.position);
    return result;
  }

  /// The vector in space from the geodesic's nearest point to p.
  Vec3 offGeodesic(const Vec3& p) const {
    const TriangleMesh& mesh = *geometry_.mesh;
    Vec3 nearest = Vec3::Constant(kInfinity);
    Vec3 last = position(mesh, workspace_.path.points[0]);
    for (int i = 1; i < workspace_.path.points.count(); ++i) {
      const Vec3 here = position(mesh, workspace_.path.points[i]);
      const Vec3 off = offLine(p, last, here);
      if (off.squaredNorm() < nearest.squaredNorm()) nearest = off;
      last = here;
    }
    return nearest;
  }

  CurveSample fromHeaviest(double t) {
    if (const SurfacePoint* known = segment_.known(t)) return {t, *known};
    const Array<double>& weights = weightsAt(t);
    return find(t, weights, points_[heaviest(weights)]->point());
  }

  CurveSample sample(double t, const CurveSample& before) {
    const Array<double>& weights = weightsAt(t);
    const bool warm = before.status == SampleStatus::kConverged;
    return find(t, weights, warm ? before.point : points_[heaviest(weights)]->point());
  }

  const Array<double>& weightsAt(double t) {
    basis_(t, workspace_.weights);
    return workspace_.weights;
  }

  CurveSample find(double t, Weights weights, const SurfacePoint& start) {
    const SearchEnd center = findCenter(fields_, weights, start, method_);
    return {t, center.point, sampleStatus(center.status)};
  }

  const Geometry& geometry_;
  const SegmentFields& segment_;
  const Array<PointField*>& points_;
  FieldBlend& fields_;
  const BasisWriter& basis_;
  Method method_;
  double tolerance_;
  Array<CurveSample>& samples_;
  SamplingWorkspace& workspace_;
  // The longest step between evaluations; `isFine` sets it.
  double longestStep_ = 0;
  double farthest_ = 0;
  double largestChange_ = 0;
};

}  // namespace

void checkTolerance(double tolerance) {
  constexpr double kLeast = 1e-7;
  if (tolerance >= kLeast && tolerance <= 1) return;
  throw Error(
      ErrorCode::kBadArgument,
      "a tolerance is a part of the bounding box, from 1e-7 to 1, not " + inSentence(tolerance));
}

void traceAdaptively(SegmentFields& fields, const BasisWriter& basis, const Array<double>& nodes,
                     Method method, double tolerance, SamplingWorkspace& workspace,
                     Array<CurveSample>& samples) {
  AdaptiveTrace(fields, basis, method, tolerance, workspace, samples).run(nodes);
}

}  // namespace karcher

#include "fuzz/polygon_fuzz.h"

#include <algorithm>
#include <sstream>

#include "generators/curve_shapes.h"
#include "generators/random.h"
#include "intrinsic/straightest.h"
#include "intrinsic/strip_path.h"
#include "mesh/error.h"

namespace karcher {
namespace {

constexpr int kSamples = 48;
constexpr double kSame = 1e-9;

SurfacePoint somewhere(const TriangleMesh& mesh, Random& dice) {
  double b1 = dice.uniform();
  double b2 = dice.uniform();
  if (b1 + b2 > 1) {
    b1 = 1 - b1;
    b2 = 1 - b2;
  }
  return clampedPoint(dice.index(mesh.faceCount()), {1 - b1 - b2, b1, b2});
}

SurfacePoint near(const Geometry& geometry, const SurfacePoint& point, double distance,
                  Random& dice) {
  const Vec2 direction = unitVector(2 * kPi * dice.uniform());
  return traceStraightest(geometry, point, distance * (0.3 + dice.uniform()) * direction)
      .path.end();
}

class Fuzz {
 public:
  Fuzz(Surface& surface, int spacing, uint64_t seed, FuzzTally& tally, int levels)
      : surface_(surface),
        geometry_(surface.geometry()),
        mesh_(surface.mesh()),
        spacing_(spacing),
        seed_(seed),
        dice_(seed),
        tally_(tally),
        levels_(levels) {}

  void run() {
    ++tally_.spacings[spacing_].polygons;
    Array<SurfacePoint> points;
    const int count = 4 + dice_.index(4);
    while (points.count() < count) points.push_back(another(points));
    for (const CurveKind kind : kCurveKinds) {
      if (kind == CurveKind::kOwn || (levels_ != 0 && !takesLevels(kind))) continue;
      for (const bool closed : {false, true}) {
        CurveShape shape;
        shape.kind = kind;
        shape.degree = 1 + dice_.index(5);
        shape.centripetal = dice_.index(2) == 0;
        if (kind == CurveKind::kBSpline && !closed && dice_.index(2) == 0) {
          shape.knotRule = KnotRule::kClamped;
        }
        if (closed) shape.closed = true;
        if (kind == CurveKind::kRational) {
          for (int i = 0; i < count; ++i) shape.weights.push_back(0.2 + 4 * dice_.uniform());
        }
        if (kind == CurveKind::kBarycentric) {
          for (int i = 0; i < count; ++i) shape.betas.push_back(0.5 + dice_.uniform());
        }
        try {
          checkShape(shape, count);
        } catch (const Error&) {
          continue;  // these points have no such curve
        }
        name_ = std::string(curveKindName(kind)) + (closed ? ", closed" : "");
        check(shape, points);
      }
    }
  }

 private:
  SurfacePoint another(const Array<SurfacePoint>& points) {
    const double distance = kSpacings[spacing_] * geometry_.diagonal;
    if (distance > 0 && !points.empty()) return near(geometry_, points.back(), distance, dice_);
    // The point must lie on the first point's component.
    for (int tries = 0; tries < 100; ++tries) {
      const SurfacePoint point = somewhere(mesh_, dice_);
      if (points.empty() || component(point) == component(points[0])) return point;
    }
    return points[0];
  }

  int component(const SurfacePoint& point) {
    return surface_.component(mesh_.corner(point.face, 0));
  }

  void fault(const std::string& what) {
    std::ostringstream sentence;
    sentence << "seed " << seed_ << ", spacing " << kSpacings[spacing_] << ", " << name_ << ": "
             << what;
    tally_.faults.push_back(sentence.str());
  }

  void check(const CurveShape& shape, const Array<SurfacePoint>& points) {
    // Every fourth polygon has exact fields, which are cut finer than faces and cost more.
    const Solver solver = seed_ % 4 == 3 ? Solver::kExact : Solver::kFast;
    CurveOptions options = ofLevelZero(shape, kSamples, {Method::kKarcher, solver, 6});
    options.levels = levels_;
    try {
      Curve curve(surface_, options, points);
      checkCurve(curve);
      checkEdits(curve);
    } catch (const std::exception& error) {
      fault(error.what());
    }
  }

  void checkCurve(Curve& curve) {
    FuzzTally::OfSpacing& tally = tally_.spacings[spacing_];
    ++tally.curves;
    for (int j = 0; j < curve.segmentCount(); ++j) {
      for (const Bridge& bridge : curve.bridges(j)) {
        tally.marked += (bridge.t1 - bridge.t0) / curve.segmentCount();
        checkPath(bridge.line.path.points);
        if (!std::is_sorted(bridge.line.t.begin(), bridge.line.t.end()))
          fault("a bridge turns back");
      }
      checkPath(curve.path(j).line.points);
      for (int k = 0; k < curve.piecesPerSegment(); ++k) checkSamples(curve, j, k);
      const int next = j + 1 < curve.segmentCount() ? j + 1 : curve.shape().closed ? 0 : -1;
      if (next >= 0) checkJoin(curve.samples(j).back(), curve.samples(next).front());
    }
  }

  void checkPath(const Array<SurfacePoint>& path) {
    for (int i = 0; i < path.count(); ++i) {
      const SurfacePoint& p = path[i];
      const bool valid = p.face >= 0 && p.face < mesh_.faceCount() && p.bary.minCoeff() >= 0 &&
                         std::abs(p.bary.sum() - 1) <= 1e-12;
      if (!valid) return fault("a point is not on the surface");
      if (i > 0 && !haveCommonFace(mesh_, path[i - 1], p)) return fault("a path leaves its faces");
    }
  }

  void checkJoin(const CurveSample& before, const CurveSample& after) {
    const double gap = (position(mesh_, before.point) - position(mesh_, after.point)).norm();
    tally_.largestJoin = std::max(tally_.largestJoin, gap / geometry_.diagonal);
    if (gap > kSame * geometry_.diagonal) fault("two segments do not meet");
  }

  void checkSamples(Curve& curve, int j, int k) {
    const Curve::Piece& piece = curve.piece(j, k);
    const Array<CurveSample>& samples = piece.samples();
    const Array<Bridge>& bridges = piece.bridges();
    for (const CurveSample& sample : samples) {
      const bool marked = bridgeOver(bridges, sample.t) != nullptr;
      if (sample.status != SampleStatus::kConverged &&
          !(marked && (sample.status == SampleStatus::kBridged ||
                       sample.status == SampleStatus::kSubdivided))) {
        fault(std::string("a sample is ") + statusName(sample.status) + " without a mark");
      }
    }
    if (curve.shape().kind == CurveKind::kPolyline) return;  // shortest paths, by construction
    FieldBlend blend(geometry_, controlFields(curve.fieldsOf(j, k)));
    for (int i = 1; i < samples.count(); ++i) {
      const double middle = (samples[i - 1].t + samples[i].t) / 2;
      if (bridgeOver(bridges, middle) != nullptr) continue;
      ++tally_.steps;
      std::ostringstream where;
      where << "segment " << j << ", piece " << k;
      checkStep(where.str(), piece, blend, samples[i - 1], samples[i]);
    }
  }

  /// Divides a step recursively wherever it is long.
  void checkStep(const std::string& where, const Curve::Piece& piece, FieldBlend& blend,
                 const CurveSample& from, const CurveSample& to) {
    Array<std::pair<CurveSample, CurveSample>> stack;
    stack.emplace_back(from, to);
    for (int divisions = 0; !stack.empty(); ++divisions) {
      const auto [a, b] = stack.back();
      stack.pop_back();
      const double length = (position(mesh_, b.point) - position(mesh_, a.point)).norm();
      if (length <= kLongestStep / 2 * geometry_.meanEdge) continue;
      if (b.t - a.t <= kChainRounding || divisions > 100'000) {
        const double jump = length / geometry_.meanEdge;
        tally_.largestJump = std::max(tally_.largestJump, jump);
        std::ostringstream what;
        what << "a jump of " << jump << " mean edges in " << where << " at t = " << a.t
             << " is not marked, between samples at " << from.t << " and " << to.t;
        if (jump > kLongestStep) return fault(what.str());
        continue;
      }
      const double t = (a.t + b.t) / 2;
      const Array<double> weights = piece.weights(t);
      const SearchEnd center = findCenter(blend, weights, a.point, Method::kKarcher);
      if (center.status != Status::kConverged) {
        ++tally_.lostBetween;
        return;
      }
      const CurveSample middle{t, center.point};
      stack.emplace_back(a, middle);
      stack.emplace_back(middle, b);
    }
  }

  void checkEdits(Curve& curve) {
    for (int edit = 0; edit < 3; ++edit) {
      const int i = dice_.index(curve.pointCount());
      const double distance = std::max(kSpacings[spacing_], 0.01) * geometry_.diagonal;
      const SurfacePoint point = near(geometry_, curve.point(i), distance, dice_);
      const int what = dice_.index(4);
      const bool ownKnots = curve.shape().knotRule == KnotRule::kOwn;
      if (what == 0 && !ownKnots) {
        curve.insertPoint(i, point);
      } else if (what == 1 && curve.pointCount() > 6 && !ownKnots) {
        curve.removePoint(i);
      } else {
        curve.movePoint(i, point);
      }
    }
    checkCurve(curve);
    Curve anew(surface_, curve.value());
    if (anew.segmentCount() != curve.segmentCount()) return fault("edits change the segments");
    for (int j = 0; j < curve.segmentCount(); ++j) {
      const Array<CurveSample>& a = curve.samples(j);
      const Array<CurveSample>& b = anew.samples(j);
      for (int i = 0; i < a.count(); ++i) {
        const double difference =
            (position(mesh_, a[i].point) - position(mesh_, b[i].point)).norm() / geometry_.diagonal;
        tally_.largestEdit = std::max(tally_.largestEdit, difference);
        if (difference > kSame || a[i].status != b[i].status) {
          return fault("an edited curve is not the one traced anew");
        }
      }
    }
  }

  Surface& surface_;
  const Geometry& geometry_;
  const TriangleMesh& mesh_;
  int spacing_;
  uint64_t seed_;
  Random dice_;
  FuzzTally& tally_;
  int levels_;
  std::string name_;
};

}  // namespace

void fuzzPolygon(Surface& surface, int spacing, uint64_t seed, FuzzTally& tally, int levels) {
  Fuzz(surface, spacing, seed, tally, levels).run();
}

}  // namespace karcher
